#include "diagnosis/mapping/judged_part.h"

#include <algorithm>

#include "diagnosis/choose/law_error.h"

namespace asperity {
namespace {

LawErrors::Cost cost_on_part(const FitProblem& problem, const Samples& part, const ModelFit& fit,
                             const ModelFit& other) {
  FitProblem on_part = problem;
  on_part.samples = part;
  const Misfit misfit = misfit_of(on_part, fit, other);
  return LawErrors(part).cost(part, problem.noise, misfit.residual, misfit.errors);
}

}  // namespace

double worse_on_part(const FitProblem& problem, const Samples& part, const ModelFit& fit,
                     const ModelFit& other, double overdispersion) {
  const auto cost = [&](const ModelFit& of) { return cost_on_part(problem, part, of, other).sum(); };
  return 0.5 * (cost(fit) - cost(other)) / overdispersion;
}

double chi2_on_part(const FitProblem& problem, const Samples& part, const ModelFit& fit,
                    const ModelFit& baseline) {
  const auto counted =
      std::count_if(part.list.begin(), part.list.end(), [](const Sample& sample) { return sample.counts; });
  return cost_on_part(problem, part, fit, baseline).of_misfit /
         static_cast<double>(std::max<std::ptrdiff_t>(1, counted));
}

}  // namespace asperity
