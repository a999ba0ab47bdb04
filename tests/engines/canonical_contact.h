// The pair of bodies on which engines are compared: borosilicate sphere, R = 8.5 um, on silicon (Table 1 of
// the paper).
#pragma once

#include <filesystem>
#include <limits>
#include <string>

#include "engines/parameters/contact_parameters.h"

namespace asperity::test {

/// A file of the paper's runs that ships.
inline std::filesystem::path paper_run(const std::string& name) {
  return std::filesystem::path(__FILE__).parent_path().parent_path().parent_path() / "runs/paper" / name;
}

/// E*, G* as in the engine notes; stiffness of rolling and torsion as in the paper, 8 G* a r^2; no offsets.
inline ContactParameters canonical_contact(double reduced_modulus = 52.8684e9,
                                           double reduced_shear_modulus = 11.7989e9) {
  ContactParameters p;
  p.file = "canonical";
  p.particle = {"borosilicate", 8.5e-6, 71e9, 0.17, 2230};
  p.target = {"silicon", std::numeric_limits<double>::infinity(), 179e9, 0.25,
              std::numeric_limits<double>::quiet_NaN()};
  p.reduced_modulus = EffectiveQuantity{reduced_modulus};
  p.reduced_shear_modulus = EffectiveQuantity{reduced_shear_modulus};
  p.sliding_friction = EffectiveQuantity{0.23};
  p.rolling_friction = EffectiveQuantity{5.304e-3};
  p.rolling_friction->length_scale = LengthScale::particle_radius;
  p.torsion_friction = EffectiveQuantity{0.0056};
  p.torsion_friction->length_scale = LengthScale::particle_radius;
  EffectiveQuantity stiffness;
  stiffness.length_scale = LengthScale::contact_radius;
  stiffness.at_load = 1e-4;
  stiffness.value = p.lateral_stiffness_at(1e-4) * p.particle.radius * p.particle.radius;
  p.rolling_stiffness = p.torsion_stiffness = stiffness;
  return p;
}

/// The same sphere under the diamond indenter.
inline ContactParameters canonical_indenter() {
  ContactParameters p = canonical_contact(68.7268e9, 15.6407e9);
  p.target.material = "diamond";
  p.target.youngs_modulus = 1140e9;
  p.target.poissons_ratio = 0.07;
  return p;
}

}  // namespace asperity::test
