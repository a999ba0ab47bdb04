#include "diagnosis/mechanics/lateral_limit.h"

#include <cmath>

namespace asperity {
namespace {

double contact_radius(double modulus, double radius, double force) {
  return force > 0 ? std::cbrt(0.75 * force * radius / modulus) : 0;
}

/// At a plate on top and two slopes below; at the plate's forces.
double rolling_limit(const Mechanics& mechanics, const Sample& sample, double coefficient,
                     double plate_force) {
  const LateralMechanics& lateral = mechanics.lateral;
  const Experiment& e = mechanics.experiment;
  const double offset = offset_at(lateral, sample);
  const double cosine = std::cos(sample.rail_angle), sine = std::sin(sample.rail_angle);
  const double slope_force = plate_force / (2 * cosine);
  double above = 1, below = 1;  // lambda/r
  if (lateral.length == LengthScale::contact_radius) {
    above =
        contact_radius(reduced_modulus(e.particle, e.indenter), sample.radius, plate_force) / sample.radius;
    // On a plane the two "slopes" are one contact that bears all.
    const double borne = sample.rail_angle == 0 ? plate_force : slope_force;
    below = contact_radius(e.reduced_modulus(), sample.radius, borne) / sample.radius;
  }
  const double slopes = sample.rail_angle == 0 ? 1 : 2;
  const double share = sample.rail_angle == 0 ? plate_force : slope_force;
  return (coefficient * above * (plate_force + offset) +
          slopes * below * (coefficient * cosine + lateral.torsion_coefficient * sine) * (share + offset)) /
         (1 + cosine);
}

}  // namespace

double hertz_radius(const Mechanics& mechanics, const Sample& sample) {
  return contact_radius(mechanics.geometry.reduced_modulus, sample.radius, sample.normal_force);
}

double attracted_radius(const Mechanics& mechanics, const Sample& sample) {
  const double h = mechanics.experiment.mode == Motion::sliding ? offset_at(mechanics.lateral, sample) : 0;
  return contact_radius(mechanics.geometry.reduced_modulus, sample.radius, sample.normal_force + h);
}

double lateral_limit(const Mechanics& mechanics, const Sample& sample, double coefficient,
                     bool at_substrate) {
  const LateralMechanics& lateral = mechanics.lateral;
  const double offset = offset_at(lateral, sample);
  switch (mechanics.experiment.mode) {
    case Motion::rolling:
      return rolling_limit(mechanics, sample, coefficient, sample.normal_force);
    case Motion::rail: {
      if (!at_substrate) return rolling_limit(mechanics, sample, coefficient, sample.normal_force);
      return rolling_limit(mechanics, sample, coefficient,
                           2 * std::cos(sample.rail_angle) * sample.normal_force) /
             2;
    }
    case Motion::torsion: {
      const double lever =
          lateral.length == LengthScale::contact_radius ? hertz_radius(mechanics, sample) / sample.radius : 1;
      return coefficient * lever * (sample.normal_force + offset);
    }
    default:
      break;
  }
  if (lateral.follows_area) {
    const double a = attracted_radius(mechanics, sample);
    return coefficient * M_PI * a * a;
  }
  return coefficient * (sample.normal_force + offset);
}

}  // namespace asperity
