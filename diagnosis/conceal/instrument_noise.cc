#include "diagnosis/conceal/instrument_noise.h"

#include <cmath>

namespace asperity::hidden {

std::string InstrumentNoise::words() const {
  std::string text = "white";
  if (correlated_share > 0)
    text += " with a part correlated over " + std::to_string(std::lround(correlation_length)) + " samples";
  if (outlier_probability > 0) text += ", outliers";
  return text;
}

void InstrumentNoise::add_to(std::vector<double>& signal, Random& random) const {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even;
  const double memory = std::exp(-1 / correlation_length);
  double correlated = normal(random);
  for (double& value : signal) {
    correlated = memory * correlated + std::sqrt(1 - memory * memory) * normal(random);
    value +=
        sd * (std::sqrt(1 - correlated_share) * normal(random) + std::sqrt(correlated_share) * correlated);
    if (even(random) < outlier_probability) value += outlier_size * sd * (even(random) < 0.5 ? -1 : 1);
  }
}

}  // namespace asperity::hidden
