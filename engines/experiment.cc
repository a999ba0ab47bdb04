#include "engines/experiment.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/nearest_name.h"

namespace asperity {
namespace {

const std::vector<std::pair<std::string, Motion>>& type_names() {
  static const std::vector<std::pair<std::string, Motion>> names{{"glued", Motion::sliding},
                                                                 {"rolling", Motion::rolling},
                                                                 {"rail", Motion::rail},
                                                                 {"twisting", Motion::torsion}};
  return names;
}

/// Springs that resist the rotation phi of the free sphere, and the angles at which the first and the last of
/// them yield.
struct RotationSprings {
  double stiffness = 0;                    ///< [N m/rad]
  double limit = 0;                        ///< torque when all have yielded [N m]
  double first_yield = 0, last_yield = 0;  ///< [rad]
};

RotationSprings rotation_springs(const EngineExperiment& e) {
  const double c = e.rail_cosine(), s = std::sqrt(std::max(0.0, 1 - c * c));
  const double K_i = e.indenter.rolling_stiffness_at(e.indenter_load()),
               M_i = e.indenter.rolling_limit(e.indenter_load());
  const double K_s = e.substrate.rolling_stiffness_at(e.load), M_s = e.substrate.rolling_limit(e.load);
  const double yield_i = M_i / K_i, yield_s = M_s / (K_s * c);
  if (e.type == Motion::rolling)
    return {K_i + K_s, M_i + M_s, std::min(yield_i, yield_s), std::max(yield_i, yield_s)};
  // Each slope sees phi cos(theta) as rolling and phi sin(theta) as torsion; eq:torsion of the paper for the
  // limits.
  const double K_t = e.substrate.torsion_stiffness_at(e.load), M_t = e.substrate.torsion_limit(e.load);
  const double yield_t = M_t / (K_t * s);
  return {K_i + 2 * c * c * K_s + 2 * s * s * K_t, M_i + 2 * c * M_s + 2 * s * M_t,
          std::min({yield_i, yield_s, yield_t}), std::max({yield_i, yield_s, yield_t})};
}

/// Free sphere: plate, rotation and substrate springs in series. With f the force at the plate, x the
/// sphere's way and k the lateral springs: R(1 + c) f = K phi, x = R c phi + f/k_s, X = x + R phi + f/k_i, c
/// = cos(theta), k_s of all slopes.
ClosedForm free_sphere(const EngineExperiment& e) {
  const double c = e.rail_cosine(), R = e.substrate.particle.radius, lever = R * (1 + c);
  const int slopes = e.type == Motion::rail ? 2 : 1;
  const RotationSprings springs = rotation_springs(e);
  ClosedForm form;
  const double sliding = 1 / (slopes * e.substrate.lateral_stiffness_at(e.load)) +
                         1 / e.indenter.lateral_stiffness_at(e.indenter_load());
  const double compliance = lever * lever / springs.stiffness + sliding;
  form.slope = 1 / compliance;
  form.first_yield = springs.stiffness * springs.first_yield / lever * compliance;
  form.plateau = springs.limit / lever;
  form.full_yield = lever * springs.last_yield + sliding * form.plateau;
  form.rotation = 1 / lever;
  form.rolling_stiffness = springs.stiffness;
  return form;
}

}  // namespace

double EngineExperiment::rail_cosine() const { return type == Motion::rail ? std::cos(rail_angle) : 1; }

double EngineExperiment::indenter_load() const {
  return type == Motion::rail ? 2 * rail_cosine() * load : load;
}

Motion engine_experiment_type(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [known, type] : type_names()) {
    if (known == name) return type;
    names.push_back(known);
  }
  throw InputError("there is no experiment '" + name + "'; " + did_you_mean(name, names));
}

std::string engine_experiment_name(Motion type) {
  for (const auto& [name, known] : type_names())
    if (known == type) return name;
  return "";
}

ClosedForm closed_form(const EngineExperiment& e) {
  ClosedForm form;
  switch (e.type) {
    case Motion::sliding:
      form.slope = e.substrate.lateral_stiffness_at(e.load);
      form.plateau = e.substrate.sliding_limit(e.load);
      form.first_yield = form.plateau / form.slope;
      break;
    case Motion::torsion:
      form.slope = e.substrate.torsion_stiffness_at(e.load);
      form.plateau = e.substrate.torsion_limit(e.load);
      form.first_yield = form.plateau / form.slope;
      break;
    case Motion::rolling:
    case Motion::rail:
      form = free_sphere(e);
      break;
    case Motion::normal:
    case Motion::program:
      break;  // no experiment of one particle
  }
  if (form.full_yield == 0) form.full_yield = form.first_yield;
  form.approach = e.substrate.hertz().approach(e.load);
  return form;
}

}  // namespace asperity
