#include "diagnosis/mapping/judged_part.h"

#include "diagnosis/choose/law_error.h"

namespace asperity {

double worse_on_part(const FitProblem& problem, const Samples& part, const ModelFit& fit,
                     const ModelFit& other, double overdispersion) {
  FitProblem on_part = problem;
  on_part.samples = part;
  const LawErrors laws(part);
  const auto cost = [&](const ModelFit& of) {
    const Misfit misfit = misfit_of(on_part, of, other);
    return laws.cost(part, problem.noise, misfit.residual, misfit.errors).sum();
  };
  return 0.5 * (cost(fit) - cost(other)) / overdispersion;
}

}  // namespace asperity
