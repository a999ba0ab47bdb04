// A contact of two elastic bodies with the laws the paper assumes (Fuchs, Weinhart et al. 2014, sec. 3.2):
// Hertz with a constant attraction; Mindlin without slip or with partial slip; rolling and torsion with the
// tangential spring, K = 8 G* a lambda r. G* is computed with 2 - nu (the printed 2 - nu^2 is a slip of the
// pen). SI units.
#pragma once

#include "core/shear_moduli.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"
#include "dem_compare/motion/contact_model.h"

namespace asperity {

struct FrictionOfMode {
  double coefficient = 0;                             ///< mu [-]
  double adhesion_force = 0;                          ///< h [N]
  LengthScale length = LengthScale::particle_radius;  ///< of rolling and torsion
};

struct StandardContact {
  ElasticBody particle, plane;
  double radius = 0;          ///< R [m]
  double adhesion_force = 0;  ///< h of the normal law [N]
  FrictionOfMode sliding, rolling, torsion;
  bool partial_slip = false;  ///< Mindlin and Deresiewicz instead of Mindlin
  LeverArm lever = LeverArm::distance_to_contact;
  HistorySpin history_spin =
      HistorySpin::other_body;  ///< the paper's: histories do not turn on a plane at rest
};

inline ContactModel model_of(const StandardContact& contact) {
  const double shear = reduced_shear_modulus(contact.particle, contact.plane);
  const RotationalStiffness stiffness{RotationalStiffness::Kind::tangential_spring, shear};
  const CoulombLimit friction{contact.sliding.coefficient, contact.sliding.adhesion_force};
  ContactModel model;
  model.normal =
      HertzOffset{reduced_modulus(contact.particle, contact.plane), contact.radius, contact.adhesion_force};
  if (contact.partial_slip)
    model.sliding = MindlinDeresiewicz{shear, contact.radius, friction};
  else
    model.sliding = Mindlin{shear, friction};
  const auto &rolling = contact.rolling, &torsion = contact.torsion;
  model.rolling = RollingResistance{rolling.coefficient, rolling.adhesion_force, rolling.length, stiffness};
  model.torsion = TorsionResistance{torsion.coefficient, torsion.adhesion_force, torsion.length, stiffness};
  model.lever = contact.lever;
  model.history_spin = contact.history_spin;
  return model;
}

}  // namespace asperity
