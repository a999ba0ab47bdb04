#include "report/result/surface_spectra.h"

#include <cmath>
#include <limits>

#include "report/result/result_tables.h"
#include "surfaces/scan_spec.h"

namespace asperity::report {
namespace {

std::string entry_of(const SolvedCase& solved, const std::string& section) {
  return solved.entries.text(section + "/Topography", "smooth");
}

/// What result.json says of a surface within the contact region [m]; NaN if it does not.
double meshed_rms_of(const SolvedCase& solved, const std::string& section) {
  return solved.finished() ? solved.result->rms_in_region[section == "Particle" ? 0 : 1] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::optional<GeneratorParameters> generator_of(const SolvedCase& solved, const std::string& section) {
  const std::string spec = entry_of(solved, section);
  if (!is_generator_call(spec)) return std::nullopt;
  return parse_generator(spec);
}

double composite_rms(const SolvedCase& solved) {
  double squares = 0;
  for (const std::string section : {"Particle", "Substrate"}) {
    const auto generator = generator_of(solved, section);
    const double rms = generator ? generator->spectrum.rms : is_scan(entry_of(solved, section)) ? meshed_rms_of(solved, section) : 0;
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
    generator->seed = 0;
    shape += section + generator->text();
  }
  return shape;
}

}  // namespace asperity::report
