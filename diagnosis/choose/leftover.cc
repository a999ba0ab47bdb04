#include "diagnosis/choose/leftover.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>

#include "diagnosis/choose/law_error.h"
#include "diagnosis/locate/waves.h"

namespace asperity {

double largest_of_noise(std::size_t count) {
  constexpr double deviation_known_to_a_fifth = 1.5;
  const auto samples = static_cast<double>(std::max<std::size_t>(1, count));
  return std::max(deviation_known_to_a_fifth,
                  quantile(complement(boost::math::chi_squared(samples), significance)) / samples);
}

ScanResult remaining(const FitProblem& problem, const ModelFit& baseline, const Scanner& scanner,
                     const ModelFit& fit) {
  const LawError tolerated = law_error(problem, fit, baseline);
  if (!has_shared_error(problem)) return scanner.scan(fit.residual(problem.samples), tolerated);
  const Misfit shared = shared_misfit(problem, fit);
  const LawErrors errors(problem.samples);
  return scanner.scan(
      errors.without_shared_error(problem.samples, problem.noise, shared.residual, shared.errors), tolerated);
}

bool leaves_noise(const FitProblem& problem, const SearchResult& search, const Scanner& scanner,
                  const Candidate& candidate) {
  return candidate.chi2(problem) < largest_of_noise(candidate.fit.count) &&
         remaining(problem, search.alone.fit, scanner, candidate.fit).p_value > significance;
}

bool is_noise_as_known(const FitProblem& problem, const ScanResult& before, std::size_t count) {
  if (!(before.p_value > significance)) return false;
  if (problem.correction) return true;
  return chi2_reduced(problem.samples, problem.baseline_residual, problem.noise) < largest_of_noise(count) &&
         wave_left(problem.samples, problem.baseline_residual, problem.noise) == 0;
}

}  // namespace asperity
