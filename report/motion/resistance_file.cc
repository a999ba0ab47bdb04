#include "report/motion/resistance_file.h"

#include "core/csv.h"
#include "core/joined.h"
#include "dem_compare/cases/path_averages.h"
#include "report/page/json_numbers.h"
#include "report/sentences/resistance_answers.h"

// Each type as it stands in the file; lists of them follow.
namespace asperity {

using Json = nlohmann::ordered_json;

static Json label_or_null(const MovingContact* contact) { return contact ? Json(contact->label) : Json(); }

static void to_json(Json& json, const ResistanceParts& parts) {
  json = {{"friction", parts.friction},
          {"plastic", parts.plastic},
          {"adhesion", parts.adhesion},
          {"total", parts.total}};
}

static void to_json(Json& json, const Trend& trend) {
  json = {{"slope", trend.slope}, {"mean", trend.mean}, {"points", trend.points}};
}

static void to_json(Json& json, const MovingCase& item) {
  json = {{"folder", item.folder},
          {"load", item.load},
          {"spacing", item.spacing},
          {"contact_radius", item.contact_radius},
          {"way_in_contact_radii", item.path_in_radii},
          {"stretches", item.first.blocks},
          {"dissipated", item.first.dissipated},
          {"force", item.first.force},
          {"force_fluctuation", item.first.fluctuation},
          {"unbalanced", item.first.unbalanced},
          {"drift", item.first.drift},
          {"drift_error", item.first.drift_error},
          {"way_back", item.back.reached() ? Json(item.back.dissipated) : Json()}};
}

static void to_json(Json& json, const MovingState& state) {
  json = {{"experiment", name_of(state.mode->motion)},
          {"load", state.load},
          {"resistance", state.resistance},
          {"parts", state.parts},
          {"force", state.force},
          {"way_back_over_first", state.back_over_first},
          {"hertz_radius", state.hertz_radius},
          {"contact_area", state.contact_area},
          {"coulomb", state.coulomb},
          {"cases", state.cases}};
}

static void to_json(Json& json, const RailState& rail) {
  json = {{"inclination", rail.inclination},
          {"load", rail.load},
          {"resistance", rail.resistance},
          {"parts", rail.parts},
          {"spin_moment", rail.spin_moment},
          {"sum_of_separate_motions", rail.sum},
          {"over_sum", rail.over_sum()},
          {"spin_over_torsion", rail.spin_over_torsion},
          {"cases", rail.cases}};
}

static void to_json(Json& json, const MovingContact& contact) {
  json = {{"label", contact.label},         {"radius", contact.bodies.radius},
          {"rms", contact.bodies.rms},      {"friction_coefficient", contact.bodies.friction},
          {"can_yield", contact.can_yield}, {"adheres", contact.adheres},
          {"states", contact.states},       {"rails", contact.rails}};
}

static void to_json(Json& json, const TrendAtLoad& at) {
  json = {{"load", at.load},       {"total", at.total},       {"friction", at.friction},
          {"plastic", at.plastic}, {"adhesion", at.adhesion}, {"force", at.force}};
}

static void to_json(Json& json, const CoefficientOverLoads& one) {
  json = {{"rms", one.rms}, {"coefficient", one.coefficient}, {"offset", one.offset}};
}

static void to_json(Json& json, const RoughnessTrend& trend) {
  std::vector<std::string> contacts;
  for (const auto* contact : trend.contacts) contacts.push_back(contact->label);
  json = {{"experiment", name_of(trend.mode->motion)}, {"contacts", contacts},
          {"relative_per_metre", trend.relative},      {"loads", trend.loads},
          {"coefficients", trend.coefficients},        {"coefficient", trend.coefficient}};
}

static void to_json(Json& json, const ScalingExponent& exponent) {
  json = {{"over", exponent.over},
          {"of", exponent.what},
          {"exponent", exponent.exponent.slope},
          {"with_r", exponent.with_radius},
          {"with_a", exponent.with_contact},
          {"with_bonds", exponent.with_bonds}};
}

static void to_json(Json& json, const LengthAnswer& answer) {
  static const char* const verdicts[] = {"cannot tell", "r", "a", "neither"};
  json = {{"experiment", name_of(answer.mode->motion)},
          {"contact", answer.contact},
          {"radii", answer.radii},
          {"exponents", answer.exponents},
          {"laws", answer.choice ? to_json(*answer.choice) : Json()},
          {"verdict", verdicts[static_cast<int>(answer.verdict)]}};
}

static void to_json(Json& json, const Contribution& one) {
  json = {{"mechanism", name_of(one.mechanism)},
          {"with", one.with->label},
          {"without", one.without->label},
          {"experiment", name_of(one.mode->motion)},
          {"load", one.load},
          {"realisations", one.realisations},
          {"difference", one.difference},
          {"parts", one.parts},
          {"share", one.share()}};
}

static void to_json(Json& json, const ContributionTrend& one) {
  json = {{"mechanism", name_of(one.smoothest->mechanism)},
          {"experiment", name_of(one.smoothest->mode->motion)},
          {"load", one.smoothest->load},
          {"from", one.smoothest->with->label},
          {"to", one.roughest->with->label},
          {"relative_per_metre", one.relative()}};
}

static void to_json(Json& json, const InputExponent& one) {
  json = {{"input", one.input},
          {"larger", one.larger->label},
          {"smaller", one.smaller->label},
          {"factor", one.factor},
          {"experiment", name_of(one.mode->motion)},
          {"load", one.load},
          {"realisations", one.realisations},
          {"exponent", one.exponent}};
}

static void to_json(Json& json, const MeshEffect& one) {
  json = {{"contact", one.contact->label},
          {"experiment", name_of(one.state->mode->motion)},
          {"load", one.state->load},
          {"coarse", one.coarse},
          {"fine", one.fine},
          {"counted", one.state->spacing},
          {"realisations", one.realisations},
          {"fine_over_coarse", one.ratio},
          {"excess_of_counted_at_first_order", one.excess()}};
}

static void to_json(Json& json, const MeasuredLaw& one) {
  json = {{"contact", one.contact->label},
          {"indenter", label_or_null(one.indenter)},
          {"experiment", name_of(one.mode->motion)},
          {"loads", {one.lowest_load, one.highest_load}},
          {"coefficient", {{"simulated", one.simulated.coefficient}, {"measured", one.coefficient}}},
          {"offset", {{"simulated", one.simulated.offset}, {"measured", one.offset}}}};
}

static void to_json(Json& json, const MeasuredMagnitude& one) {
  json = {{"contact", one.contact->label},
          {"indenter", label_or_null(one.indenter)},
          {"experiment", name_of(one.mode->motion)},
          {"load", one.load},
          {"simulated", one.simulated},
          {"measured", one.measured},
          {"ratio", one.over()},
          {"sigmas", one.sigmas()},
          {"source", one.source}};
}

static void to_json(Json& json, const MeasuredTrend& one) {
  json = {{"experiment", name_of(one.trend->mode->motion)},
          {"load", one.load},
          {"simulated", one.simulated},
          {"measured", one.measured},
          {"ratio", one.over()},
          {"sigmas", one.sigmas()},
          {"opposite", one.is_opposite()}};
}

static void to_json(Json& json, const AgainstPublished& published) {
  json = {{"magnitudes", published.magnitudes},
          {"laws", published.laws},
          {"trends", published.trends},
          {"remarks", published.remarks}};
}

namespace report {

std::string resistance_csv(const MovingStudy& study) {
  std::string text =
      "contact,experiment,load [N],radius [m],rms [m],realisations,spacing "
      "[m],resistance,resistance_sd,friction,friction_sd,plastic,plastic_sd,adhesion,adhesion_sd,mean_force,"
      "mean_force_sd,force_fluctuation,unbalanced,over_scale,over_scale_sd,over_coulomb,over_coulomb_sd,way_"
      "back_over_first,way_back_over_first_sd,hertz_radius [m],contact_area [m^2]\n";
  const auto cells = [](const Uncertain& number) {
    return csv_cell(number.value) + "," + csv_cell(number.sd);
  };
  for (const auto& contact : study.contacts)
    for (const auto& state : contact.states)
      text += joined({csv_cell(contact.label), name_of(state.mode->motion), csv_cell(state.load),
                      csv_cell(contact.bodies.radius), csv_cell(contact.bodies.rms),
                      std::to_string(state.cases.size()), csv_cell(state.spacing), cells(state.resistance),
                      cells(state.parts.friction), cells(state.parts.plastic), cells(state.parts.adhesion),
                      cells(state.force), csv_cell(state.fluctuation), csv_cell(state.unbalanced),
                      cells(state.resistance * (1 / state.scale())),
                      cells(state.resistance * (1 / state.coulomb)), cells(state.back_over_first),
                      csv_cell(state.hertz_radius), csv_cell(state.contact_area)},
                     ",") +
              "\n";
  return text;
}

Json resistance_json(const ResistanceFindings& findings) {
  const ResistanceAnswers said = answers(findings);
  return {{"format", "asperity-resistance/1"},
          {"answers",
           {{"headline", said.headline},
            {"length", said.length},
            {"roughness", said.roughness},
            {"mechanisms", said.mechanisms},
            {"inputs", said.inputs},
            {"mesh", said.mesh},
            {"rails", said.rails},
            {"measurement", said.measurement},
            {"care", said.care}}},
          {"contacts", findings.study.contacts},
          {"roughness", findings.trends},
          {"length", findings.lengths},
          {"contributions", findings.contributions},
          {"contributions_over_roughness", findings.contribution_trends},
          {"inputs", findings.inputs},
          {"mesh", findings.meshes},
          {"published", findings.published}};
}

}  // namespace report
}  // namespace asperity
