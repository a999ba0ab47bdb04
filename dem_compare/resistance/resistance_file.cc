#include "dem_compare/resistance/resistance_file.h"

#include <cmath>
#include <cstdio>

#include "dem_compare/numbers/json_number.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

std::string csv_cell(double value) {
  if (!std::isfinite(value)) return "";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.9g", value);
  return buffer;
}

std::string csv_cells(const Uncertain& number) {
  return "," + csv_cell(number.value) + "," + csv_cell(number.sd);
}

/// Quotation marks within become apostrophes.
std::string quoted_label(const std::string& text) {
  std::string safe = "\"";
  for (const char c : text) safe += c == '"' ? '\'' : c;
  return safe + "\"";
}

Json json_of(const Uncertain& value) {
  return {{"value", number_or_null(value.value)}, {"sd", number_or_null(value.sd)}};
}
Json json_of(const ResistanceParts& parts) {
  return {{"friction", json_of(parts.friction)},
          {"plastic", json_of(parts.plastic)},
          {"adhesion", json_of(parts.adhesion)},
          {"total", json_of(parts.total)}};
}
Json json_of(const Trend& trend) {
  return {{"slope", json_of(trend.slope)}, {"mean", json_of(trend.mean)}, {"points", trend.points}};
}

Json json_of(const MovingCase& item) {
  return {{"folder", item.folder},
          {"load", item.load},
          {"spacing", number_or_null(item.spacing)},
          {"contact_radius", item.contact_radius},
          {"way_in_contact_radii", item.way_in_radii},
          {"stretches", item.first.stretches},
          {"dissipated", json_of(item.first.dissipated)},
          {"force", json_of(item.first.force)},
          {"force_fluctuation", number_or_null(item.first.fluctuation)},
          {"unbalanced", number_or_null(item.first.unbalanced)},
          {"drift", number_or_null(item.first.drift)},
          {"drift_error", number_or_null(item.first.drift_error)},
          {"way_back", item.back.reached() ? json_of(item.back.dissipated) : Json(nullptr)}};
}

Json json_of(const MovingContact& contact) {
  Json states = Json::array();
  for (const auto& state : contact.states) {
    Json cases = Json::array();
    for (const auto& item : state.cases) cases.push_back(json_of(item));
    states.push_back({{"experiment", name_of(state.mode->motion)},
                      {"load", state.load},
                      {"resistance", json_of(state.resistance)},
                      {"parts", json_of(state.parts)},
                      {"force", json_of(state.force)},
                      {"way_back_over_first", json_of(state.back_over_first)},
                      {"hertz_radius", state.hertz_radius},
                      {"contact_area", state.contact_area},
                      {"coulomb", number_or_null(state.coulomb)},
                      {"cases", cases}});
  }
  Json rails = Json::array();
  for (const auto& rail : contact.rails) {
    Json cases = Json::array();
    for (const auto& item : rail.cases) cases.push_back(json_of(item));
    rails.push_back({{"inclination", rail.inclination},
                     {"load", rail.load},
                     {"resistance", json_of(rail.resistance)},
                     {"parts", json_of(rail.parts)},
                     {"spin_moment", json_of(rail.spin_moment)},
                     {"sum_of_separate_motions", json_of(rail.sum)},
                     {"over_sum", json_of(rail.over_sum())},
                     {"spin_over_torsion", json_of(rail.spin_over_torsion)},
                     {"cases", cases}});
  }
  return {{"label", contact.label},
          {"radius", contact.bodies.radius},
          {"rms", number_or_null(contact.bodies.rms)},
          {"friction_coefficient", contact.bodies.friction},
          {"can_yield", contact.can_yield},
          {"adheres", contact.adheres},
          {"states", states},
          {"rails", rails}};
}

Json json_of(const RoughnessTrend& trend) {
  Json loads = Json::array(), coefficients = Json::array(), contacts = Json::array();
  for (const auto* contact : trend.contacts) contacts.push_back(contact->label);
  for (const auto& at : trend.loads)
    loads.push_back({{"load", at.load},
                     {"total", json_of(at.total)},
                     {"friction", json_of(at.friction)},
                     {"plastic", json_of(at.plastic)},
                     {"adhesion", json_of(at.adhesion)},
                     {"force", json_of(at.force)}});
  for (const auto& one : trend.coefficients)
    coefficients.push_back(
        {{"rms", one.rms}, {"coefficient", json_of(one.coefficient)}, {"offset", json_of(one.offset)}});
  return {{"experiment", name_of(trend.mode->motion)},
          {"contacts", contacts},
          {"relative_per_metre", json_of(trend.relative)},
          {"loads", loads},
          {"coefficients", coefficients},
          {"coefficient", json_of(trend.coefficient)}};
}

Json json_of(const LengthAnswer& answer) {
  static const char* const verdicts[] = {"cannot tell", "r", "a", "neither"};
  Json exponents = Json::array();
  for (const auto& exponent : answer.exponents)
    exponents.push_back({{"over", exponent.over},
                         {"of", exponent.what},
                         {"exponent", json_of(exponent.exponent.slope)},
                         {"with_r", exponent.with_radius},
                         {"with_a", exponent.with_contact},
                         {"with_bonds", number_or_null(exponent.with_bonds)}});
  return {{"experiment", name_of(answer.mode->motion)},
          {"contact", answer.contact},
          {"radii", answer.radii},
          {"exponents", exponents},
          {"laws", answer.choice ? to_json(*answer.choice) : Json(nullptr)},
          {"verdict", verdicts[static_cast<int>(answer.verdict)]}};
}

Json json_of(const Contribution& one) {
  return {{"mechanism", one.mechanism == Contribution::Mechanism::yielding ? "yielding" : "adhesion"},
          {"with", one.with->label},
          {"without", one.without->label},
          {"experiment", name_of(one.mode->motion)},
          {"load", one.load},
          {"realisations", one.realisations},
          {"difference", json_of(one.difference)},
          {"parts", json_of(one.parts)},
          {"share", json_of(one.share())}};
}

Json json_of(const ContributionTrend& one) {
  return {
      {"mechanism", one.smoothest->mechanism == Contribution::Mechanism::yielding ? "yielding" : "adhesion"},
      {"experiment", name_of(one.smoothest->mode->motion)},
      {"load", one.smoothest->load},
      {"from", one.smoothest->with->label},
      {"to", one.roughest->with->label},
      {"relative_per_metre", json_of(one.relative())}};
}

Json json_of(const InputExponent& one) {
  return {{"input", one.input},
          {"larger", one.larger->label},
          {"smaller", one.smaller->label},
          {"factor", one.factor},
          {"experiment", name_of(one.mode->motion)},
          {"load", one.load},
          {"realisations", one.realisations},
          {"exponent", json_of(one.exponent)}};
}

Json json_of(const MeshEffect& one) {
  return {{"contact", one.contact->label},
          {"experiment", name_of(one.state->mode->motion)},
          {"load", one.state->load},
          {"coarse", one.coarse},
          {"fine", one.fine},
          {"counted", one.state->spacing},
          {"realisations", one.realisations},
          {"fine_over_coarse", json_of(one.ratio)},
          {"excess_of_counted_at_first_order", json_of(one.excess())}};
}

Json json_of(const AgainstPublished& published) {
  Json magnitudes = Json::array(), trends = Json::array(), laws = Json::array();
  for (const auto& one : published.laws)
    laws.push_back(
        {{"contact", one.contact->label},
         {"indenter", one.indenter ? Json(one.indenter->label) : Json(nullptr)},
         {"experiment", name_of(one.mode->motion)},
         {"loads", {one.lowest_load, one.highest_load}},
         {"coefficient",
          {{"simulated", json_of(one.simulated.coefficient)}, {"measured", json_of(one.coefficient)}}},
         {"offset", {{"simulated", json_of(one.simulated.offset)}, {"measured", json_of(one.offset)}}}});
  for (const auto& one : published.magnitudes)
    magnitudes.push_back({{"contact", one.contact->label},
                          {"indenter", one.indenter ? Json(one.indenter->label) : Json(nullptr)},
                          {"experiment", name_of(one.mode->motion)},
                          {"load", one.load},
                          {"simulated", json_of(one.simulated)},
                          {"measured", json_of(one.measured)},
                          {"ratio", json_of(one.over())},
                          {"sigmas", number_or_null(one.sigmas())},
                          {"source", one.source}});
  for (const auto& one : published.trends)
    trends.push_back({{"experiment", name_of(one.trend->mode->motion)},
                      {"load", number_or_null(one.load)},
                      {"simulated", json_of(one.simulated)},
                      {"measured", json_of(one.measured)},
                      {"ratio", json_of(one.over())},
                      {"sigmas", number_or_null(one.sigmas())},
                      {"opposite", one.is_opposite()}});
  return {{"magnitudes", magnitudes}, {"laws", laws}, {"trends", trends}, {"remarks", published.remarks}};
}

template <class List>
Json list_of(const List& items) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(json_of(item));
  return list;
}

}  // namespace

std::string resistance_csv(const MovingStudy& study) {
  std::string text =
      "contact,experiment,load [N],radius [m],rms [m],realisations,spacing "
      "[m],resistance,resistance_sd,friction,friction_sd,plastic,plastic_sd,"
      "adhesion,adhesion_sd,mean_force,mean_force_sd,force_fluctuation,unbalanced,over_scale,over_scale_sd,"
      "over_coulomb,over_coulomb_sd,"
      "way_back_over_first,"
      "way_back_over_first_sd,hertz_radius [m],contact_area [m^2]\n";
  for (const auto& contact : study.contacts)
    for (const auto& state : contact.states) {
      const auto over = [&](double unit) {
        return Uncertain{state.resistance.value / unit, state.resistance.sd / unit};
      };
      text += quoted_label(contact.label) + "," + name_of(state.mode->motion) + "," + csv_cell(state.load) +
              "," + csv_cell(contact.bodies.radius) + "," + csv_cell(contact.bodies.rms) + "," +
              std::to_string(state.cases.size()) + "," + csv_cell(state.spacing) +
              csv_cells(state.resistance) + csv_cells(state.parts.friction) + csv_cells(state.parts.plastic) +
              csv_cells(state.parts.adhesion) + csv_cells(state.force) + "," + csv_cell(state.fluctuation) +
              "," + csv_cell(state.unbalanced) + csv_cells(over(state.scale())) +
              csv_cells(over(state.coulomb)) + csv_cells(state.back_over_first) + "," +
              csv_cell(state.hertz_radius) + "," + csv_cell(state.contact_area) + "\n";
    }
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
          {"contacts", list_of(findings.study.contacts)},
          {"roughness", list_of(findings.trends)},
          {"length", list_of(findings.lengths)},
          {"contributions", list_of(findings.contributions)},
          {"contributions_over_roughness", list_of(findings.contribution_trends)},
          {"inputs", list_of(findings.inputs)},
          {"mesh", list_of(findings.meshes)},
          {"published", json_of(findings.published)}};
}

}  // namespace asperity
