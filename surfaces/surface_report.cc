#include "surfaces/surface_report.h"

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "core/csv.h"
#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/autocorrelation.h"

namespace asperity {
namespace {

const std::string wave_number_column = "wave_number [rad/m]", psd_column = "psd [m^4]";

nlohmann::ordered_json to_json(const SpectrumFit& fit) {
  nlohmann::ordered_json json{{"hurst", fit.hurst.value}, {"hurst_error", fit.hurst.error}};
  const auto add_knee = [&](const std::string& name, bool seen, const SpectrumFit::Number& knee) {
    json[name + "_m"] = seen ? nlohmann::ordered_json(knee.value) : nullptr;
    json[name + "_error_m"] = seen ? nlohmann::ordered_json(knee.error) : nullptr;
  };
  add_knee("rolloff", fit.has_rolloff, fit.rolloff);
  add_knee("cutoff", fit.has_cutoff, fit.cutoff);
  add_knee("noise_below", fit.has_noise, fit.noise);
  json["misfit"] = fit.misfit;
  return json;
}

const char* verdict_name(GaussianTest::Verdict verdict) {
  switch (verdict) {
    case GaussianTest::Verdict::consistent:
      return "consistent";
    case GaussianTest::Verdict::not_gaussian:
      return "not Gaussian";
    case GaussianTest::Verdict::too_few_samples:
      return "too few samples";
  }
  return "";
}

}  // namespace

SurfaceMeasurement measure_surface(Topography map, Level level) {
  SurfaceMeasurement result;
  result.map = levelled(std::move(map), level);
  result.level = level;
  {
    const Autocorrelation correlation = autocorrelation(result.map);  // as large as the map: not kept
    result.statistics = height_statistics(result.map, correlation);
    result.gaussian = gaussian_test(result.map, correlation);
  }
  result.spectrum = radial_spectrum(result.map);
  try {
    result.fit = fit_spectrum(result.spectrum);
  } catch (const InputError&) {
    result.fit.reset();  // too small or too flat: everything else still holds
  }
  return result;
}

nlohmann::ordered_json to_json(const SurfaceMeasurement& measurement) {
  const Topography& map = measurement.map;
  const HeightStatistics& s = measurement.statistics;
  const GaussianTest& gaussian = measurement.gaussian;
  nlohmann::ordered_json json{{"pixels", {map.nx, map.ny}},
                              {"size_m", {map.lx, map.ly}},
                              {"Sq_m", s.Sq},
                              {"Sa_m", s.Sa},
                              {"Sz_m", s.Sz},
                              {"Ssk", s.Ssk},
                              {"Sku", s.Sku},
                              {"rms_slope", s.rms_slope},
                              {"rms_curvature_per_m", s.rms_curvature},
                              {"correlation_length_m", s.correlation_length},
                              {"missing", map.missing_count()},
                              {"channel", map.channel},
                              {"source", map.source},
                              {"level", level_name(measurement.level)}};
  json["gaussian"] = {{"verdict", verdict_name(gaussian.verdict)},
                      {"p_value", gaussian.p_value},
                      {"independent_samples", gaussian.independent_samples},
                      {"Ssk_error", gaussian.skewness_error},
                      {"Sku_error", gaussian.kurtosis_error}};
  json["spectrum"] = measurement.fit ? to_json(*measurement.fit) : nlohmann::ordered_json(nullptr);
  return json;
}

std::string to_text(const SurfaceMeasurement& measurement) {
  const Topography& map = measurement.map;
  const HeightStatistics& s = measurement.statistics;
  const auto length = [](double value) { return format_quantity(value, Dimension::length, 4); };
  const auto number = [](double value) { return format_quantity(value, Dimension::none, 4); };
  const std::size_t missing = map.missing_count();
  const std::vector<std::pair<std::string, std::string>> lines{
      {"source", map.source},
      {"channel", map.channel.empty() ? "not named" : map.channel},
      {"pixels", std::to_string(map.nx) + " x " + std::to_string(map.ny) +
                     (missing ? ", " + std::to_string(missing) + " missing" : ", none missing")},
      {"size", length(map.lx) + " x " + length(map.ly)},
      {"levelled by", level_name(measurement.level)},
      {"Sq (RMS height)", length(s.Sq)},
      {"Sa (mean height)", length(s.Sa)},
      {"Sz (peak to valley)", length(s.Sz)},
      {"Ssk (skewness)", number(s.Ssk)},
      {"Sku (kurtosis)", number(s.Sku)},
      {"RMS slope", number(s.rms_slope)},
      {"RMS curvature",
       std::isfinite(s.rms_curvature) ? "1/(" + length(1 / s.rms_curvature) + ")" : "not measurable"},
      {"correlation length", std::isfinite(s.correlation_length)
                                 ? length(s.correlation_length) + " (autocorrelation 1/e)"
                                 : "none within half the map"},
      {"heights are", measurement.gaussian.sentence},
      {"spectrum", measurement.fit ? measurement.fit->sentence() : "too few or too flat points for a fit"}};
  std::string text;
  for (const auto& [name, value] : lines) {
    char label[32];
    std::snprintf(label, sizeof label, "%-20s ", name.c_str());
    text += label + value + "\n";
  }
  return text;
}

std::string spectrum_csv(const RadialSpectrum& spectrum) {
  return format_csv({wave_number_column, psd_column}, {spectrum.q, spectrum.C});
}

TabulatedSpectrum read_spectrum_csv(const std::string& file) {
  const CsvTable csv = read_csv(file);
  TabulatedSpectrum table;
  const auto q = csv.numbers(wave_number_column), C = csv.numbers(psd_column);
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (C[i] == 0) continue;
    if (!(q[i] > 0) || !(C[i] > 0) || (!table.q.empty() && q[i] <= table.q.back()))
      throw InputError(
          "in " + file + " row " + std::to_string(i + 1) +
          ": wave numbers must be positive and rise from row to row, and the psd must not be negative");
    table.q.push_back(q[i]), table.C.push_back(C[i]);
  }
  if (table.q.size() < 2) throw InputError(file + " holds fewer than two rows with a psd above zero");
  return table;
}

}  // namespace asperity
