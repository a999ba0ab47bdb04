#include "report/result/surface_spectra.h"

#include <cmath>
#include <limits>

#include "report/result/result_tables.h"

namespace asperity::report {
namespace {

/// What result.json says of a surface within the contact region [m]; NaN if it does not.
double meshed_rms_of(const SolvedCase& solved, const std::string& section) {
  return solved.finished() ? solved.result->rms_in_region[section == "Particle" ? 0 : 1]
                           : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::optional<GeneratorParameters> generator_of(const SolvedCase& solved, const std::string& section) {
  const TopographySpec spec = solved.entries.topography(section);
  if (!spec.generator()) return std::nullopt;
  return *spec.generator();
}

double composite_rms(const SolvedCase& solved) {
  double squares = 0;
  for (const std::string section : {"Particle", "Substrate"}) {
    const TopographySpec spec = solved.entries.topography(section);
    const double rms = spec.scan() ? meshed_rms_of(solved, section) : spec.rms();
    squares += rms * rms;
  }
  return std::sqrt(squares);
}

Scatter meshed_rms(const CaseGroup& group, const std::string& section) {
  std::vector<double> values;
  for (const auto& solved : group.cases) values.push_back(meshed_rms_of(solved, section));
  return scatter_of(values);
}

std::string spectrum_shape(const SolvedCase& solved) {
  std::string shape;
  for (const std::string section : {"Particle", "Substrate"}) {
    auto generator = generator_of(solved, section);
    if (!generator) continue;
    generator->spectrum.rms = 0;
    shape += section + generator->text_without_seed();
  }
  return shape;
}

}  // namespace asperity::report
