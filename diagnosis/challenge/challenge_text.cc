// The challenge's result as Markdown and JSON.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "core/joined.h"
#include "core/printed.h"
#include "diagnosis/challenge/challenge.h"

namespace asperity {
namespace {

using Scores = std::vector<ChallengeScore>;
using Condition = std::function<bool(const ChallengeScore&)>;

struct Rate {
  int hits = 0, all = 0;
  double value() const { return all ? static_cast<double>(hits) / all : std::nan(""); }
};

Rate rate(const Scores& scores, const Condition& counts, const Condition& hits) {
  Rate result;
  for (const auto& score : scores)
    if (counts(score)) ++result.all, result.hits += hits(score);
  return result;
}

Condition family(const std::string& name) {
  return [name](const ChallengeScore& score) { return score.family == name; };
}
bool is_right(const ChallengeScore& score) { return score.is_right(); }

std::string percent(const Rate& rate) {
  return rate.all ? printed("%.1f %% (%d of %d)", 100 * rate.value(), rate.hits, rate.all) : "– (0)";
}

std::string number(double value, const char* format = "%.3g") {
  return std::isfinite(value) ? printed(format, value) : "–";
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto i = static_cast<std::size_t>(place);
  return i + 1 < values.size() ? values[i] + (values[i + 1] - values[i]) * (place - static_cast<double>(i))
                               : values[i];
}

std::vector<double> overlaps(const Scores& scores) {
  std::vector<double> values;
  for (const auto& score : scores)
    if (score.overlap >= 0 && score.family != "null" && score.failure.empty())
      values.push_back(score.overlap);
  return values;
}

/// Effects whose truth follows another law than the catalogue's, so that even without noise their parameters
/// would not agree.
bool has_another_law(const ScoredParameter& parameter) {
  static const std::set<std::string> effects{"adhesion",  "adhesion_hysteresis", "bulk_plasticity",
                                             "creep",     "rate_and_state",      "run_in",
                                             "stick_slip"};
  return effects.count(parameter.name.substr(0, parameter.name.find('/'))) > 0;
}

Rate coverage(const Scores& scores, const std::function<bool(const ScoredParameter&)>& counts) {
  Rate result;
  for (const auto& score : scores)
    for (const auto& parameter : score.parameters)
      if (counts(parameter)) ++result.all, result.hits += parameter.covered();
  return result;
}

std::string rates_table(const Scores& scores) {
  const auto row = [](const std::string& what, const std::string& reached, const std::string& target) {
    return "| " + what + " | " + reached + " | " + target + " |\n";
  };
  const auto overlap = overlaps(scores);
  std::string text = "| | reached | target |\n| --- | --- | --- |\n";
  text += row("single effects named exactly", percent(rate(scores, family("single"), is_right)), "95 %");
  text += row("effects in histories of finite elements named exactly, or kept clean",
              percent(rate(scores, family("finite_elements"), is_right)), "95 %");
  text += row("yielding and roughness by other codes' solutions named exactly",
              percent(rate(scores, family("other_code"), is_right)), "90 %");
  text += row("pairs named exactly", percent(rate(scores, family("pair"), is_right)), "85 %");
  text += row("nulls kept clean", percent(rate(scores, family("null"), is_right)), "97 %");
  text +=
      row("out-of-catalogue effects admitted (unexplained, or partly explained with what remains located)",
          percent(rate(scores, family(out_of_catalogue), is_right)), "90 %");
  text += row("of these without naming anything",
              percent(rate(scores, family(out_of_catalogue),
                           [](const auto& s) { return s.verdict == "unexplained"; })),
              "–");
  text += row("decoys named as what they are", percent(rate(scores, family("decoy"), is_right)), "–");
  text += row("indistinguishable settings called ambiguous, with the truth among the candidates",
              percent(rate(scores, family("indistinguishable"), is_right)), "–");
  text += row("coverage of the 95 % intervals", percent(coverage(scores, [](const auto&) { return true; })),
              "90 to 98 %");
  text += row("of these where truth and catalogue follow one law",
              percent(coverage(scores, [](const auto& p) { return !has_another_law(p); })), "–");
  const double mean_overlap = std::accumulate(overlap.begin(), overlap.end(), 0.0) /
                              static_cast<double>(overlap.size());  // NaN where there is none
  text += row("overlap of located and true region, mean (median)",
              number(mean_overlap) + " (" + number(quantile(overlap, 0.5)) + ")", "0.7");
  return text;
}

/// Column of the confusion matrix that an answer belongs to.
std::string answer_of(const ChallengeScore& score) {
  if (!score.failure.empty()) return "failed";
  if (score.verdict == "no_mismatch" || score.verdict == "unexplained") return score.verdict;
  if (score.verdict == "ambiguous")
    return score.holds_the_truth() ? "ambiguous with it" : "ambiguous without it";
  if (score.names_the_truth()) return score.verdict == "explained" ? "itself, explained" : "itself, partly";
  const std::set<std::string> named(score.named.begin(), score.named.end());
  const bool holds = !score.truth.empty() && std::all_of(score.truth.begin(), score.truth.end(),
                                                         [&](const auto& id) { return named.count(id) > 0; });
  const bool some = std::any_of(score.truth.begin(), score.truth.end(),
                                [&](const auto& id) { return named.count(id) > 0; });
  return holds ? "more than it" : some ? "a part of it" : "something else";
}

std::string confusion_table(const Scores& scores) {
  const std::vector<std::string> columns{
      "itself, explained", "itself, partly", "ambiguous with it", "ambiguous without it", "more than it",
      "a part of it",      "something else", "unexplained",       "no_mismatch",          "failed"};
  std::vector<std::pair<std::string, std::map<std::string, int>>> rows;
  for (const auto& score : scores) {
    const std::string truth = score.family + ": " + joined(score.truth, " + ", "noise alone");
    auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.first == truth; });
    if (found == rows.end()) found = rows.insert(rows.end(), {truth, {}});
    ++found->second[answer_of(score)];
  }
  std::string text = "| truth", line = "| ---";
  for (const auto& column : columns) text += " | " + column, line += " | ---";
  text += " |\n" + line + " |\n";
  for (const auto& [truth, counts] : rows) {
    text += "| " + truth;
    for (const auto& column : columns)
      text += " | " + (counts.count(column) ? std::to_string(counts.at(column)) : std::string());
    text += " |\n";
  }
  return text;
}

std::string wrong_answers(const Scores& scores) {
  std::string text;
  for (const auto& score : scores) {
    if (score.is_right()) continue;
    text += "- " + score.name + ", noise " + number(score.noise) + ": " + score.verdict + ", " +
            joined(score.named, " + ", "nothing");
    if (!score.alternatives.empty()) {
      text += "; alternatives";
      for (const auto& alternative : score.alternatives) text += ", " + joined(alternative, " + ", "nothing");
    }
    if (!score.failure.empty()) text += " (" + score.failure + ")";
    text += "\n";
  }
  return text.empty() ? "None.\n" : text;
}

std::string parameter_table(const Scores& scores) {
  std::map<std::string, std::vector<const ScoredParameter*>> by_name;
  for (const auto& score : scores)
    for (const auto& parameter : score.parameters) by_name[parameter.name].push_back(&parameter);
  std::string text =
      "| parameter | recordings | error, median | error, worst | covered |\n| --- | --- | --- | --- | --- "
      "|\n";
  for (const auto& [name, list] : by_name) {
    std::vector<double> errors;
    Rate covered;
    for (const auto* parameter : list) {
      errors.push_back(std::abs(parameter->estimate / parameter->truth - 1) * 100);
      ++covered.all, covered.hits += parameter->covered();
    }
    text += "| " + name + " | " + std::to_string(list.size()) + " | " + number(quantile(errors, 0.5)) +
            " % | " + number(quantile(errors, 1)) + " % | " + std::to_string(covered.hits) + " of " +
            std::to_string(covered.all) + " |\n";
  }
  return text;
}

std::string baseline_table(const Scores& scores) {
  std::string text =
      "| held-out reduced chi², median | simulation alone | with the named effects | simulation alone "
      "(baselines' blocks) | sparse regression | Gaussian process |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const char* name : {"single", "finite_elements", "other_code", "pair", "null", out_of_catalogue,
                           "decoy", "indistinguishable"}) {
    std::vector<double> before, after, alone, sparse, process;
    for (const auto& score : scores) {
      if (score.family != name || !score.failure.empty()) continue;
      before.push_back(score.held_out_before), after.push_back(score.held_out_after),
          alone.push_back(score.baselines.simulation);
      sparse.push_back(score.baselines.sparse_regression),
          process.push_back(score.baselines.gaussian_process);
    }
    if (before.empty()) continue;
    text += std::string("| ") + name;
    for (const auto* values : {&before, &after, &alone, &sparse, &process})
      text += " | " + number(quantile(*values, 0.5));
    text += " |\n";
  }
  return text;
}

}  // namespace

std::string challenge_text(const std::vector<ChallengeScore>& scores) {
  double seconds = 0, slowest = 0;
  for (const auto& score : scores) seconds += score.seconds, slowest = std::max(slowest, score.seconds);
  return std::to_string(scores.size()) + " recordings, " + number(seconds / 60) +
         " minutes of diagnosis in all, the slowest " + number(slowest) + " s.\n\n" + rates_table(scores) +
         "\nTruth against answer:\n\n" + confusion_table(scores) +
         "\nParameters of effects named rightly:\n\n" + parameter_table(scores) +
         "\nBlocks that were not seen, predicted by the simulation, by the named effects, and by what a user "
         "would try first:\n\n" +
         baseline_table(scores) + "\nAnswers that are not right:\n\n" + wrong_answers(scores);
}

std::string challenge_json(const std::vector<ChallengeScore>& scores) {
  nlohmann::ordered_json json{{"format", "asperity-challenge/1"},
                              {"scores", nlohmann::ordered_json::array()}};
  for (const auto& score : scores) json["scores"].push_back(score_json(score));
  return json.dump(1) + "\n";
}

}  // namespace asperity
