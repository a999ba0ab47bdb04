#include "diagnosis/remarks.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "core/printed.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/locate/waves.h"

namespace asperity {
namespace {

std::string remark_on(const NoiseOfControl& control) {
  const std::string has = "'" + control.channel + "' has a noise of " + (control.by_row ? "up to " : "") +
                          printed("%.2g ", control.sd) + unit_of_channel(control.channel),
                    adds =
                        printed(" a noise of %.2g ", control.of_response) + unit_of_channel(control.response);
  if (!control.by_row)
    return has + ", which '" + control.response +
           "' does not follow: smoothed where neighbours allow it, it counts as" + adds;
  if (control.of_response > 0) return has + ", which counts as" + adds + " of '" + control.response + "'";
  return has + ", which counts for nothing: what was simulated does not depend on it";
}

}  // namespace

std::vector<std::string> remarks_on_noise(const FitProblem& problem, std::size_t outliers,
                                          std::size_t in_jumps) {
  std::vector<std::string> remarks;
  double correlation = 0;
  for (const SharedNoise& shared : problem.noise.shared)
    correlation = std::max(correlation, shared.neighbours());
  constexpr double worth_saying = 0.1;
  if (correlation > worth_saying)
    remarks.push_back(
        printed("neighbouring samples share their noise (correlation %.2f), so that they count as fewer",
                correlation));
  for (const NoiseOfControl& control : problem.noise.of_control) remarks.push_back(remark_on(control));
  if (outliers > 0)
    remarks.push_back(outliers == 1 ? "1 sample lies far off its neighbours and does not count"
                                    : std::to_string(outliers) +
                                          " samples lie far off their neighbours and do not count");
  if (in_jumps > 0)
    remarks.push_back((in_jumps == 1 ? "1 sample" : std::to_string(in_jumps) + " samples") +
                      std::string(" in which the probe jumps, faster than it is driven, ") +
                      (in_jumps == 1 ? "does" : "do") + " not count: it is not in equilibrium there");
  if (!problem.noise.is_absolute)
    remarks.push_back(
        "the noise is not known and too few rows repeat to estimate it: explanations are compared with each "
        "other, but whether the "
        "best is good enough cannot be tested; give 'noise' or a column of standard deviations");
  return remarks;
}

std::vector<std::string> remarks_on_wave(const FitProblem& problem) {
  const double period = wave_left(problem.samples, problem.baseline_residual, problem.noise);
  if (period == 0) return {};
  return {printed("a wave of some %.2g samples stands out of what is left: it is no noise", period)};
}

bool lies_on_the_rows(const FitProblem& problem, const ModelFit& fit) {
  constexpr double of_a_thirtieth = 1e-3;
  return problem.noise.is_absolute &&
         chi2_reduced(problem.samples, fit.residual(problem.samples), problem.noise) < of_a_thirtieth;
}

std::string remark_on_too_little_noise(const FitProblem& problem, const ModelFit& fit) {
  if (!problem.noise.is_absolute) return "";
  if (lies_on_the_rows(problem, fit))
    return "the rows lie on a curve to a small part of their own standard deviations, as points of a fitted "
           "curve do and measurements do not: their deviations are taken as those of the curve's parameters, "
           "and no row tests the law between them";
  const bool is_given = std::any_of(problem.noise.from.begin(), problem.noise.from.end(),
                                    [](const std::string& from) { return from.rfind("given", 0) == 0; });
  const double freedom = static_cast<double>(fit.count) - static_cast<double>(fit.free_parameters());
  constexpr double chance = 1e-6;
  const double chi2 = chi2_reduced(problem.samples, fit.residual(problem.samples), problem.noise);
  if (!is_given || freedom < 1 ||
      boost::math::cdf(boost::math::chi_squared(freedom), chi2 * freedom) > chance)
    return "";
  return printed(
      "what is left is smaller than the noise that is given (chi-square per sample %.2g): the standard "
      "deviations are too large by a factor of about %.2g, and smaller mismatches stay hidden behind them",
      chi2, std::sqrt(1 / chi2));
}

std::vector<UntriedEffect> effects_without_data(const Experiment& experiment) {
  std::vector<UntriedEffect> list;
  for (const auto& effect : effect_catalogue()) {
    if (!effect->acts_in(experiment.mode) || effect->has_what_it_needs(experiment)) continue;
    const NeededValues needed = effect->needs();
    const auto varied = experiment.different.find(needed.channel);
    const int have = varied == experiment.different.end() ? 0 : varied->second;
    if (have < 2) continue;  // what was never varied is no candidate anyone would think of
    list.push_back({effect->id(), std::to_string(have) + " different values of " + needed.channel +
                                      " cannot test its law, " + std::to_string(needed.count) +
                                      " or more would"});
  }
  return list;
}

std::vector<std::string> remarks_on_sets(const JudgedSets& judged) {
  std::vector<std::string> remarks;
  constexpr std::size_t most_said = 3;
  for (std::size_t i = 0; i < std::min(most_said, judged.inconsistent.size()); ++i)
    remarks.push_back(
        judged.inconsistent[i] +
        " would fit only with other parameters in different parts of the data and was rejected");
  for (std::size_t i = 0; i < std::min(most_said, judged.stopped.size()); ++i)
    remarks.push_back(judged.stopped[i] +
                      " would fit best with that parameter beyond its bounds and was rejected");
  return remarks;
}

std::vector<std::string> remarks_on_nearest(const Diagnosis& d) {
  std::string names;
  for (const auto& effect : d.nearest) names += (names.empty() ? "" : " + ") + effect.id;
  const bool fits = d.with_nearest.chi2_reduced < largest_of_noise(d.with_nearest.samples);
  return {"the nearest of the catalogue, " + names +
          printed(fits ? ", leaves no more than noise (chi-square per sample falls from %.3g to %.3g), but a "
                         "member of it does not earn its place or has another form, and it is not named"
                       : ", takes away only part of the mismatch (chi-square per sample falls from %.3g to "
                         "%.3g) and is not named",
                  d.baseline.chi2_reduced, d.with_nearest.chi2_reduced)};
}

std::vector<std::string> remarks_on_untried(const Diagnosis& d) {
  std::vector<std::string> remarks;
  if (d.verdict != Verdict::no_mismatch)
    for (const auto& [effect, why] : d.not_tried) remarks.push_back(effect + " was not tried: " + why);
  return remarks;
}

}  // namespace asperity
