// Von Mises (J2) plasticity at small strain, associated flow, radial return; isotropic hardening by a law of
// its own (hardening.h) and linear kinematic hardening (Prager), perfectly plastic included.
//
// Yield: f = sqrt(3/2) |s - beta| - sigma_y(alpha) <= 0,
// back stress beta = (2/3) H_kin e_p, alpha = equivalent plastic strain. Source: Simo & Hughes (1998),
// Computational Inelasticity, boxes 3.1 and 3.2 (return map and consistent tangent). Stresses in Pa.
#pragma once

#include <cmath>
#include <limits>
#include <memory>

#include "fem/cells/hex_kernel.h"
#include "fem/cells/step_failure.h"
#include "fem/materials/hardening.h"
#include "fem/materials/relaxation.h"

namespace asperity::fem {

/// Constants of one body.
struct J2Material {
  double shear_modulus = 0, bulk_modulus = 0;                     ///< [Pa]
  double yield_stress = std::numeric_limits<double>::infinity();  ///< initial one [Pa]
  double kinematic_modulus = 0;                                   ///< H_kin [Pa]
  std::shared_ptr<const Hardening> hardening;                     ///< null: none but the kinematic one
  Relaxation relaxation;

  /// From E [Pa] and nu [-].
  static J2Material elastic(double youngs_modulus, double poisson_ratio) {
    J2Material material;
    material.shear_modulus = youngs_modulus / (2 * (1 + poisson_ratio));
    material.bulk_modulus = youngs_modulus / (3 * (1 - 2 * poisson_ratio));
    return material;
  }
  bool can_yield() const { return std::isfinite(yield_stress); }
  bool is_inelastic() const { return can_yield() || relaxation.is_there(); }
  /// alpha: at the end of a step that made the last `increment` of it.
  /// alpha and increment [-].
  FlowStress flow(double alpha, double increment, const StepTime& time) const {
    return hardening ? hardening->flow({yield_stress, alpha, increment, time}) : FlowStress{yield_stress, 0};
  }
  /// Before a step yields.
  /// alpha [-]; the result in [Pa].
  double flow_stress(double alpha, const StepTime& time = {}) const {
    return alpha == 0 ? yield_stress : flow(alpha, 0, time).stress;
  }
  bool hardens_linearly() const { return !hardening || hardening->is_linear(); }
  /// Energy stored by isotropic hardening per volume [J/m^3]. What the back stress stores, beta : e_p / 2 =
  /// H_kin |e_p|^2 / 3, is not in it.
  double isotropic_energy(double alpha) const { return hardening ? hardening->stored_energy(alpha) : 0; }
};

/// History of one point in each of eight cells.
template <typename V>
struct PlasticState {
  SymmetricTensor<V> strain{};  ///< plastic strain e_p or, where the body relaxes, viscous one (deviatoric)
  V alpha{};                    ///< equivalent plastic strain
};

/// Consistent tangent of the deviatoric stress: ds = 2G (theta de - theta_bar n (n : de)).
template <typename V>
struct J2Tangent {
  V theta, theta_bar;
  SymmetricTensor<V> normal;
};

/// a : b.
template <typename V>
inline V double_contraction(const SymmetricTensor<V>& a, const SymmetricTensor<V>& b) {
  using Number = std::decay_t<decltype(a[0][0])>;
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + Number(2) * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// Plastic multiplier (increment of alpha) that returns a trial stress q = sqrt(3/2)|s_trial - beta| to the
/// surface. Throws StepFailure where none is found.
/// q [Pa], alpha and the result [-].
inline double return_to_yield_surface(const J2Material& m, double q, double alpha, const StepTime& time) {
  const double stiff = 3 * m.shear_modulus + m.kinematic_modulus;
  const FlowStress first = m.flow(alpha, 0, time);
  double increment = (q - first.stress) / (stiff + first.slope);
  if (m.hardens_linearly()) return increment;
  for (int i = 0; i < 50;
       ++i) {  // Newton: the flow stress is concave, so it converges monotonically from here
    const FlowStress flow = m.flow(alpha + increment, increment, time);
    const double error = q - stiff * increment - flow.stress;
    increment += error / (stiff + flow.slope);
    if (std::abs(error) < 1e-12 * m.yield_stress) return increment;
  }
  // Far beyond yield, rounding leaves more than that.
  const double left = q - stiff * increment - m.flow(alpha + increment, increment, time).stress;
  if (!(std::abs(left) <= 1e-12 * q))
    throw StepFailure(
        "the return map found no plastic strain that brings a stress back to the yield surface");
  return increment;
}

/// Returns the deviatoric stress for a deviatoric strain; updates `state` and fills `tangent` where a lane
/// yields. materials[l] belongs to lane l. The result says whether any lane yields in this step.
inline bool return_map(const J2Material* const* materials, const Simd<double>& shear_modulus,
                       const SymmetricTensor<Simd<double>>& strain_deviator,
                       PlasticState<Simd<double>>& state, SymmetricTensor<Simd<double>>& stress,
                       J2Tangent<Simd<double>>& tangent, const StepTime& time = {}) {
  using V = Simd<double>;
  SymmetricTensor<V> relative;
  V kinematic;
  for (int l = 0; l < lanes; ++l) kinematic[l] = materials[l]->kinematic_modulus;
  for (int c = 0; c < 6; ++c) {
    stress[c] = 2.0 * shear_modulus * (strain_deviator[c] - state.strain[c]);
    relative[c] = stress[c] - kinematic * (2.0 / 3.0) * state.strain[c];
  }
  tangent.theta = V{} + 1.0;
  tangent.theta_bar = V{};
  const V norm = square_root(double_contraction(relative, relative));
  bool yields = false;
  V increment = V{};
  for (int l = 0; l < lanes; ++l) {
    const J2Material& m = *materials[l];
    const double q = std::sqrt(1.5) * norm[l];
    if (!(q > m.flow_stress(state.alpha[l], time))) continue;
    yields = true;
    increment[l] = return_to_yield_surface(m, q, state.alpha[l], time);
    const double slope =
        m.flow(state.alpha[l] + increment[l], increment[l], time).slope + m.kinematic_modulus;
    tangent.theta[l] = 1 - 3 * m.shear_modulus * increment[l] / q;
    tangent.theta_bar[l] = 1 / (1 + slope / (3 * m.shear_modulus)) - (1 - tangent.theta[l]);
  }
  if (!yields) {
    tangent.normal = {};
    return false;
  }
  for (int c = 0; c < 6; ++c) {
    V direction = relative[c];
    for (int l = 0; l < lanes; ++l) direction[l] = norm[l] > 0 ? direction[l] / norm[l] : 0.0;
    tangent.normal[c] = direction;
    const V flow = increment * std::sqrt(1.5) * direction;
    state.strain[c] += flow;
    stress[c] -= 2.0 * shear_modulus * flow;
  }
  state.alpha += increment;
  return true;
}

}  // namespace asperity::fem
