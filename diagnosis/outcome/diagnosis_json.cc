// diagnosis.json, "asperity-diagnosis/1".
#include <nlohmann/json.hpp>

#include "diagnosis/outcome/diagnosis.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const DiagnosedParameter& p) {
  return {{"value", p.value}, {"unit", p.unit}, {"ci95", {p.low, p.high}}};
}

Json to_json(const DiagnosedEffect& e) {
  Json parameters = Json::object();
  for (const auto& p : e.parameters) parameters[p.name] = to_json(p);
  return {{"effect", e.id},
          {"title", e.title},
          {"kind", e.kind == EffectKind::contact ? "contact" : "instrument"},
          {"probability", e.probability},
          {"equation", e.equation},
          {"source", e.source},
          {"meaning", e.meaning},
          {"parameters", parameters}};
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

}  // namespace

std::string diagnosis_json(const Diagnosis& d) {
  Json json;
  json["format"] = "asperity-diagnosis/1";
  json["verdict"] = name_of(d.verdict);
  json["in_words"] = d.in_words;
  if (d.simulation.by_finite_elements) {
    Json corrected = Json::object();
    for (const auto& e : d.simulation.corrected)
      corrected[e.entry] = {{"value", e.value}, {"unit", e.unit}, {"ci95", {e.low, e.high}}};
    json["simulation"] = "finite elements";
    json["solutions"] = {{"count", d.simulation.solves},
                         {"before", d.simulation.before},
                         {"after", d.simulation.after},
                         {"displacement_error", {{"value", d.simulation.displacement_error}, {"unit", "m"}}},
                         {"corrected", corrected}};
  }
  json["noise"] = Json::object();
  for (const auto& [channel, noise] : d.noise)
    json["noise"][channel] = {{"value", noise.value}, {"unit", noise.unit}, {"from", noise.from}};
  json["calibrated"] = Json::object();
  for (const auto& p : d.calibrated) json["calibrated"][p.name] = to_json(p);
  json["baseline"] = to_json(d.baseline);
  json["mismatch"] = to_json(d.mismatch);
  json["left_out"] = Json::array();
  for (const auto& effect : d.left_out) json["left_out"].push_back(to_json(effect));
  json["improved"] = to_json(d.improved);
  json["alternatives"] = Json::array();
  for (const auto& a : d.alternatives) {
    Json names = Json::array(), details = Json::array();
    for (const auto& effect : a.effects) names.push_back(effect.id), details.push_back(to_json(effect));
    json["alternatives"].push_back({{"effects", names},
                                    {"probability", a.probability},
                                    {"held_out_chi2_reduced", a.held_out_chi2_reduced},
                                    {"told_apart_by", a.told_apart_by},
                                    {"details", details}});
  }
  json["remaining"] = to_json(d.remaining);
  json["remarks"] = d.remarks;
  return json.dump(1) + "\n";
}

}  // namespace asperity
