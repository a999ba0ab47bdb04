#include "fem/output/effective_values.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "core/residual_imprint.h"
#include "core/shear_moduli.h"
#include "fem/interface/adhesion_law.h"
#include "fem/interface/friction_law.h"
#include "fem/output/steady_motion.h"
#include "fem/solver/load_step_error.h"

namespace asperity::fem {

double largest_size(const std::vector<HistoryRow>& records, double HistoryRow::*column) {
  double largest = 0;
  for (const auto& r : records) largest = std::max(largest, std::abs(r.*column));
  return largest;
}

namespace {

using nlohmann::json;

json number(double value, const char* unit, double sd) {
  return {{"value", value}, {"unit", unit}, {"sd", std::isfinite(sd) ? json(sd) : json(nullptr)}};
}

double root_of_squares(std::initializer_list<double> errors) {
  double sum = 0;
  for (const double e : errors) sum += e * e;
  return std::sqrt(sum);
}

/// Approach that the first unloading leaves; NaN without one.
ResidualImprint imprint_of(const std::vector<HistoryRow>& records, double largest_force) {
  const double noise = 1e-5 * largest_force;  // forces are met to about 1e-6 of the load
  std::size_t peak = 0;
  while (peak + 1 < records.size() && records[peak + 1].normal_force > records[peak].normal_force + noise)
    ++peak;
  std::size_t turn = peak;
  while (turn + 1 < records.size() &&
         std::abs(records[turn + 1].normal_force - records[turn].normal_force) <= noise)
    ++turn;
  std::vector<double> up, up_force, down, down_force;
  for (std::size_t k = 0; k <= peak; ++k)
    if (records[k].normal_force > 0)
      up.push_back(records[k].normal_displacement), up_force.push_back(records[k].normal_force);
  for (std::size_t k = turn; k < records.size(); ++k) {
    if (k > turn && records[k].normal_force >= records[k - 1].normal_force - noise) break;
    down.push_back(records[k].normal_displacement), down_force.push_back(records[k].normal_force);
  }
  return residual_imprint(up, up_force, down, down_force);
}

/// Collects `effective`: values with their standard deviations.
class Effective {
 public:
  /// errors: relative, added in squares.
  void add(const char* name, double value, const char* unit, std::initializer_list<double> errors) {
    add_absolute(name, value, unit, std::abs(value) * root_of_squares(errors));
  }
  void add_absolute(const char* name, double value, const char* unit, double sd) {
    values_[name] = number(value, unit, sd);
  }
  const json& values() const { return values_; }

 private:
  json values_ = json::object();
};

/// The contact at the largest load.
void add_contact(Effective& effective, const HistoryRow& peak, const DiscretisationError& error,
                 const ResultSummary& s) {
  if (s.stiffness.normal > 0)
    effective.add("normal_stiffness", s.stiffness.normal, "N/m", {error.stiffness()});
  if (s.stiffness.lateral > 0)
    effective.add("lateral_stiffness", s.stiffness.lateral, "N/m", {error.lateral_stiffness()});
  if (s.stiffness.torsion > 0)
    effective.add("torsion_stiffness", s.stiffness.torsion, "N m/rad", {error.torsion_stiffness()});
  effective.add("contact_radius", peak.contact_radius, "m", {0.5 * error.area()});
  effective.add("contact_area", peak.contact_area, "m^2", {error.area()});
  effective.add("mean_pressure", peak.mean_pressure, "Pa", {error.area()});
  effective.add("max_pressure", peak.max_pressure, "Pa", {error.largest_pressure()});
  effective.add("pressure_radius", peak.pressure_radius, "m", {error.stiffness()});
  const double approach = root_of_squares({error.approach(), peak.load_step_error});
  effective.add_absolute("approach", peak.mean_plane_approach, "m", approach);
  effective.add_absolute("approach_from_first_touch", peak.normal_displacement, "m",
                         root_of_squares({approach, error.first_touch()}));
  effective.add_absolute("first_touch", peak.mean_plane_approach - peak.normal_displacement, "m",
                         error.first_touch());
  effective.add("spots", peak.spots, "", {error.spots()});
  effective.add_absolute("load_centre_x", peak.load_centre_x, "m", error.load_centre());
  effective.add_absolute("load_centre_y", peak.load_centre_y, "m", error.load_centre());
}

/// Plasticity: extreme stress and strain, yielded volume, residual imprint.
void add_yielding(Effective& effective, const CaseInput& input, const HistoryRow& peak,
                  const std::vector<HistoryRow>& records, const DiscretisationError& error) {
  const HistoryRow& last = records.back();
  if (peak.normal_displacement > 0) {
    const double steps = peak.load_step_error / peak.normal_displacement;
    effective.add("load_step_error", steps, "", {uncertainty_of_load_step_error});
  }
  const ResidualImprint imprint = imprint_of(records, peak.normal_force);
  if (input.experiment.type == Motion::normal && std::isfinite(imprint.depth)) {
    // Without yielding there is no residual imprint; the value that the extrapolation gives is its error.
    const double depth = last.plastic_volume > 0 ? imprint.depth : 0.0;
    const double sd = last.plastic_volume > 0
                          ? root_of_squares({error.plasticity() * depth, peak.load_step_error,
                                             error.unloading(), imprint.error})
                          : 0.0;
    effective.add_absolute("residual_imprint", depth, "m", sd);
  }
  effective.add("particle_von_mises", largest_size(records, &HistoryRow::particle_von_mises), "Pa",
                {error.largest_stress()});
  effective.add("substrate_von_mises", largest_size(records, &HistoryRow::substrate_von_mises), "Pa",
                {error.largest_stress()});
  effective.add("particle_plastic_strain", last.particle_plastic_strain, "",
                {error.largest_plastic_strain()});
  effective.add("substrate_plastic_strain", last.substrate_plastic_strain, "",
                {error.largest_plastic_strain()});
  effective.add("plastic_volume", last.plastic_volume, "m^3", {error.plasticity()});
  effective.add("dissipated_energy", last.dissipated_energy, "J", {error.plasticity()});
}

/// Per angle [N m], of what bodies of two materials dissipate as they roll: the strip that leaves the contact
/// within a step lets go of the shear of their mismatch, up to beta p0, at once, where finer steps let it
/// fade with the pressure. Glass on silicon, steps of a/10 to a/40 against finer ones: smooth, friction 0.5:
/// 0.4 of beta^2 p0^2 s^2 R/E*; 0.1: none; rough at two loads: 0.3 to 0.6.
double error_of_rolling_steps(const CaseInput& input, const HistoryRow& peak, double step) {
  const ElasticBody particle = elastic_body(input.particle), substrate = elastic_body(input.substrate);
  const auto law = make_friction_law(input.interface);
  if (!law) return 0;
  const double highest = 1.5 * peak.normal_force / (M_PI * peak.pressure_radius * peak.pressure_radius),
               shear = std::min(std::abs(dundurs_beta(particle, substrate)) * highest,
                                law->initial_limit(highest).stress);
  return 0.5 * shear * shear * step * step * input.radius / reduced_modulus(particle, substrate);
}

/// Resistances of moving contacts: their fluctuation along the path and their discretisation error.
void add_moving(Effective& effective, const CaseInput& input, const HistoryRow& peak,
                const std::vector<HistoryRow>& records, const DiscretisationError& error) {
  if (input.experiment.type == Motion::program) {  // no part of it is steady
    effective.add("friction_work", records.back().friction_work, "J",
                  {error.resistance(1), records.back().energy_error});
    return;
  }
  const auto add = [&](const char* name, const SteadyResistance& r, const char* unit, double mesh,
                       double floor) {
    effective.add_absolute(name, r.mean, unit, root_of_squares({r.sd, mesh * r.mean, floor}));
  };
  const double noise = rolling_noise * peak.normal_force * peak.pressure_radius;
  if (const auto sliding = steady_sliding(records)) {
    // Friction beyond the law's slope in the pressure of load and attraction force comes from attraction
    // across the contact; a limit that no longer grows with the pressure is proportional to the area.
    const auto law = make_friction_law(input.interface);
    const double pressed = 1 + input.interface.attraction_force / peak.normal_force,
                 by_load =
                     law ? law->initial_limit(std::numeric_limits<double>::infinity()).slope * pressed : 0.0;
    const double by_area = sliding->mean > 0 ? std::clamp(1 - by_load / sliding->mean, 0.0, 1.0) : 1.0;
    add("sliding_friction", *sliding, "", error.resistance(by_area), 0);
  }
  const double dissipated = records.back().dissipated_energy,
               by_bonds = dissipated > 0 ? records.back().adhesion_loss / dissipated : 0,
               of_rolling = error.rolling(std::clamp(by_bonds, 0.0, 1.0));
  if (const auto rolling = steady_rolling(records, input.radius))
    add("rolling_moment", *rolling, "N m", of_rolling, noise);
  if (const auto dissipation = rolling_dissipation(records, input.radius)) {
    effective.add_absolute("rolling_dissipation", dissipation->per_angle, "N m",
                           root_of_squares({of_rolling * dissipation->per_angle, dissipation->unbalanced,
                                            error_of_rolling_steps(input, peak, dissipation->step)}));
    effective.add("rolling_noise_floor", noise, "N m", {0.5});
  }
  if (const auto torsion = steady_torsion(records))
    add("torsion_moment", *torsion, "N m", error.torsion(), 0);
}

/// Relative. Where half-spaces have solved the same separation, the mesh is off by the difference, and by 2 %
/// as on smooth contacts: on 180 rough ones finer half-spaces were within 1.96 times that in 98 %.
double error_of_pull_off(double tension, const DiscretisationError& left, const ResultSummary& summary) {
  const double stated = left.pull_off();
  if (!summary.half_space || !summary.half_space->pull_off) return stated;
  constexpr double smooth_contacts = 0.02;
  return std::min(stated, std::hypot(smooth_contacts, summary.half_space->pull_off->force / tension - 1));
}

}  // namespace

json effective_values(const CaseInput& input, const std::vector<HistoryRow>& records, const HistoryRow& peak,
                      const HistoryRow& least, const DiscretisationError& error,
                      const ResultSummary& summary) {
  Effective effective;
  add_contact(effective, peak, error, summary);
  add_yielding(effective, input, peak, records, error);
  add_moving(effective, input, peak, records, error);
  if (work_of_adhesion(input.interface).opening > 0 && least.normal_force < 0)
    effective.add("pull_off_force", -least.normal_force, "N",
                  {error_of_pull_off(-least.normal_force, error.at(least), summary)});
  return effective.values();
}

}  // namespace asperity::fem
