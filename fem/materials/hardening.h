// How the yield stress of a body grows with its plastic strain, and with the rate of that: isotropic
// hardening of von Mises' surface. A law is one class in one file of hardening/, which also declares it
// (material_law.h). The return map is the same for all of them (j2_plasticity.h).
#pragma once

namespace asperity::fem {

/// Of a step that is solved for (InterfacePoint says what time is).
struct StepTime {
  double time = 0;  ///< at its end [s]
  double step = 1;  ///< length of the step [s]
};

/// A point that yields, at the end of a step.
struct YieldingPoint {
  double initial;    ///< yield stress without plastic strain [Pa]
  double alpha;      ///< equivalent plastic strain [-]
  double increment;  ///< of it in this step; over time.step its rate [-]
  StepTime time;
};

/// The yield stress at a point, and its tangent.
struct FlowStress {
  double stress;  ///< uniaxial yield stress [Pa]
  double slope;   ///< its change with the increment of the equivalent plastic strain in this step [Pa], above
                  ///< -3 G - H_kin
};

class Hardening {
 public:
  virtual ~Hardening() = default;
  /// The initial yield stress where alpha and increment are 0. Newton's iteration of the return map needs it
  /// concave in the increment.
  virtual FlowStress flow(const YieldingPoint& point) const = 0;
  /// Energy stored per volume, of the integral of the growth of the yield stress over alpha what is not
  /// dissipated [J/m^3].
  virtual double stored_energy(double alpha) const = 0;
  /// The yield stress is linear in the increment.
  virtual bool is_linear() const { return false; }
};

}  // namespace asperity::fem
