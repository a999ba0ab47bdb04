#include "fem/output/result_file.h"

#include <deal.II/base/config.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fem/output/steady_motion.h"

namespace asperity::fem {
namespace {

using nlohmann::json;

json number(double value, const char* unit, double sd) {
  return {{"value", value}, {"unit", unit}, {"sd", std::isfinite(sd) ? json(sd) : json(nullptr)}};
}

const char* name_of(ExperimentInput::Type type) {
  switch (type) {
    case ExperimentInput::Type::sliding: return "sliding";
    case ExperimentInput::Type::rolling: return "rolling";
    case ExperimentInput::Type::torsion: return "torsion";
    case ExperimentInput::Type::program: return "program";
    default: return "normal";
  }
}

json body_inputs(const BodyInput& body) {
  return {{"youngs_modulus", body.youngs_modulus},
          {"poissons_ratio", body.poisson_ratio},
          {"yield_stress", std::isfinite(body.yield_stress) ? json(body.yield_stress) : json("inf")},
          {"hardening_modulus", body.hardening_modulus},
          {"hardening", body.hardening == BodyInput::Hardening::kinematic ? "kinematic" : "isotropic"},
          {"voce_saturation", body.voce_saturation},
          {"voce_rate", body.voce_rate},
          {"topography", body.topography}};
}

/// What of a body's roughness the mesh resolves.
json resolved_roughness(const MeshedRoughness& r) {
  if (!r.rough()) return nullptr;
  const auto finite = [](double value) { return std::isfinite(value) ? json(value) : json(nullptr); };
  return {{"shortest_wave", finite(r.scales.shortest_wave)},
          {"cells_over_shortest_wave", finite(r.cells_per_wave())},
          {"slope_variance_in_shorter_waves", r.scales.unresolved},
          {"rms_slope", r.fidelity.rms_slope},
          {"missed_by_facets", {{"rms_height", r.fidelity.missed_height_share()}, {"slope_variance", r.fidelity.missed_slope_share()}}},
          {"repeats_every", r.scales.period < r.region ? json(r.scales.period) : json(nullptr)}};
}

}  // namespace

std::string result_json(const CaseInput& input, const CaseSetup& setup, const std::vector<StepRecord>& records, const ResultSummary& s) {
  const auto peak = std::max_element(records.begin(), records.end(), [](const auto& a, const auto& b) { return a.normal_force < b.normal_force; });
  const StepRecord& last = records.back();
  const double spacing = setup.system.mesh.sizes.spacing_particle;
  // Half a spacing of doubt in the contact radius, evenly distributed: relative standard deviation h / (2 sqrt(3) a).
  const double radius_sd = spacing / (2 * std::sqrt(3.0)), relative = peak->contact_radius > 0 ? radius_sd / peak->contact_radius : 0;
  double force = 0, moment = 0, energy = 0;
  for (const auto& r : records) {
    force = std::max(force, std::abs(r.force_error));
    moment = std::max(moment, std::abs(r.moment_error));
    energy = std::max(energy, std::abs(r.energy_error));
  }
  json effective;
  if (s.stiffness_at_peak > 0) effective["normal_stiffness"] = number(s.stiffness_at_peak, "N/m", relative * s.stiffness_at_peak);
  if (s.lateral_stiffness > 0) effective["lateral_stiffness"] = number(s.lateral_stiffness, "N/m", relative * s.lateral_stiffness);
  if (s.torsion_stiffness > 0) effective["torsion_stiffness"] = number(s.torsion_stiffness, "N m/rad", 3 * relative * s.torsion_stiffness);
  const bool moves_as_written = input.experiment.type == ExperimentInput::Type::program;  // steady in nothing
  if (moves_as_written) effective["friction_work"] = number(last.friction_work, "J", NAN);
  const std::vector<StepRecord> single = moves_as_written ? std::vector<StepRecord>{} : records;
  if (const auto sliding = steady_sliding(single)) effective["sliding_friction"] = number(sliding->mean, "", sliding->sd);
  if (const auto rolling = steady_rolling(single, input.radius)) effective["rolling_moment"] = number(rolling->mean, "N m", rolling->sd);
  if (const auto dissipation = rolling_dissipation(single, input.radius)) {
    effective["rolling_dissipation"] = number(*dissipation, "N m", NAN);
    effective["rolling_noise_floor"] = number(rolling_noise * peak->normal_force * peak->contact_radius, "N m", NAN);
  }
  if (const auto torsion = steady_torsion(single)) effective["torsion_moment"] = number(torsion->mean, "N m", torsion->sd);
  if (input.interface.work_of_adhesion > 0) {
    const auto least = std::min_element(records.begin(), records.end(), [](const auto& a, const auto& b) { return a.normal_force < b.normal_force; });
    if (least->normal_force < 0) effective["pull_off_force"] = number(-least->normal_force, "N", NAN);
  }
  effective["contact_radius"] = number(peak->contact_radius, "m", radius_sd);
  effective["contact_area"] = number(peak->contact_area, "m^2", 2 * relative * peak->contact_area);
  effective["max_pressure"] = number(peak->max_pressure, "Pa", NAN);
  effective["mean_pressure"] = number(peak->mean_pressure, "Pa", 2 * relative * peak->mean_pressure);
  effective["approach"] = number(peak->normal_displacement, "m", NAN);
  effective["plastic_volume"] = number(last.plastic_volume, "m^3", NAN);
  effective["dissipated_energy"] = number(last.dissipated_energy, "J", NAN);
  const json result{
      {"format", "asperity-result/1"},
      {"title", input.title},
      {"experiment", name_of(input.experiment.type)},
      {"inputs_sha256", s.provenance.inputs_sha256},
      {"commit", s.provenance.commit},
      {"inputs",
       {{"case", input.file},
        {"particle", body_inputs(input.particle)},
        {"radius", input.radius},
        {"substrate", body_inputs(input.substrate)},
        {"largest_load", setup.largest_load},
        {"control", setup.system.control == Control::force ? "force" : "displacement"},
        {"rms_in_region", {{"particle", setup.rms_particle}, {"substrate", setup.rms_substrate}}},
        {"far_field_compliance", s.far_field},
        {"lateral_far_field_compliance", s.lateral_far_field},
        {"friction_coefficient", input.interface.friction_coefficient},
        {"shear_strength", input.interface.shear_strength},
        {"work_of_adhesion", input.interface.work_of_adhesion},
        {"opening_work", input.interface.opening_work},
        {"adhesion_law", input.interface.adhesion_law},
        {"adhesion_range", input.interface.adhesion_range},
        {"normal_displacement", "approach of points far from the contact: the finite bodies' own compliance (far_field_compliance, m/N, "
                                "times the force) is taken out of the displacement of the driven plane; zero at first touch"},
        {"contact_radius", "of the Hertzian pressure with the same second moment"},
        {"sd", "from half an interface spacing in the contact radius; of sliding_friction, rolling_moment and torsion_moment the fluctuation along the "
               "way; scatter over realisations is the study's"},
        {"rolling_moment", "about the contact, of a particle whose shift follows its rolling so that no lateral force builds up; "
                           "rolling_dissipation: dissipated energy per angle after a contact radius, without what the hills of rough surfaces take and give back; "
                           "rolling_noise_floor: what meshes of six to twelve spacings in the contact radius show on smooth elastic bodies"},
        {"sliding_friction", "lateral over normal force of the whole contact; the local friction_coefficient is an input, and where it is "
                             "Coulomb's only what departs from it is a result"}}},
      {"hertz", {{"contact_radius", setup.hertz_radius}, {"approach", setup.hertz_approach}, {"reduced_modulus", setup.reduced_modulus}}},
      {"mesh",
       {{"cells", s.cells},
        {"dofs", s.unknowns},
        {"interface_spacing", spacing},
        {"contact_region", setup.system.mesh.sizes.region_particle},
        {"contact_nodes", s.contact_nodes},
        {"roughness", {{"particle", resolved_roughness(setup.roughness[0])}, {"substrate", resolved_roughness(setup.roughness[1])}}},
        {"contact_reaches_rim", std::any_of(records.begin(), records.end(), [](const auto& r) { return r.reaches_rim > 0; })}}},
      {"effective", effective},
      {"balance", {{"force", force}, {"moment", moment}, {"energy", energy}}},
      {"cost",
       {{"wall_time", s.wall_time}, {"peak_memory", s.peak_memory}, {"ranks", s.ranks}, {"threads", s.threads}, {"steps", records.size()}}},
      {"versions", {{"asperity", ASPERITY_VERSION}, {"deal.II", DEAL_II_PACKAGE_VERSION}, {"compiler", __VERSION__}}}};
  return result.dump(1) + "\n";
}

}  // namespace asperity::fem
