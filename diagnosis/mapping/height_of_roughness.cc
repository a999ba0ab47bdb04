#include "diagnosis/mapping/height_of_roughness.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "core/error.h"
#include "diagnosis/catalogue/generated_substrate.h"

namespace asperity {
namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Half of the 95 % interval of one more, of logarithms.
double half_interval(const std::vector<double>& logarithms) {
  const auto n = static_cast<double>(logarithms.size());
  const double mean = mean_of(logarithms);
  double squares = 0;
  for (const double value : logarithms) squares += (value - mean) * (value - mean);
  constexpr double upper_end = 0.975;
  return boost::math::quantile(boost::math::students_t(n - 1), upper_end) *
         std::sqrt(squares / (n - 1) * (1 + 1 / n));
}

}  // namespace

std::optional<CorrectedEntry> height_of_roughness(ForwardModel& model, const Experiment& experiment,
                                                  const Effect& effect,
                                                  const std::vector<DiagnosedParameter>& parameters) {
  constexpr double seen = 0.05;  // part of the load from which on noise leaves the growth to be seen
  const double from = seen * experiment.largest_force, to = experiment.largest_force;
  std::vector<double> values;
  for (const auto& p : parameters) values.push_back(p.value);
  auto [substrate, growth] = effect.roughness_found(experiment, values.data(), from, to);
  if (!(growth > 0)) return {};
  // The growth is nearly in proportion to the height.
  constexpr int rounds = 3;
  constexpr double near_enough = 0.05, least_of_mean = 0.1;
  try {
    for (int round = 0; round < rounds; ++round) {
      const std::vector<double> grown = model.growth_by_roughness(substrate, from, to);
      if (grown.size() < 2) return {};
      const double mean = mean_of(grown);
      if (!(mean > 0)) return {};
      const double rms = substrate.rms * growth / mean;
      std::vector<double> heights;
      for (const double one : grown)
        heights.push_back(std::log(substrate.rms * growth / std::max(one, least_of_mean * mean)));
      const bool is_near = std::abs(rms / substrate.rms - 1) < near_enough;
      substrate.rms = rms;
      if (!is_near && round + 1 < rounds) continue;
      const double half = half_interval(heights);
      return generated_substrate(substrate, rms * std::exp(-half), rms * std::exp(half));
    }
  } catch (const InputError&) {  // half-spaces have limits of their own
  } catch (const WorkError&) {
  }
  return {};
}

}  // namespace asperity
