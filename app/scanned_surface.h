// A scan as the surface of a body in a case file: realisations with its spectrum, or its heights.
#pragma once

#include <string>
#include <vector>

#include "app/characterise_request.h"
#include "core/topography_spec.h"
#include "surfaces/surface_report.h"

namespace asperity {

/// A scan that was read and measured.
struct MeasuredScan {
  ScanParameters scan;
  SurfaceMeasurement measurement;
  double shortest_wave = 0;  ///< that the scan resolves: four pixels, or the knee of its spectrum [m]
};

/// Throws InputError where it cannot be read or measured.
MeasuredScan measured_scan(const ScanParameters& scan);

/// Wavelength from which on the fitted spectrum falls [m]: the longest that matter; the scan's side where it
/// shows none, infinite without a fit.
double rolloff_of(const MeasuredScan& scan);

/// Whether its surface is drawn from its spectrum, so that there are realisations of it. Throws
/// InputError where a spectrum is asked for that the scan does not give.
bool from_spectrum(const MeasuredScan& scan, SurfaceFrom asked);

/// The entry `Topography` without waves shorter than cutoff [m], of RMS as the scan's without them. Throws
/// InputError where nothing of the roughness is left.
TopographySpec topography_of(const MeasuredScan& scan, SurfaceFrom asked, double cutoff);

/// Share of the scan's slope variance in waves shorter than cutoff [m], which a mesh of that cut-off leaves
/// out. A pure number [-].
double slope_variance_below(const MeasuredScan& scan, double cutoff);

/// What was measured, and what was taken from it, in sentences; body: "substrate" or "particle";
/// cutoff: shortest wave that is meshed [m].
std::vector<std::string> scan_sentences(const std::string& body, const MeasuredScan& scan, SurfaceFrom asked,
                                        double cutoff);

}  // namespace asperity
