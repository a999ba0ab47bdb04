// One spring in series with one slider, the kernel of the sliding, rolling and torsion laws (Cundall & Strack
// 1979):
//   q <- q + k dx, cut to |q| <= limit. Rates do not enter; every mode has a limit of its own.
// While the load changes, k does too. Adding k dx alone gives a spring that holds more energy after
// unloading, q^2/(2k) with a smaller k, than was put in: a closed cycle of load and shear can then do work
// (Elata & Berryman 1996). Rescaling q by k/k_before where k decreases (Walton & Braun 1986; Thornton,
// Cummins & Cleary 2013) keeps q^2/k from growing: none can.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

namespace asperity {

enum class ChangingLoad {
  rescale_on_unloading,  ///< q <- q k/k_before where k decreases: creates no energy
  plain,  ///< the increments alone: creates energy in some cycles; for comparison with codes that do so
};

namespace spring_slider_detail {
/// Zero of a number or a vector, and the size of one, in its unit.
template <class Value>
Value zero() {
  if constexpr (std::is_same_v<Value, double>)
    return 0;
  else
    return Value::Zero();
}
/// Size, in the unit of q.
inline double magnitude(double q) { return std::abs(q); }
inline double magnitude(const Eigen::Vector3d& q) { return q.norm(); }
}  // namespace spring_slider_detail

/// Force or moment of the spring.
template <class Value>
struct SpringSlider {
  Value resistance = spring_slider_detail::zero<Value>();  ///< what the displaced body is held back with
  double stiffness = 0;  ///< of the spring at that load, in units of resistance over displacement
  bool yields = false;

  /// The next value of a history that ended in `before`; `limit` <= 0 is no resistance at all.
  /// Units: those of the resistance and the displacement.
  static SpringSlider advance(const SpringSlider& before, double stiffness, const Value& increment,
                              double limit, ChangingLoad rule) {
    SpringSlider now = before;
    now.stiffness = stiffness;
    now.yields = false;
    if (rule == ChangingLoad::rescale_on_unloading && stiffness < before.stiffness)
      now.resistance *= stiffness / before.stiffness;
    now.resistance += stiffness * increment;
    const double size = spring_slider_detail::magnitude(now.resistance);
    if (size > limit) {
      now.yields = true;
      now.resistance *= limit > 0 ? limit / size : 0.0;
    }
    return now;
  }
};

}  // namespace asperity
