// Does the moment of a rolling or spinning contact, M = mu lambda (f + h), follow the particle's radius or
// that of the contact? Two looks at the same moments: exponents in load and radius, and odds between both
// laws with h left free (derive/length_choice.h). An offset h bends the first (M grows less than with the
// power of the load), so only the odds decide; exponents in the radius, which h leaves alone, and a misfit of
// the law can contradict them. SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dem_compare/derive/length_choice.h"
#include "dem_compare/resistance/moving_study.h"
#include "dem_compare/resistance/trend.h"

namespace asperity {

/// An exponent beside what both lengths predict (without h).
struct ScalingExponent {
  std::string over;  ///< "load" or "radius"
  std::string what;  ///< which cases
  Trend exponent;    ///< its slope
  double with_radius = 0, with_contact = 0;
  /// Of bonds that cost dw more to open than they give, along the rim of a smooth contact: 2 a r dw per
  /// angle. No law of the paper's form; NaN for torsion.
  double with_bonds = 0;
  /// Distances in standard deviations; NaN where unknown.
  double from_radius() const { return (exponent.slope.value - with_radius) / exponent.slope.sd; }
  double from_contact() const { return (exponent.slope.value - with_contact) / exponent.slope.sd; }
  double from_bonds() const { return (exponent.slope.value - with_bonds) / exponent.slope.sd; }
};

struct LengthAnswer {
  enum class Verdict { cannot_tell, particle_radius, contact_radius, neither };
  const MotionMode* mode = nullptr;
  std::string contact;        ///< its label; with others of other radii
  std::vector<double> radii;  ///< of the particle [m]
  std::vector<ScalingExponent> exponents;
  std::optional<LengthChoice> choice;  ///< with two contacts (loads or radii) or more
  Verdict verdict = Verdict::cannot_tell;

  /// What the exponents alone say, that is with h = 0.
  Verdict without_offset() const;
};

/// Of rolling and torsion, each contact with two loads or more, with those that differ from it by the
/// particle's radius alone.
std::vector<LengthAnswer> length_answers(const MovingStudy& study);

}  // namespace asperity
