// One material point, driven by paths of strain.
#pragma once

#include <cmath>

#include "fem/materials/j2_plasticity.h"
#include "tests/support/verification.h"

namespace asperity::test::material_point {

using namespace asperity::fem;
using V = Simd<double>;
using Strain = SymmetricTensor<double>;

inline constexpr double E = 71e9, nu = 0.17, Y = 3e9;

inline J2Material material() {
  J2Material m = J2Material::elastic(E, nu);
  m.yield_stress = Y;
  return m;
}

inline double contract(const Strain& a, const Strain& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}
inline double norm(const Strain& a) { return std::sqrt(contract(a, a)); }

/// One material point; lane 0 of the vector law.
struct Point {
  explicit Point(const J2Material& m) : law(m) {}
  J2Material law;
  PlasticState<V> state{};
  SymmetricTensor<V> stress{};
  J2Tangent<V> tangent{};
  StepTime time{};

  bool strain_to(const Strain& deviator) {
    const J2Material* lane[lanes];
    SymmetricTensor<V> e;
    V shear;
    for (int l = 0; l < lanes; ++l) {
      lane[l] = &law;
      shear[l] = law.shear_modulus;
      for (int c = 0; c < 6; ++c) e[c][l] = deviator[c];
    }
    return return_map(lane, shear, e, state, stress, tangent, time);
  }
  /// Uniaxial stress: the deviator is axial strain times (1, -1/2, -1/2).
  bool stretch_to(double deviatoric_strain) {
    return strain_to({deviatoric_strain, -0.5 * deviatoric_strain, -0.5 * deviatoric_strain, 0, 0, 0});
  }
  double uniaxial_stress() const { return 1.5 * stress[0][0]; }
  double alpha() const { return state.alpha[0]; }
  Strain s() const {
    Strain r;
    for (int c = 0; c < 6; ++c) r[c] = stress[c][0];
    return r;
  }
};

/// Deviatoric part of the axial strain that belongs to a uniaxial stress and plastic strain.
inline double axial_deviator(const J2Material& m, double stress, double plastic) {
  return stress / (3 * m.shear_modulus) + plastic;
}

inline Verified at_a_point(const std::string& quantity, const std::string& source) {
  return {"Material law", quantity, source};
}

}  // namespace asperity::test::material_point
