#include "diagnosis/challenge/nominal_case.h"

#include <algorithm>

#include "core/hertz.h"
#include "core/printed.h"
#include "dem_compare/laws/hertzian_torsion.h"

namespace asperity {
namespace {

std::string body(const char* section, const RecordedBody& body) {
  std::string text = printed("subsection %s\n", section);
  if (body.radius > 0) text += printed("  set Radius = %.10g m\n", body.radius);
  return text + printed("  set Young modulus = %.10g Pa\n  set Poisson ratio = %.10g\nend\n",
                        body.youngs_modulus, body.poissons_ratio);
}

/// Local friction under which Hertz' pressure, of half the largest load, gives the moment of the friction at
/// the particle's radius (hertzian_torsion.h).
double local_friction(const Recording& recording, double at_radius) {
  double largest = 0;
  for (const double force : recording.tables.front().columns.at("normal_force"))
    largest = std::max(largest, force);
  const ElasticBody particle{recording.particle.youngs_modulus, recording.particle.poissons_ratio},
      substrate{recording.substrate.youngs_modulus, recording.substrate.poissons_ratio};
  const Hertz hertz{reduced_modulus(particle, substrate), recording.particle.radius};
  return at_radius * hertz.radius / hertz.contact_radius(largest / 2) / full_slip_torsion_coefficient(1);
}

/// As the recording guesses it; of rolling, which hardly depends on it, a usual one; else 0.
double friction_of(const Recording& recording) {
  constexpr double usual = 0.25;
  if (recording.mode == Motion::rolling) return usual;
  const auto& parameters = recording.simulation.parameters;
  const auto of = [&](const char* name) {
    const auto found = parameters.find(name);
    return found == parameters.end() ? 0 : found->second.value;
  };
  const double sliding = of("sliding_friction");
  return recording.mode == Motion::torsion && sliding == 0 ? local_friction(recording, of("torsion_friction"))
                                                           : sliding;
}

}  // namespace

std::string nominal_case(const Recording& recording) {
  return body("Particle", recording.particle) + body("Substrate", recording.substrate) +
         printed("subsection Interface\n  set Friction coefficient = %.10g\nend\n", friction_of(recording)) +
         "subsection Experiment\n  set Normal load = 100 uN\nend\n";
}

}  // namespace asperity
