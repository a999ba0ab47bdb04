// diagnosis.json, "asperity-diagnosis/1".
#include <nlohmann/json.hpp>

#include "core/printed.h"
#include "core/quantity.h"
#include "diagnosis/outcome/diagnosis.h"
#include "diagnosis/recording/recording.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

std::string kind_of(const SolvedSimulation& simulation) {
  return simulation.by_finite_elements ? "finite_elements" : "reduced";
}

Json to_json(const DiagnosedParameter& p) {
  return {{"value", p.value}, {"unit", p.unit}, {"ci95", {p.low, p.high}}};
}

Json to_json(const DiagnosedEffect& e, const SolvedSimulation& simulation) {
  Json parameters = Json::object(), entries = Json::object();
  for (const auto& p : e.parameters) parameters[p.name] = to_json(p);
  for (const auto& entry : e.case_entries) entries[entry.entry] = entry.written();
  Json json{{"effect", e.id},
            {"title", e.title},
            {"kind", e.kind == EffectKind::contact ? "contact" : "instrument"},
            {"probability", e.probability},
            {"equation", e.equation},
            {"source", e.source},
            {"meaning", e.meaning},
            {"parameters", parameters},
            {"case_entries", entries},
            {"tried_in", {kind_of(simulation)}}};
  if (!e.form.empty()) json["form"] = e.form;
  return json;
}

Json to_json(const std::vector<MismatchRegion>& regions) {
  Json list = Json::array();
  for (const auto& r : regions)
    list.push_back({{"table", r.table},
                    {"channel", r.channel},
                    {"segment", r.segment},
                    {"variable", r.variable},
                    {"from", r.from},
                    {"to", r.to},
                    {"unit", r.unit},
                    {"size_in_noise", r.size_in_noise},
                    {"p_value", r.p_value},
                    {"share", r.share}});
  return list;
}

Json to_json(const FitQuality& q) {
  Json rms = Json::object();
  for (const auto& [channel, value] : q.rms)
    rms[channel] = {{"value", value}, {"unit", unit_of_channel(channel)}};
  return {{"chi2_reduced", q.chi2_reduced}, {"rms", rms}, {"held_out_chi2_reduced", q.held_out_chi2_reduced}};
}

/// What fits best and is not named.
Json nearest(const Diagnosis& d) {
  Json names = Json::array(), details = Json::array();
  for (const auto& effect : d.nearest)
    names.push_back(effect.id), details.push_back(to_json(effect, d.simulation));
  return {{"effects", names}, {"is_named", false}, {"fit", to_json(d.with_nearest)}, {"details", details}};
}

Json forward_model(const Diagnosis& d) {
  const SolvedSimulation& simulation = d.simulation;
  Json json{{"kind", kind_of(simulation)}};
  if (!simulation.by_finite_elements) return json;
  Json corrected = Json::object();
  for (const auto& e : d.corrected())
    corrected[e.entry] = {
        {"value", e.value}, {"unit", e.unit}, {"ci95", {e.low, e.high}}, {"entry", e.written()}};
  json["case"] = simulation.case_file;
  json["solves"] = simulation.solves;
  json["discretisation_error"] = {{"value", simulation.error},
                                  {"unit", simulation.is_error_of_approach() ? "m" : ""},
                                  {"of", simulation.is_error_of_approach()
                                             ? "approach at the largest load, standard deviation"
                                             : simulation.error_of + ", standard deviation as a part of it"}};
  json["before"] = simulation.before;
  json["after"] = simulation.after;
  json["corrected"] = corrected;
  return json;
}

}  // namespace

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::no_mismatch:
      return "no_mismatch";
    case Verdict::explained:
      return "explained";
    case Verdict::partly_explained:
      return "partly_explained";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unexplained:
      return "unexplained";
  }
  return "";
}

std::string CorrectedEntry::written() const {
  if (!text.empty()) return text;
  return printed("%.6g", value) + (unit.empty() ? "" : " " + unit);
}

std::string CorrectedEntry::interval() const {
  if (low == high) return "taken, the recording does not tell it";
  return printed("95 %%: %.4g to %.4g", low, high) + (unit.empty() ? "" : " " + unit);
}

std::string SolvedSimulation::off_by() const {
  if (!is_error_of_approach() && error >= 1)
    return "its " + error_of + " is no more than what the mesh makes of smooth elastic bodies";
  return "its " + error_of + " is off by " +
         (is_error_of_approach() ? format_quantity(error, Dimension::length)
                                 : printed("%.2g %%", 100 * error));
}

std::vector<CorrectedEntry> Diagnosis::corrected() const {
  std::vector<CorrectedEntry> list;
  for (const auto& effect : left_out)
    list.insert(list.end(), effect.case_entries.begin(), effect.case_entries.end());
  return list;
}

std::string diagnosis_json(const Diagnosis& d) {
  Json json;
  json["format"] = "asperity-diagnosis/1";
  json["verdict"] = name_of(d.verdict);
  json["in_words"] = d.in_words;
  json["forward_model"] = forward_model(d);
  json["noise"] = Json::object();
  for (const auto& [channel, noise] : d.noise)
    json["noise"][channel] = {{"value", noise.value}, {"unit", noise.unit}, {"from", noise.from}};
  json["calibrated"] = Json::object();
  for (const auto& p : d.calibrated) json["calibrated"][p.name] = to_json(p);
  if (d.rows_are_points_of_a_curve) json["rows_are"] = "points of a fitted curve";
  json["baseline"] = to_json(d.baseline);
  json["mismatch"] = to_json(d.mismatch);
  json["left_out"] = Json::array();
  for (const auto& effect : d.left_out) json["left_out"].push_back(to_json(effect, d.simulation));
  json["improved"] = to_json(d.improved);
  json["alternatives"] = Json::array();
  for (const auto& a : d.alternatives) {
    Json names = Json::array(), details = Json::array();
    for (const auto& effect : a.effects)
      names.push_back(effect.id), details.push_back(to_json(effect, d.simulation));
    json["alternatives"].push_back({{"effects", names},
                                    {"probability", a.probability},
                                    {"held_out_chi2_reduced", a.held_out_chi2_reduced},
                                    {"told_apart_by", a.told_apart_by},
                                    {"details", details}});
  }
  if (!d.nearest.empty()) json["nearest"] = nearest(d);
  json["remaining"] = to_json(d.remaining);
  json["not_tried"] = Json::array();
  for (const auto& e : d.not_tried) json["not_tried"].push_back({{"effect", e.effect}, {"why", e.why}});
  json["remarks"] = d.remarks;
  return json.dump(1) + "\n";
}

}  // namespace asperity
