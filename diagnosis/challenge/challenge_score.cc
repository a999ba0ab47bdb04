#include "diagnosis/challenge/challenge_score.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/locate/views.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> names_of(const std::vector<DiagnosedEffect>& effects) {
  std::vector<std::string> names;
  for (const auto& effect : effects) names.push_back(effect.id);
  return sorted(names);
}

}  // namespace

bool ChallengeScore::holds_the_truth() const {
  return names_the_truth() ||
         std::find(alternatives.begin(), alternatives.end(), truth) != alternatives.end();
}

bool ChallengeScore::is_right() const {
  if (!failure.empty()) return false;
  if (truth.empty()) return verdict == "no_mismatch";
  if (family == out_of_catalogue) return verdict == "unexplained" || verdict == "partly_explained";
  if (family == "indistinguishable") return verdict == "ambiguous" && holds_the_truth();
  return names_the_truth() && (verdict == "explained" || verdict == "partly_explained");
}

double location_overlap(const Recording& recording, const Truth& truth, const Diagnosis& diagnosis) {
  constexpr double visible = 0.5;  // of the noise
  const Samples samples = samples_of(recording);
  const Experiment experiment = experiment_of(recording, samples);
  std::set<std::size_t> true_samples, located;
  for (const auto& run : samples.runs)
    for (const auto& contribution : truth.contributions) {
      if (contribution.table != samples.table_names[run.table]) continue;
      for (std::size_t i = run.begin; i < run.end; ++i)
        if (std::abs(contribution.in_noise[static_cast<std::size_t>(samples.list[i].row)]) > visible)
          true_samples.insert(i);
    }
  if (true_samples.empty()) return -1;
  for (const auto& view : views_of(samples, experiment))
    for (const auto& region : diagnosis.mismatch) {
      if (region.table != samples.table_names[view.table] || region.segment != view.segment ||
          region.variable != view.variable)
        continue;
      const double rounding = 1e-9 * std::max(std::abs(region.from), std::abs(region.to));
      for (const auto& bin : view.bins) {
        const double middle = (bin.from + bin.to) / 2;
        if (!view.variable.empty() && (middle < region.from - rounding || middle > region.to + rounding))
          continue;
        located.insert(bin.samples.begin(), bin.samples.end());
      }
    }
  std::size_t both = 0;
  for (const std::size_t i : located) both += true_samples.count(i);
  return 2.0 * static_cast<double>(both) / static_cast<double>(true_samples.size() + located.size());
}

ChallengeScore score_of(const ChallengeItem& item, const ConcealedRecording& concealed,
                        const Diagnosis& diagnosis) {
  ChallengeScore score;
  score.name = item.name;
  score.family = item.family;
  score.mode = name_of(item.options.mode);
  score.noise = item.options.noise;
  score.truth = sorted(item.right_answer());
  score.named = names_of(diagnosis.left_out);
  score.verdict = name_of(diagnosis.verdict);
  for (const auto& alternative : diagnosis.alternatives)
    score.alternatives.push_back(names_of(alternative.effects));
  score.held_out_before = diagnosis.baseline.held_out_chi2_reduced;
  score.held_out_after = diagnosis.improved.held_out_chi2_reduced;
  score.overlap = location_overlap(concealed.recording, concealed.truth, diagnosis);
  if (!score.names_the_truth()) return score;
  std::vector<TrueEffect> effects = concealed.truth.effects;
  if (const auto friction = concealed.truth.coefficients.find("sliding_friction");
      friction != concealed.truth.coefficients.end())
    effects.push_back({"friction_coefficient", true, {{"coefficient", {friction->second, true}}}, ""});
  for (const auto& effect : effects)
    for (const auto& found : diagnosis.left_out) {
      if (found.id != effect.id) continue;
      for (const auto& parameter : found.parameters) {
        const auto known = effect.parameters.find(parameter.name);
        if (known == effect.parameters.end() || !known->second.is_the_catalogues) continue;
        score.parameters.push_back({effect.id + "/" + parameter.name, known->second.value, parameter.value,
                                    parameter.low, parameter.high});
      }
    }
  return score;
}

Json score_json(const ChallengeScore& score) {
  Json json{{"name", score.name},
            {"family", score.family},
            {"mode", score.mode},
            {"noise", score.noise},
            {"truth", score.truth},
            {"verdict", score.verdict},
            {"named", score.named},
            {"alternatives", score.alternatives},
            {"right", score.is_right()},
            {"seconds", score.seconds},
            {"overlap", score.overlap},
            {"held_out_before", score.held_out_before},
            {"held_out_after", score.held_out_after}};
  json["baselines"] = {{"simulation", score.baselines.simulation},
                       {"sparse_regression", score.baselines.sparse_regression},
                       {"gaussian_process", score.baselines.gaussian_process},
                       {"terms", score.baselines.terms}};
  json["parameters"] = Json::array();
  for (const auto& p : score.parameters)
    json["parameters"].push_back({{"name", p.name},
                                  {"truth", p.truth},
                                  {"estimate", p.estimate},
                                  {"ci95", {p.low, p.high}},
                                  {"covered", p.covered()}});
  json["failure"] = score.failure;
  return json;
}

ChallengeScore score_from(const Json& json) {
  ChallengeScore score;
  score.name = json.at("name"), score.family = family_named(json.at("family")), score.mode = json.at("mode"),
  score.noise = json.at("noise");
  score.truth = json.at("truth").get<std::vector<std::string>>();
  score.named = json.at("named").get<std::vector<std::string>>();
  score.alternatives = json.at("alternatives").get<std::vector<std::vector<std::string>>>();
  score.verdict = json.at("verdict"), score.seconds = json.at("seconds"), score.failure = json.at("failure");
  // What is not finite is written as null.
  const auto number = [](const Json& value) {
    return value.is_number() ? value.get<double>() : std::nan("");
  };
  score.overlap = number(json.at("overlap"));
  score.held_out_before = number(json.at("held_out_before")),
  score.held_out_after = number(json.at("held_out_after"));
  const Json& baselines = json.at("baselines");
  score.baselines = {number(baselines.at("simulation")), number(baselines.at("sparse_regression")),
                     number(baselines.at("gaussian_process")),
                     baselines.at("terms").get<std::vector<std::string>>()};
  for (const auto& p : json.at("parameters"))
    score.parameters.push_back({p.at("name"), number(p.at("truth")), number(p.at("estimate")),
                                number(p.at("ci95")[0]), number(p.at("ci95")[1])});
  return score;
}

}  // namespace asperity
