// All that is measured of one topography, as aligned text for people and as JSON for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "surfaces/levelling.h"
#include "surfaces/spectrum.h"
#include "surfaces/spectrum_fit.h"
#include "surfaces/statistics.h"
#include "surfaces/topography.h"

namespace asperity {

/// The map and what was measured of it.
struct SurfaceMeasurement {
  Topography map;  ///< levelled
  Level level = Level::plane;
  HeightStatistics statistics;
  GaussianTest gaussian;
  RadialSpectrum spectrum;
  std::optional<SpectrumFit> fit;  ///< absent where the map is too small or flat for one
};

/// Levels the map and measures it, in the memory of four further copies at most.
SurfaceMeasurement measure_surface(Topography map, Level level);

/// One object: pixels, size_m, Sq_m, Sa_m, Sz_m, Ssk, Sku, rms_slope, rms_curvature_per_m,
/// correlation_length_m, missing, channel, source, level, gaussian {...}, spectrum {...}. What could not be
/// measured is null.
nlohmann::ordered_json to_json(const SurfaceMeasurement& measurement);
std::string to_text(const SurfaceMeasurement& measurement);

/// The radial spectrum as a table with the columns "wave_number [rad/m]" and "psd [m^4]", and back.
std::string spectrum_csv(const RadialSpectrum& spectrum);
/// Throws InputError naming the row that is no spectrum's.
TabulatedSpectrum read_spectrum_csv(const std::string& file);

}  // namespace asperity
