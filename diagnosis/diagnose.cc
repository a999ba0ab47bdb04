// The whole diagnosis, step by step.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <set>

#include "core/error.h"
#include "diagnosis/choose/held_out.h"
#include "diagnosis/choose/law_error.h"
#include "diagnosis/choose/search.h"
#include "diagnosis/choose/tell_apart.h"
#include "diagnosis/diagnosis.h"
#include "diagnosis/locate/scan.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Samples on which a search is made before its last steps are taken on all.
constexpr std::size_t samples_of_search = 800;
/// Probability of calling noise a mismatch.
constexpr double significance = 0.005;
/// Log evidence by which an effect must be better than none, and a set than one with a member less.
constexpr double clear_evidence = 8, evidence_for_another = 4;
/// Log evidence within which two explanations are as good.
constexpr double as_good = 2.3;  // odds of ten to one
/// Part of the mismatch that a further effect must explain, where the set then leaves noise and where it does not: less is what
/// laws of this kind are off by.
constexpr double least_part = 0.03, least_part_of_incomplete = 0.1;
/// Part of the excess of held-out data that one, two, three effects must take away to be named though structure remains: with more
/// of them, something that none of them is can be imitated better.
constexpr double part_that_counts[] = {0, 0.7, 0.95, 0.98};
/// How much worse held-out data may be predicted, relative, by an explanation that counts as equal.
constexpr double held_out_equal = 1.05;

std::vector<double> residual_of(const FitProblem& problem, const ModelFit& fit) {
  return FitProblem::residual(problem.samples, fit.simulate(problem.samples));
}

/// The interval with what the laws may be off by in it: two standard deviations are taken for the accuracy.
DiagnosedParameter widened(DiagnosedParameter p, const FreeParameter& free, double accuracy) {
  const double law = accuracy * std::abs(p.value);
  p.low = std::max(free.low, p.value - std::hypot(p.value - p.low, law));
  p.high = std::min(free.high, p.value + std::hypot(p.high - p.value, law));
  return p;
}

class Diagnoser {
 public:
  Diagnoser(const Recording& recording, const DiagnoseOptions& options) : recording_(recording), options_(options) {}

  Diagnosis run() {
    prepare();
    simulate_alone();
    say("locating the mismatch");
    auto scanner_of_noise = std::make_unique<Scanner>(problem_.samples, problem_.experiment, problem_.noise, options_.seed);
    const IsNoise is_noise = [&](const ModelFit& fit) { return remaining(*scanner_of_noise, fit).p_value > significance; };
    search_ = search_effects(problem_, baseline_, is_noise, options_.progress);
    // What the best explanation leaves tells most about the noise.
    const bool explains = !search_.candidates.empty() && search_.candidates.front().score > search_.alone.score;
    if (explains && learn_noise(residual_of(problem_, search_.candidates.front().fit))) {
      rescore(search_, problem_);
      baseline_ = search_.alone.fit;
      scanner_of_noise = std::make_unique<Scanner>(problem_.samples, problem_.experiment, problem_.noise, options_.seed);
    }
    const Scanner& scanner = *scanner_of_noise;
    const ScanResult before = scanner.scan(problem_.baseline_residual);
    const bool seems_noise = !problem_.noise.is_absolute || before.p_value > significance;
    blocks_ = blocks_of(problem_.samples);
    say("predicting data kept out of the fit");
    baseline_held_out_ = predict_held_out(problem_, finished(baseline_), blocks_);
    const Candidate* best = choose(scanner);
    describe_common(before);
    if (!best) {
      result_.verdict = seems_noise ? Verdict::no_mismatch : Verdict::unexplained;
      result_.improved = result_.baseline;
      if (!seems_noise) result_.remaining = before.regions;
      else result_.mismatch.clear();
      compare(baseline_, baseline_);
      speak();
      return result_;
    }
    judge(*best, scanner);
    speak();
    return result_;
  }

 private:
  void say(const std::string& what) const {
    if (options_.progress) options_.progress(what);
  }

  void prepare() {
    check_recording(recording_);
    say("reading " + std::to_string(recording_.tables.size()) + (recording_.tables.size() == 1 ? " table" : " tables"));
    problem_.samples = samples_of(recording_);
    problem_.experiment = experiment_of(recording_, problem_.samples);
    if (!(problem_.experiment.largest_force > 0))
      throw InputError("no sample presses: the largest normal force is not above zero; check the sign (compression is positive)");
    if (problem_.experiment.largest_response <= 0) throw InputError("the response is zero throughout; check the column");
    problem_.choice = completed(recording_.simulation, problem_.experiment);
  }

  /// The recording's own simulation, calibrated as it says; then what is noise and what is an outlier.
  void simulate_alone() {
    say("simulating " + std::to_string(problem_.samples.list.size()) + " samples with the laws named");
    std::vector<double> recorded(problem_.samples.list.size());
    for (std::size_t i = 0; i < recorded.size(); ++i) recorded[i] = problem_.samples.list[i].response;
    const Noise recorded_noise = problem_.noise = estimate_noise(recording_, problem_.samples, recorded);
    constexpr int rounds = 2;  // a first noise to fit with, then that of the fit's own residuals
    for (int round = 0; round < rounds; ++round) {
      if (round == 0 && problem_.experiment.mode != Mode::normal) mark_beginnings(problem_.samples, problem_.noise);
      problem_.thin = thinned(problem_.samples, samples_of_search);
      problem_.baseline_residual.clear();
      baseline_ = fit_explanation(problem_, {});
      problem_.baseline_residual = residual_of(problem_, baseline_);
      Noise again = estimate_noise(recording_, problem_.samples, problem_.baseline_residual);
      // A simulation that is far off, or driven by a noisy displacement, adds structure at short distances: the smoother of both, the
      // recorded signal and its residual, holds the noise.
      if (again.sd.front() < recorded_noise.sd.front() || !again.is_absolute) problem_.noise = again;
      else problem_.noise = recorded_noise;
      if (round == 0) outliers_ = mark_outliers(problem_.samples, problem_.baseline_residual, problem_.noise);
    }
    problem_.thin = thinned(problem_.samples, samples_of_search);
    short_scale_noise_ = problem_.noise;
    learn_noise(problem_.baseline_residual);
    baseline_ = fit_explanation(problem_, {});
    problem_.baseline_residual = residual_of(problem_, baseline_);
  }

  bool learn_noise(const std::vector<double>& residual) {
    Noise learned = short_scale_noise_;
    if (!refine_noise(problem_.samples, residual, learned)) return false;
    problem_.noise = learned;
    return true;
  }

  ModelFit finished(const ModelFit& fit) const { return refitted(problem_, fit, problem_.samples, true, 3); }

  /// What an explanation leaves, beyond what its laws may be off by.
  ScanResult remaining(const Scanner& scanner, const ModelFit& fit) const {
    const auto residual = residual_of(problem_, fit);
    return scanner.scan(residual, law_error(problem_, fit, baseline_));
  }

  double excess(const ModelFit& fit) const { return std::max(0.0, fit.cost - static_cast<double>(fit.count)); }

  const Candidate* find(const Effects& effects) const {
    const std::set<const Effect*> wanted(effects.begin(), effects.end());
    for (const auto& candidate : search_.candidates) {
      const auto& have = candidate.fit.explanation->effects();
      if (std::set<const Effect*>(have.begin(), have.end()) == wanted) return &candidate;
    }
    return nullptr;
  }

  bool leaves_noise(const Scanner& scanner, const ModelFit& fit) const { return remaining(scanner, fit).p_value > significance; }

  /// Every member earns its place: without it the evidence is clearly less, and a part of the mismatch comes back that is either
  /// large or more than the laws of the others may be off by.
  bool every_member_counts(const Candidate& candidate, const Scanner& scanner) const {
    const auto& effects = candidate.fit.explanation->effects();
    for (std::size_t k = 0; k < effects.size(); ++k) {
      Effects without = effects;
      without.erase(without.begin() + static_cast<long>(k));
      const Candidate* smaller = without.empty() ? &search_.alone : find(without);
      if (!smaller) continue;
      if (candidate.score < smaller->score + (without.empty() ? clear_evidence : evidence_for_another)) return false;
      const double gained = (smaller->cost - candidate.cost) / search_.overdispersion;
      if (without.empty()) continue;
      const double whole = excess(search_.alone.fit) / search_.overdispersion;
      const bool complete = leaves_noise(scanner, candidate.fit);
      if (!complete && gained < least_part_of_incomplete * whole) return false;
      if (complete && gained < least_part * whole && leaves_noise(scanner, smaller->fit)) return false;
    }
    return true;
  }

  struct Judged {
    const Candidate* candidate;
    ModelFit fit;
    HeldOut held_out;
  };

  /// The best set that predicts held-out data better than the simulation alone, with parameters that hold everywhere.
  const Candidate* choose(const Scanner& scanner) {
    constexpr std::size_t most_judged = 6;
    for (const auto& candidate : search_.candidates) {
      if (judged_.size() == most_judged) break;
      if (candidate.score < search_.alone.score + clear_evidence) break;
      if (!judged_.empty() && candidate.score < judged_.front().candidate->score - 4 * as_good) break;
      if (!candidate.fit.is_itself() || !every_member_counts(candidate, scanner)) continue;
      Judged judged{&candidate, finished(candidate.fit), {}};
      judged.held_out = predict_held_out(problem_, judged.fit, blocks_);
      if (!judged.held_out.consistent) {
        inconsistent_.push_back(candidate.fit.explanation->name());
        continue;
      }
      if (!(judged.held_out.cost < baseline_held_out_.cost)) continue;
      judged_.push_back(std::move(judged));
    }
    return judged_.empty() ? nullptr : judged_.front().candidate;
  }

  bool holds_all_of(const Candidate& larger, const Candidate& smaller) const {
    for (const Effect* effect : smaller.fit.explanation->effects()) {
      const auto& have = larger.fit.explanation->effects();
      if (std::find(have.begin(), have.end(), effect) == have.end()) return false;
    }
    return true;
  }

  void judge(const Candidate& best, const Scanner& scanner) {
    const Judged& chosen = judged_.front();
    const ScanResult left = remaining(scanner, chosen.fit);
    const bool clean = !problem_.noise.is_absolute || left.p_value > significance;
    const auto residual = residual_of(problem_, chosen.fit);
    result_.improved = quality(residual, chosen.held_out);
    if (!clean) result_.remaining = left.regions;

    // Rivals: other sets, none of which is the chosen one with something added or left out.
    std::vector<const Judged*> rivals;
    double weight = 1;
    for (const auto& other : judged_) {
      if (other.candidate == &best || holds_all_of(*other.candidate, best) || holds_all_of(best, *other.candidate)) continue;
      weight += std::exp(other.candidate->score - best.score);
      rivals.push_back(&other);
    }
    bool ambiguous = false;
    for (const Judged* rival : rivals) {
      const double difference = best.score - rival->candidate->score;
      const bool predicts_as_well = rival->held_out.cost <= held_out_equal * std::max(1.0, chosen.held_out.cost);  // below 1 both are noise
      AlternativeExplanation alternative;
      alternative.probability = std::exp(-difference) / weight;
      alternative.held_out_chi2_reduced = rival->held_out.chi2_reduced;
      alternative.effects = described(rival->fit, alternative.probability);
      if (difference < as_good && predicts_as_well) ambiguous = true;
      if (difference < 2 * as_good && predicts_as_well)
        alternative.told_apart_by = experiment_that_tells_apart(problem_, chosen.fit, rival->fit);
      else alternative.told_apart_by = "these data tell them apart";
      result_.alternatives.push_back(alternative);
    }
    const double gained = (baseline_held_out_.cost - chosen.held_out.cost) / std::max(1e-12, baseline_held_out_.cost - std::min(1.0, chosen.held_out.cost));
    if (!clean && gained < part_that_counts[std::min<std::size_t>(3, best.fit.explanation->effects().size())]) {
      result_.verdict = Verdict::unexplained;
      result_.remarks.push_back("the nearest of the catalogue, " + best.fit.explanation->name() + ", takes away only part of the mismatch and is not named");
      result_.alternatives.clear();
      result_.improved = result_.baseline;
      result_.remaining = result_.mismatch;
      compare(baseline_, baseline_);
      return;
    }
    result_.left_out = described(chosen.fit, 1 / weight);
    if (ambiguous) {
      result_.verdict = Verdict::ambiguous;
      AlternativeExplanation first{result_.left_out, 1 / weight, chosen.held_out.chi2_reduced,
                                   result_.alternatives.empty() ? "" : result_.alternatives.front().told_apart_by};
      result_.alternatives.insert(result_.alternatives.begin(), first);
    } else {
      result_.verdict = clean ? Verdict::explained : Verdict::partly_explained;
    }
    compare(baseline_, chosen.fit);
  }

  std::vector<DiagnosedEffect> described(const ModelFit& fit, double probability) const {
    std::vector<DiagnosedEffect> list;
    const auto& effects = fit.explanation->effects();
    const double inflation = std::max(1.0, fit.cost / static_cast<double>(std::max<std::size_t>(1, fit.count))) *
                             shared_variance(problem_.samples, residual_of(problem_, fit), problem_.noise);
    const ModelFit known = with_intervals(problem_, fit);
    const double accuracy = accuracy_of(fit);
    for (std::size_t e = 0; e < effects.size(); ++e) {
      const EffectDescription& d = effects[e]->description();
      DiagnosedEffect effect{d.id, d.title, d.equation, d.source, d.meaning, d.kind, probability, {}};
      for (std::size_t k = 0; k < fit.values.size(); ++k)
        if (fit.explanation->parameters()[k].effect == static_cast<int>(e)) effect.parameters.push_back(widened(known.parameter(k, inflation), fit.explanation->parameters()[k], accuracy));
      list.push_back(effect);
    }
    return list;
  }

  FitQuality quality(const std::vector<double>& residual, const HeldOut& held_out) const {
    FitQuality q;
    q.chi2_reduced = chi2_reduced(problem_.samples, residual, problem_.noise);
    q.held_out_chi2_reduced = held_out.chi2_reduced;
    std::map<std::string, std::pair<double, double>> sums;
    for (const auto& run : problem_.samples.runs)
      for (std::size_t i = run.begin; i < run.end; ++i)
        if (problem_.samples.list[i].counts) {
          auto& [sum, count] = sums[problem_.samples.response_channels[run.table]];
          sum += residual[i] * residual[i];
          ++count;
        }
    for (const auto& [channel, sum] : sums) q.rms[channel] = std::sqrt(sum.first / sum.second);
    return q;
  }

  void describe_common(const ScanResult& before) {
    result_.mismatch = before.regions;
    result_.baseline = quality(problem_.baseline_residual, baseline_held_out_);
    const ModelFit calibrated = finished(baseline_);
    for (std::size_t k = 0; k < calibrated.values.size(); ++k) result_.calibrated.push_back(calibrated.parameter(k, 1));
    for (std::size_t t = 0; t < problem_.samples.table_names.size(); ++t) {
      const std::string& channel = problem_.samples.response_channels[t];
      if (result_.noise.count(channel)) continue;
      std::vector<double> sd;
      for (const auto& run : problem_.samples.runs)
        if (run.table == t)
          for (std::size_t i = run.begin; i < run.end; ++i) sd.push_back(problem_.noise.sd[i]);
      std::nth_element(sd.begin(), sd.begin() + static_cast<long>(sd.size() / 2), sd.end());
      result_.noise[channel] = {sd[sd.size() / 2], unit_of_channel(channel), problem_.noise.from[t]};
    }
    double correlation = 0;
    for (const SharedNoise& shared : problem_.noise.shared) correlation = std::max(correlation, shared.neighbours());
    char text[160];
    constexpr double worth_saying = 0.1;
    if (correlation > worth_saying) {
      std::snprintf(text, sizeof text, "neighbouring samples share their noise (correlation %.2f), so that they count as fewer", correlation);
      result_.remarks.push_back(text);
    }
    if (outliers_ > 0) result_.remarks.push_back(std::to_string(outliers_) + (outliers_ == 1 ? " sample lies" : " samples lie") + " far off their neighbours and do not count");
    if (!problem_.noise.is_absolute)
      result_.remarks.push_back("the noise is not known and too few rows repeat to estimate it: explanations are compared with each other, but whether the "
                                "best is good enough cannot be tested; give 'noise' or a column of standard deviations");
    for (std::size_t i = 0; i < std::min<std::size_t>(3, inconsistent_.size()); ++i)
      result_.remarks.push_back(inconsistent_[i] + " would fit only with other parameters in different parts of the data and was rejected");
  }

  /// Curves for the report.
  void compare(const ModelFit& before, const ModelFit& after) {
    const auto simulated_before = before.simulate(problem_.samples), simulated_after = after.simulate(problem_.samples);
    for (std::size_t t = 0; t < problem_.samples.table_names.size(); ++t) {
      ComparedTable table;
      table.table = problem_.samples.table_names[t];
      table.channel = problem_.samples.response_channels[t];
      table.unit = unit_of_channel(table.channel);
      const RecordingTable& source = recording_.tables[t];
      table.variable = source.control.front();
      table.variable_unit = unit_of_channel(table.variable);
      for (const auto& run : problem_.samples.runs) {
        if (run.table != t) continue;
        table.is_series = run.independent_rows;
        for (std::size_t i = run.begin; i < run.end; ++i) {
          const Sample& s = problem_.samples.list[i];
          if (!s.counts) continue;
          table.x.push_back(source.column(table.variable)[static_cast<std::size_t>(s.row)]);
          table.recorded.push_back(s.response);
          table.before.push_back(simulated_before[i]);
          table.after.push_back(simulated_after[i]);
          table.sd.push_back(problem_.noise.sd[i]);
          table.curve.push_back(s.part);
          table.segment.push_back(problem_.samples.segment_names[static_cast<std::size_t>(s.segment)]);
        }
      }
      result_.compared.push_back(std::move(table));
    }
  }

  void speak();

  const Recording& recording_;
  const DiagnoseOptions& options_;
  FitProblem problem_;
  Noise short_scale_noise_;  ///< before anything is learned from residuals that are noise
  ModelFit baseline_;
  std::size_t outliers_ = 0;
  SearchResult search_;
  Blocks blocks_;
  HeldOut baseline_held_out_;
  std::vector<Judged> judged_;
  std::vector<std::string> inconsistent_;
  Diagnosis result_;
};

std::string titles(const std::vector<DiagnosedEffect>& effects) {
  std::string text;
  for (std::size_t i = 0; i < effects.size(); ++i) text += (i == 0 ? "" : i + 1 == effects.size() ? " and " : ", ") + effects[i].id;
  return text;
}

void Diagnoser::speak() {
  Diagnosis& d = result_;
  char numbers[200];
  std::snprintf(numbers, sizeof numbers, "chi-square per sample falls from %.3g to %.3g (data kept out of the fit: %.3g to %.3g)",
                d.baseline.chi2_reduced, d.improved.chi2_reduced, d.baseline.held_out_chi2_reduced, d.improved.held_out_chi2_reduced);
  switch (d.verdict) {
    case Verdict::no_mismatch:
      d.in_words = "Recording and simulation agree: what is left is noise. Nothing was left out that these data can show.";
      break;
    case Verdict::explained:
      d.in_words = "The simulation left out " + titles(d.left_out) + ". With it " + numbers + ", which is noise.";
      break;
    case Verdict::partly_explained:
      d.in_words = "The simulation left out " + titles(d.left_out) + ", and something more. With what is named " + numbers + "; structure remains.";
      break;
    case Verdict::ambiguous:
      d.in_words = "Something was left out, and these data cannot say which of " + std::to_string(1 + static_cast<int>(std::count_if(
                       d.alternatives.begin() + 1, d.alternatives.end(), [&](const auto& a) { return a.probability * std::exp(as_good) > d.alternatives.front().probability; }))) +
                   " explanations it is. With the likeliest, " + titles(d.left_out) + ", " + numbers + ".";
      break;
    case Verdict::unexplained:
      d.in_words = "Recording and simulation part, and no effect of the catalogue explains it. The mismatch is located; what it is remains open.";
      break;
  }
}

}  // namespace

std::string name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::no_mismatch: return "no_mismatch";
    case Verdict::explained: return "explained";
    case Verdict::partly_explained: return "partly_explained";
    case Verdict::ambiguous: return "ambiguous";
    case Verdict::unexplained: return "unexplained";
  }
  return "";
}

Diagnosis diagnose(const Recording& recording, const DiagnoseOptions& options) { return Diagnoser(recording, options).run(); }

}  // namespace asperity
