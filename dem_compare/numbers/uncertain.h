// Numbers with a standard deviation, carried through formulas to first order (independent inputs).
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace asperity {

/// Both in the unit of the number.
struct Uncertain {
  double value = 0;
  double sd = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known
  /// Of a mean of few values, whose sd Student's factor has widened [-]; formulas take the sd as it is.
  double degrees_of_freedom = std::numeric_limits<double>::infinity();

  bool has_sd() const { return std::isfinite(sd); }
};

/// In quadrature; an unknown sd stays unknown.
Uncertain operator+(const Uncertain& a, const Uncertain& b);
Uncertain operator-(const Uncertain& a, const Uncertain& b);
Uncertain operator*(const Uncertain& a, double factor);
Uncertain ratio(const Uncertain& a, const Uncertain& b);

/// f(inputs); the sd from its slopes at the inputs. Inputs without sd count as exact; none with sd: the
/// result has none.
Uncertain propagate(const std::function<double(const std::vector<double>&)>& f,
                    const std::vector<Uncertain>& inputs);

/// (computed - published) over the published sd; NaN without one.
/// A pure number [-].
double deviation_in_sigma(const Uncertain& computed, const Uncertain& published);
/// The same over both sds, in quadrature.
/// A pure number [-].
double deviation_in_both_sigmas(const Uncertain& computed, const Uncertain& published);

}  // namespace asperity
