#include "diagnosis/choose/judged_sets.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/choose/members.h"

namespace asperity {
namespace {

constexpr std::size_t most_judged = 6;

/// How far two fits are apart in all samples that count together, in deviations of their noise.
double apart(const FitProblem& problem, const ModelFit& one, const ModelFit& other) {
  const std::vector<double> a = one.simulate(problem.samples), b = other.simulate(problem.samples);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (problem.samples.list[i].counts) sum += std::pow((a[i] - b[i]) / problem.noise.sd[i], 2);
  return std::sqrt(sum);
}

/// Mean square of what the solution may be off by, in deviations of noise [-].
double mesh_over_noise(const FitProblem& problem, const ModelFit& fit) {
  if (!fit.explanation->correction()) return 0;
  const auto errors = mesh_errors(fit, problem.samples);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < problem.samples.list.size(); ++i) {
    if (!problem.samples.list[i].counts) continue;
    for (const LawError& error : errors) sum += std::pow(error[i] / problem.noise.sd[i], 2);
    ++count;
  }
  return sum / std::max(1.0, count);
}

/// A layer's parameters may differ between parts of the data by what its law is off by; beside another effect
/// that could be what the other one lacks.
bool differs_by_its_law(const FitProblem& problem, const Candidate& candidate, const Blocks& blocks) {
  if (candidate.where_mended) return predict_held_out(problem, *candidate.where_mended, blocks).consistent;
  if (!is_layer(candidate.fit) || candidate.fit.explanation->effects().size() > 1) return false;
  const double off_by =
      candidate.fit.cost / static_cast<double>(std::max<std::size_t>(1, candidate.fit.count));
  return predict_held_out(problem, candidate.fit, blocks, std::sqrt(std::max(1.0, off_by))).consistent;
}

/// Whether one of no more effects does better by far and was rejected, of sets that leave more than noise:
/// what imitates the truth less well is not it either.
bool is_worse_than_rejected(const FitProblem& problem, const SearchResult& search, const Scanner& scanner,
                            const Candidate& candidate, const std::vector<const Candidate*>& rejected) {
  const auto is_worse_than = [&](const Candidate* other) {
    return search.others_in(other->fit) <= search.others_in(candidate.fit) &&
           is_far_behind(candidate, *other);
  };
  return std::any_of(rejected.begin(), rejected.end(), is_worse_than) &&
         !leaves_noise(problem, search, scanner, candidate);
}

}  // namespace

bool JudgedSet::is_part_of(const JudgedSet& other) const {
  const auto& have = other.candidate->fit.explanation->effects();
  const auto& own = candidate->fit.explanation->effects();
  return std::all_of(own.begin(), own.end(), [&](const Effect* effect) {
    return std::find(have.begin(), have.end(), effect) != have.end();
  });
}

std::vector<const JudgedSet*> JudgedSets::rivals_of(const JudgedSet& chosen) const {
  std::vector<const JudgedSet*> rivals;
  for (const JudgedSet& other : list)
    if (!other.is_part_of(chosen) && !chosen.is_part_of(other)) rivals.push_back(&other);
  return rivals;
}

Rivalry rivalry(const FitProblem& problem, const JudgedSet& chosen, const JudgedSet& other) {
  constexpr double equal = 1.05;  // of held-out cost, which is noise below 1
  constexpr double same = 2;      // deviations by which all samples together would tell them apart
  const double difference = chosen.candidate->score - other.candidate->score;
  // A solution that is off by more than noise predicts no set better than by a part of that.
  constexpr double part_of_mesh = 0.25;
  const double by_mesh = part_of_mesh * part_of_mesh * mesh_over_noise(problem, chosen.fit);
  const bool predicts_as_well = other.held_out.cost <= equal * std::max(1.0, chosen.held_out.cost) + by_mesh;
  const bool is_ahead = would_be_ahead(*other.candidate, *chosen.candidate);
  // One of more parameters that imitates the chosen one is no rival of it.
  const bool is_same = difference < 2 * as_good && other.fit.values.size() <= chosen.fit.values.size() &&
                       apart(problem, chosen.fit, other.fit) < same;
  const double odds = are_layers(chosen.fit, other.fit) ? 2 * as_good : as_good;
  return {difference, (difference < odds && predicts_as_well) || is_same || is_ahead,
          (difference < 2 * as_good && predicts_as_well) || is_same || is_ahead};
}

JudgedSets judged_sets(const FitProblem& problem, SearchResult& search, const Scanner& scanner,
                       const Blocks& blocks, const HeldOut& baseline_held_out,
                       const std::function<bool(const ModelFit&)>& is_no_effect) {
  credit_layers(problem, scanner, search);
  JudgedSets judged;
  std::vector<const Candidate*> rejected;
  for (const auto& candidate : search.candidates) {
    if (judged.list.size() == most_judged) break;
    if (candidate.score < search.alone.score + clear_evidence) break;
    const auto members = static_cast<double>(search.others_in(candidate.fit));
    if (candidate.score < search.alone.score + members * clear_evidence) continue;
    if (!judged.list.empty() && is_far_behind(candidate, *judged.list.front().candidate)) continue;
    if (!search.holds_what_is_off_contact(candidate.fit)) continue;
    if (is_worse_than_rejected(problem, search, scanner, candidate, rejected)) continue;
    if (!candidate.fit.is_itself() || !members_of(problem, search, scanner, candidate).count) continue;
    JudgedSet set{&candidate, finished(problem, candidate.fit), {}};
    if (const std::string parameter = set.fit.stopped_at(); !parameter.empty()) {
      judged.stopped.push_back(candidate.fit.explanation->name() + " (" + parameter + ")");
      continue;
    }
    if (set.fit.holds_no_effect(search.overdispersion) || (is_no_effect && is_no_effect(set.fit))) continue;
    set.held_out = predict_held_out(problem, set.fit, blocks);
    if (!set.held_out.consistent) set.held_out.consistent = differs_by_its_law(problem, candidate, blocks);
    if (!set.held_out.consistent) {
      judged.inconsistent.push_back(candidate.fit.explanation->name());
      rejected.push_back(&candidate);
    } else if (set.held_out.cost < baseline_held_out.cost)
      judged.list.push_back(std::move(set));
  }
  return judged;
}

}  // namespace asperity
