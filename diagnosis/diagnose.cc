// The whole diagnosis, step by step.
#include "diagnosis/diagnose.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/choose/evidence.h"
#include "diagnosis/choose/judged_sets.h"
#include "diagnosis/choose/law_error.h"
#include "diagnosis/choose/search_with_deviations.h"
#include "diagnosis/choose/tell_apart.h"
#include "diagnosis/describe.h"
#include "diagnosis/fit/likely_surface.h"
#include "diagnosis/fit/prepared_fit.h"
#include "diagnosis/mapping/solved_case_mapping.h"
#include "diagnosis/open_alternatives.h"
#include "diagnosis/remarks.h"

namespace asperity {
namespace {

/// Part of the excess of held-out data that one, two, three effects (beside what samples off contact show by
/// themselves) must take away to be named though structure remains: with more of them, something that none of
/// them is can be imitated better.
constexpr double part_that_counts[] = {0, 0.7, 0.95, 0.98};

class Diagnoser {
 public:
  /// `mapping`: null where reduced laws are the simulation.
  Diagnoser(const Recording& recording, const DiagnoseOptions& options, SolvedCaseMapping* mapping)
      : recording_(recording),
        options_(options),
        mapping_(mapping),
        prepared_(prepared_fit(
            recording, options.progress,
            mapping ? MakeCorrection([mapping](FitProblem& problem) { mapping->correct(problem); })
                    : nullptr)) {}

  Diagnosis run() {
    say("locating the mismatch");
    search_ = search_with_deviations(prepared_, options_.seed, options_.progress);
    auto scanner_of_noise = new_scanner();
    // The residual of the best explanation is the best estimate of the noise.
    if (search_.explains() && learns_noise_from(search_.candidates.front().fit)) {
      rescore(search_, problem_);
      baseline_ = search_.alone.fit;
      scanner_of_noise = new_scanner();
    }
    const Blocks blocks = blocks_of(problem_.samples);
    if (mapping_) {
      confirm(*scanner_of_noise, blocks);
      scanner_of_noise = new_scanner();
    }
    ScanResult before = scan_of_baseline(*scanner_of_noise);
    bool seems_noise = !problem_.noise.is_absolute || is_noise_as_known(problem_, before, baseline_.count);
    say("predicting data kept out of the fit");
    baseline_held_out_ = predict_held_out(problem_, finished(problem_, baseline_), blocks);
    judged_ = judged_sets(
        problem_, search_, *scanner_of_noise, blocks, baseline_held_out_, [&](const ModelFit& fit) {
          return is_described_as_no_effect(problem_, fit, baseline_, search_.shown_off_contact);
        });
    if (judged_.list.empty() && !seems_noise) seems_noise = is_noise_that_neighbours_share(before);
    describe_common(before);
    if (!judged_.list.empty())
      judge(*scanner_of_noise);
    else
      nothing_named(seems_noise ? Verdict::no_mismatch : Verdict::unexplained, before.regions);
    describe_rows();
    if (mapping_) describe_simulation();
    for (auto& effect : effects_without_data(problem_.experiment))
      result_.not_tried.push_back(std::move(effect));
    remark_all(remarks_on_untried(result_));
    result_.in_words = in_words(result_);
    return result_;
  }

 private:
  void say(const std::string& what) const {
    if (options_.progress) options_.progress(what);
  }

  std::unique_ptr<Scanner> new_scanner() const {
    return std::make_unique<Scanner>(problem_.samples, problem_.experiment, problem_.noise, options_.seed);
  }

  /// The residual before physics is added, beyond what a solution of the case may be off by.
  ScanResult scan_of_baseline(const Scanner& scanner) const {
    return problem_.correction ? remaining(problem_, baseline_, scanner, baseline_)
                               : scanner.scan(problem_.baseline_residual, LawError{});
  }

  /// The noise anew from what a fit leaves: where it is near what differences between neighbours show, and
  /// where it is more, but nothing else is left than noise that neighbours share.
  bool learns_noise_from(const ModelFit& fit) {
    const Noise kept = problem_.noise;
    const auto residual = residual_beyond_surfaces(problem_, fit);
    if (prepared_.learn_noise(residual)) return true;
    if (!prepared_.learn_noise(residual, most_off)) return false;
    if (remaining(problem_, baseline_, *new_scanner(), fit).p_value > significance &&
        neighbours_share_no_more(problem_.samples, residual, problem_.noise, baseline_.count))
      return true;
    problem_.noise = kept;
    return false;
  }

  /// Where nothing explains it: whether what is left is noise that neighbours share, most of which
  /// differences between them do not show. If so, the noise is learned from it and `before` scanned anew.
  bool is_noise_that_neighbours_share(ScanResult& before) {
    const Noise kept = problem_.noise;
    const auto& residual = problem_.baseline_residual;
    if (!prepared_.learn_noise(residual, most_off)) return false;
    const ScanResult anew = scan_of_baseline(*new_scanner());
    if (is_noise_as_known(problem_, anew, baseline_.count) &&
        neighbours_share_no_more(problem_.samples, residual, problem_.noise, baseline_.count)) {
      before = anew;
      baseline_held_out_ =
          predict_held_out(problem_, finished(problem_, baseline_), blocks_of(problem_.samples));
      return true;
    }
    problem_.noise = kept;
    return false;
  }

  /// The sets that survive the search by corrected laws, by finite elements; noise anew from the best.
  void confirm(const Scanner& scanner, const Blocks& blocks) {
    const JudgedSets screened =
        judged_sets(problem_, search_, scanner, blocks,
                    predict_held_out(problem_, finished(problem_, baseline_), blocks));
    std::vector<const Candidate*> survivors;
    for (const JudgedSet& set : screened.list) survivors.push_back(set.candidate);
    mapping_->confirm(search_, problem_, survivors);
    if (search_.explains() &&
        prepared_.learn_noise(residual_beyond_surfaces(problem_, search_.candidates.front().fit)))
      rescore(search_, problem_);
    baseline_ = search_.alone.fit;
  }

  /// Whether what is named, or the simulation as it is, leaves less than noise does.
  void describe_rows() {
    const ModelFit& best = result_.left_out.empty() ? baseline_ : judged_.list.front().fit;
    result_.rows_are_points_of_a_curve = lies_on_the_rows(problem_, best);
    if (const std::string remark = remark_on_too_little_noise(problem_, best); !remark.empty())
      result_.remarks.push_back(remark);
  }

  void describe_simulation() {
    describe_in_case(result_.left_out);
    for (const DiagnosedEffect& named : result_.left_out)
      if (const std::string why = effect_of(named.id).why_no_entry(problem_.experiment, named.parameters);
          !why.empty())
        result_.remarks.push_back(why);
    for (auto& alternative : result_.alternatives) describe_in_case(alternative.effects);
    result_.simulation = mapping_->described(result_.left_out.empty() ? nullptr : &judged_.list.front().fit);
    remark_all(mapping_->remarks());
    result_.not_tried = mapping_->effects_without_form(problem_.experiment);
  }

  void describe_in_case(std::vector<DiagnosedEffect>& effects) const {
    mapping_->widen_untested(problem_, effects);
    mapping_->add_case_entries(problem_, effects);
  }

  void remark_all(const std::vector<std::string>& remarks) {
    result_.remarks.insert(result_.remarks.end(), remarks.begin(), remarks.end());
  }

  /// `drawn`: what pictures show beside the simulation alone.
  void compare(const ModelFit& after, const ModelFit& drawn) {
    result_.compared = compared_tables(recording_, problem_, baseline_, drawn);
    result_.simulated = simulated_rows(recording_, problem_, baseline_, after);
  }

  void nothing_named(Verdict verdict, const std::vector<MismatchRegion>& mismatch) {
    result_.verdict = verdict;
    result_.mismatch.clear();
    if (verdict != Verdict::no_mismatch) result_.mismatch = mismatch;
    result_.remaining = result_.mismatch;
    result_.improved = result_.baseline;
    if (verdict == Verdict::unexplained && mapping_)
      result_.alternatives = alternatives_left_open(problem_, baseline_, mapping_->left_open());
    if (!result_.alternatives.empty()) result_.verdict = Verdict::ambiguous;
    if (result_.verdict == Verdict::unexplained) remark_all(remarks_on_wave(problem_));
    if (result_.verdict == Verdict::unexplained && search_.explains())
      show_nearest();
    else
      compare(baseline_, baseline_);
  }

  /// The best fit of an unexplained recording, beside the simulation and not in its place.
  void show_nearest() {
    const ModelFit best = finished(problem_, search_.best_within_bounds().fit);
    result_.nearest = described_effects(problem_, best, baseline_, 0);
    result_.with_nearest =
        quality_of(problem_, best, predict_held_out(problem_, best, blocks_of(problem_.samples)));
    remark_all(remarks_on_nearest(result_));
    compare(baseline_, best);
  }

  void judge(const Scanner& scanner) {
    const JudgedSet& chosen = judged_.list.front();
    const ScanResult left = remaining(problem_, baseline_, scanner, chosen.fit);
    const double chi2 =
        has_shared_error(problem_)
            ? chosen.candidate->chi2(problem_)
            : chosen.fit.cost / static_cast<double>(std::max<std::size_t>(1, chosen.fit.count));
    const bool clean = !problem_.noise.is_absolute ||
                       (left.p_value > significance && chi2 < largest_of_noise(chosen.fit.count));
    const double gained = (baseline_held_out_.cost - chosen.held_out.cost) /
                          std::max(1e-12, baseline_held_out_.cost - std::min(1.0, chosen.held_out.cost));
    if (!clean && gained < part_that_counts[std::min<std::size_t>(3, search_.others_in(chosen.fit))]) {
      nothing_named(Verdict::unexplained, std::vector<MismatchRegion>(result_.mismatch));
      return;
    }
    result_.improved = quality_of(problem_, chosen.fit, chosen.held_out);
    if (!clean) result_.remaining = left.regions;
    const auto rivals = judged_.rivals_of(chosen);
    double weight = 1;
    for (const JudgedSet* rival : rivals)
      weight += std::exp(rival->candidate->score - chosen.candidate->score);
    const auto open =
        mapping_ ? open_beside(mapping_->left_open(), chosen.fit, clean) : std::vector<const OpenSet*>{};
    for (const OpenSet* set : open) weight += set->weight();
    result_.left_out = described_effects(problem_, chosen.fit, baseline_, 1 / weight);
    const std::string advice = open.empty() ? what_would_show(chosen) : open.front()->told_by;
    bool ambiguous = !advice.empty();
    std::string tells_apart = advice;
    for (const JudgedSet* rival : rivals) {
      const Rivalry beside = rivalry(problem_, chosen, *rival);
      AlternativeExplanation alternative;
      alternative.probability = std::exp(-beside.difference) / weight;
      alternative.held_out_chi2_reduced = rival->held_out.chi2_reduced;
      alternative.effects = described_effects(problem_, rival->fit, baseline_, alternative.probability);
      alternative.told_apart_by = beside.is_near
                                      ? experiment_that_tells_apart(problem_, chosen.fit, rival->fit)
                                      : "these data distinguish them";
      ambiguous = ambiguous || beside.is_as_good;
      if (beside.is_as_good && tells_apart.empty()) tells_apart = alternative.told_apart_by;
      result_.alternatives.push_back(alternative);
    }
    for (const OpenSet* set : open)
      result_.alternatives.push_back(alternative_left_open(problem_, baseline_, *set, weight));
    result_.verdict = ambiguous ? Verdict::ambiguous : clean ? Verdict::explained : Verdict::partly_explained;
    if (ambiguous) {
      const AlternativeExplanation first{result_.left_out, 1 / weight, chosen.held_out.chi2_reduced,
                                         tells_apart};
      result_.alternatives.insert(result_.alternatives.begin(), first);
    }
    compare(chosen.fit, chosen.fit);
  }

  /// What leaves an explanation a candidate though no other does as well; empty: nothing.
  std::string what_would_show(const JudgedSet& chosen) const {
    for (const Effect* effect : chosen.fit.explanation->effects())
      if (std::string advice = effect->not_recorded(problem_.experiment); !advice.empty()) return advice;
    return "";
  }

  void describe_common(const ScanResult& before) {
    result_.mismatch = before.regions;
    result_.baseline = quality_of(problem_, baseline_, baseline_held_out_);
    const ModelFit calibrated = finished(problem_, baseline_);
    for (std::size_t k = 0; k < calibrated.values.size(); ++k)
      result_.calibrated.push_back(calibrated.parameter(k, 1));
    result_.noise = described_noise(problem_);
    result_.remarks = recording_.remarks;
    remark_all(remarks_on_noise(problem_, prepared_.outliers, prepared_.in_jumps));
    remark_all(unused_deviations(recording_, problem_.noise));
    remark_all(remarks_on_sets(judged_));
  }

  const Recording& recording_;
  const DiagnoseOptions& options_;
  SolvedCaseMapping* mapping_;
  PreparedFit prepared_;
  FitProblem& problem_ = prepared_.problem;
  ModelFit& baseline_ = prepared_.baseline;
  SearchResult search_;
  HeldOut baseline_held_out_;
  JudgedSets judged_;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose(const Recording& recording, const DiagnoseOptions& options) {
  if (!options.simulation && recording.simulation.by_finite_elements())
    throw InputError(
        "the recording's simulation is a case of finite elements, which nothing at hand here solves; "
        "use asperity diagnose");
  if (!options.simulation) return Diagnoser(recording, options, nullptr).run();
  SolvedCaseMapping mapping(*options.simulation, options.progress);
  const Recording of_case = mapping.with_bodies_of_case(recording);
  return Diagnoser(of_case, options, &mapping).run();
}

}  // namespace asperity
