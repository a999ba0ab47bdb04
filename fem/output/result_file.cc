#include "fem/output/result_file.h"

#include <deal.II/base/config.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fem/interface/adhesion_law.h"
#include "fem/interface/friction_law.h"
#include "fem/materials/material_law.h"
#include "fem/output/added_column.h"
#include "fem/output/discretisation_error.h"
#include "fem/output/effective_values.h"
#include "fem/output/field.h"
#include "results/known_entries.h"

namespace asperity::fem {
namespace {

using nlohmann::json;

json body_inputs(const BodyInput& body) {
  json inputs{{"youngs_modulus", body.youngs_modulus},
              {"poissons_ratio", body.poisson_ratio},
              {"topography", body.topography.text()}};
  const auto parameters = parameters_of(material_laws());
  const LawValues values = with_defaults(parameters, body.parameters);
  for (const auto& parameter : parameters) {
    const double value = values.at(parameter.entry);
    json& said = inputs[result_name(parameter.entry)];
    if (!parameter.words.empty())
      said = parameter.words.at(static_cast<std::size_t>(value));
    else if (std::isfinite(value))
      said = value;
    else
      said = "inf";
  }
  return inputs;
}

/// Of all laws, those that the case leaves at their defaults as well.
LawValues interface_parameters(const InterfaceInput& interface) {
  return with_defaults(parameters_of(adhesion_laws()),
                       with_defaults(parameters_of(friction_laws()), interface.parameters));
}

/// Resolution of a body's roughness by the mesh.
json resolved_roughness(const MeshedRoughness& r) {
  if (!r.rough()) return nullptr;
  const auto finite = [](double value) { return std::isfinite(value) ? json(value) : json(nullptr); };
  return {{"shortest_wave", finite(r.scales.shortest_wave)},
          {"cells_over_shortest_wave", finite(r.cells_per_wave())},
          {"slope_variance_in_shorter_waves", r.scales.unresolved},
          {"rms_slope", r.fidelity.rms_slope},
          {"missed_by_facets",
           {{"rms_height", r.fidelity.missed_height_share()},
            {"slope_variance", r.fidelity.missed_slope_share()}}},
          {"repeats_every", r.scales.period < r.region ? json(r.scales.period) : json(nullptr)}};
}

json half_space_numbers(const half_space::CaseContact& contact) {
  json numbers{{"contact_area", contact.shape.area},
               {"mean_pressure", contact.mean_pressure()},
               {"max_pressure", contact.largest_pressure()},
               {"approach", contact.approach()},
               {"first_touch", contact.first_touch},
               {"normal_stiffness", contact.stiffness},
               {"spacing", contact.grid.dx}};
  if (contact.lateral_stiffness > 0) numbers["lateral_stiffness"] = contact.lateral_stiffness;
  if (contact.torsion_stiffness > 0) numbers["torsion_stiffness"] = contact.torsion_stiffness;
  if (contact.pull_off) numbers["pull_off_force"] = contact.pull_off->force;
  return numbers;
}

/// What names of the result mean.
json meanings() {
  return {
      {"normal_displacement",
       "approach of points far from the contact: the finite bodies' own compliance (far_field_compliance, "
       "m/N, "
       "times the force) is taken out of the displacement of the driven plane; zero at first touch"},
      {"contact_radius",
       "of the circle with the contact area; pressure_radius: of the Hertzian pressure with the same "
       "second moment"},
      {"approach",
       "of the mean surfaces, without roughness; approach_from_first_touch: from where the meshed surfaces "
       "touch first, which is at "
       "an approach of first_touch and moves with the spacing"},
      {"normal_stiffness",
       "of the contact as it stands at the largest load: its edge and its attraction are held. Where "
       "surfaces "
       "attract each other, the slope of separation is less (asperity preview)"},
      {"attraction_zone",
       "length at the edge of a contact in which the attraction acts, pi E* w/(4 s^2) for a work of adhesion "
       "w and a stress s at contact: cells of a third of it resolve it"},
      {"load_step_error",
       "by which finite load steps make the approach of bodies that yield too large, over the approach "
       "from first touch; it "
       "falls with the number of steps"},
      {"sd",
       "error of discretisation and load steps (docs/solver.md); of sliding_friction, "
       "rolling_moment and "
       "torsion_moment with the fluctuation along the path; scatter over realisations is the study's"},
      {"rolling_moment",
       "about the contact, of a particle whose shift follows its rolling so that no lateral force builds "
       "up; "
       "rolling_dissipation: dissipated energy per angle after two contact radii, without the conservative "
       "topographic part of the moment; "
       "rolling_noise_floor: discretisation noise: moment of smooth elastic bodies on meshes of six to "
       "twelve "
       "spacings in the contact radius"},
      {"sliding_friction",
       "lateral over normal force of the whole contact; the local friction_coefficient is an input, and "
       "where it is "
       "Coulomb's only what departs from it is a result"}};
}

json inputs_of(const CaseInput& input, const CaseSetup& setup, const ResultSummary& s) {
  // What follows from entries of the law stands here as if it had been given; 0: as on approach.
  const AdhesionWork work = work_of_adhesion(input.interface);
  const double separation = work.opening == work.closing ? input.interface.work_of_separation : work.opening;
  json inputs{{"case", input.file},
              {"entries", input.physical_entries},
              {"particle", body_inputs(input.particle)},
              {"radius", input.radius},
              {"substrate", body_inputs(input.substrate)},
              {"largest_load", setup.largest_load},
              {"control", setup.system.control == Control::force ? "force" : "displacement"},
              {"rms_in_region", {{"particle", setup.rms_particle}, {"substrate", setup.rms_substrate}}},
              {"far_field_compliance", s.stiffness.far_field},
              {"lateral_far_field_compliance", s.stiffness.lateral_far_field},
              {"work_of_adhesion", work.closing},
              {"work_of_adhesion_on_separation", separation},
              {"adhesion_law", input.interface.adhesion_law}};
  inputs.update(meanings());
  for (const auto& [entry, value] : interface_parameters(input.interface)) inputs[result_name(entry)] = value;
  return inputs;
}

json mesh_of(const CaseSetup& setup, const std::vector<HistoryRow>& records, const ResultSummary& s) {
  return {{"cells", s.cells},
          {"dofs", s.unknowns},
          {"interface_spacing", setup.system.mesh.sizes.spacing_particle},
          {"contact_region", setup.system.mesh.sizes.region_particle},
          {"contact_nodes", s.contact_nodes},
          {"attraction_zone", setup.attraction.acts() ? json(setup.attraction.zone) : json(nullptr)},
          {"roughness",
           {{"particle", resolved_roughness(setup.roughness[0])},
            {"substrate", resolved_roughness(setup.roughness[1])}}},
          {"contact_reaches_rim",
           std::any_of(records.begin(), records.end(), [](const auto& r) { return r.reaches_rim > 0; })}};
}

/// What files of their own add to history.csv and to the fields; null: nothing.
json additions() {
  json added;
  for (const auto& column : added_columns())
    added["columns"].push_back({{"name", column.name}, {"meaning", column.meaning}});
  for (const auto& field : added_fields())
    added["fields"].push_back({{"name", field.name},
                               {"unit", field.unit},
                               {"meaning", field.meaning},
                               {"place", field.place == FieldPlace::contact ? "contact" : "bodies"},
                               {"components", field.components}});
  return added;
}

}  // namespace

std::string result_json(const CaseInput& input, const CaseSetup& setup,
                        const std::vector<HistoryRow>& records, const ResultSummary& s) {
  const HistoryRow& peak = at_largest_load(records);
  const HistoryRow& least =
      *std::min_element(records.begin(), records.end(),
                        [](const auto& a, const auto& b) { return a.normal_force < b.normal_force; });
  const double wave =
      std::min(setup.roughness[0].scales.shortest_wave, setup.roughness[1].scales.shortest_wave);
  const DiscretisationError error(
      peak, {setup.system.mesh.sizes.spacing_particle, setup.reduced_modulus, wave, setup.attraction});
  json result{
      {"format", "asperity-result/1"},
      {"title", input.title},
      {"experiment", name_of(input.experiment.type)},
      {"inputs_sha256", s.provenance.inputs_sha256},
      {"commit", s.provenance.commit},
      {"inputs", inputs_of(input, setup, s)},
      {"hertz",
       {{"contact_radius", setup.hertz_radius},
        {"approach", setup.hertz_approach},
        {"reduced_modulus", setup.reduced_modulus}}},
      {"mesh", mesh_of(setup, records, s)},
      {"effective", effective_values(input, records, peak, least, error, s)},
      {"balance",
       {{"force", largest_size(records, &HistoryRow::force_error)},
        {"moment", largest_size(records, &HistoryRow::moment_error)},
        {"energy", largest_size(records, &HistoryRow::energy_error)}}},
      {"cost",
       {{"wall_time", s.wall_time},
        {"peak_memory", s.peak_memory},
        {"ranks", s.ranks},
        {"threads", s.threads},
        {"steps", records.size()}}},
      {"versions",
       {{"asperity", ASPERITY_VERSION}, {"deal.II", DEAL_II_PACKAGE_VERSION}, {"compiler", __VERSION__}}}};
  if (const json added = additions(); !added.is_null()) result["added"] = added;
  if (s.half_space) result["half_space"] = half_space_numbers(*s.half_space);
  return result.dump(1) + "\n";
}

}  // namespace asperity::fem
