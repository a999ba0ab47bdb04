#include "diagnosis/conceal/add_noise.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/conceal/instrument_noise.h"

namespace asperity::hidden {
namespace {

/// Of several kinds, by the seed: instruments differ.
InstrumentNoise noise_of(const ConcealOptions& options, TableKind kind, double largest) {
  InstrumentNoise noise;
  noise.sd = options.noise * largest;
  if (kind == TableKind::series) return noise;
  if (options.seed % 2 == 1) noise.correlated_share = 0.2;
  if (options.seed % 5 == 4) noise.outlier_probability = 0.003;
  return noise;
}

}  // namespace

void add_noise(ConcealedRecording& concealed, const std::vector<std::vector<double>>& without_effects,
               const ConcealOptions& options) {
  Random random(options.seed * 7919u + 13u);
  Truth& truth = concealed.truth;
  truth.noise = options.noise;
  truth.seed = options.seed;
  for (std::size_t t = 0; t < concealed.recording.tables.size(); ++t) {
    RecordingTable& table = concealed.recording.tables[t];
    std::vector<double>& response = table.columns.at(table.response);
    double largest = 0;
    for (const double value : response) largest = std::max(largest, std::abs(value));
    const InstrumentNoise noise = noise_of(options, table.kind, largest);
    if (t < without_effects.size() && noise.sd > 0) {
      double scale = 1;
      if (concealed.recording.mode != Motion::normal) {
        double both = 0, own = 0;
        for (std::size_t i = 0; i < response.size(); ++i)
          both += response[i] * without_effects[t][i], own += without_effects[t][i] * without_effects[t][i];
        scale = both / own;
      }
      TrueContribution contribution{table.file, {}};
      for (std::size_t i = 0; i < response.size(); ++i)
        contribution.in_noise.push_back((response[i] - scale * without_effects[t][i]) / noise.sd);
      truth.contributions.push_back(contribution);
    }
    noise.add_to(response, random);
    truth.noise_model = noise.words();
    if (noise.sd <= 0) continue;
    if (table.kind == TableKind::series)
      table.columns[table.response + "_sd"] = std::vector<double>(response.size(), noise.sd);
    else if (options.seed % 3 == 0)  // some instruments say what their noise is
      concealed.recording.noise[table.response] = noise.sd;
  }
}

}  // namespace asperity::hidden
