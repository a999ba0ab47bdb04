#include "diagnosis/mapping/recorded_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

double recorded_in_contact(const FitProblem& problem, Pressed pressed) {
  constexpr double in_contact = 0.02;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const auto& run : problem.samples.runs)
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const Sample& s = problem.samples.list[i];
      const double given = run.response_is_displacement ? s.normal_force : s.response,
                   force = pressed == Pressed::or_pulled ? std::abs(given) : given;
      if (!s.counts || force < in_contact * problem.experiment.largest_force) continue;
      const double displacement = run.response_is_displacement ? s.response : s.normal_displacement;
      least = std::min(least, displacement);
      most = std::max(most, displacement);
    }
  return std::max(0.0, most - least);
}

double far_beyond_recorded(const FitProblem& problem) {
  constexpr double far = 1.5;
  return far *
         std::max(problem.experiment.largest_displacement, recorded_in_contact(problem, Pressed::alone));
}

}  // namespace asperity
