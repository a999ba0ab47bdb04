#include "app/scanned_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "surfaces/read_topography.h"
#include "surfaces/scan_spec.h"
#include "surfaces/surface_of_entry.h"

namespace asperity {
namespace {

std::string length_text(double value) { return format_quantity(value, Dimension::length); }

double side_of(const Topography& map) { return std::min(map.lx, map.ly); }

/// RMS of the scan without waves shorter than the cut-off [m].
double rms_above(const MeasuredScan& scan, double cutoff) {
  ScanParameters smoothed = scan.scan;
  smoothed.cutoff = cutoff;
  return height_moments(prepared_scan(smoothed)).Sq;
}

/// Exponent that is drawn with: what is fitted to a smooth or noisy scan can lie beyond a self-affine
/// surface's.
double hurst_drawn(const SpectrumFit& fit) {
  constexpr double least = 0.1, largest = 1;
  return std::clamp(fit.hurst.value, least, largest);
}

/// The model drawn from: roll-off as seen, else the scan's side, for longer waves are not in it.
SelfAffineSpectrum spectrum_of(const MeasuredScan& scan, double cutoff) {
  constexpr double least_decade = 1.5;
  const SpectrumFit& fit = *scan.measurement.fit;
  SelfAffineSpectrum spectrum;
  spectrum.hurst = hurst_drawn(fit);
  spectrum.cutoff = cutoff;
  spectrum.rolloff = rolloff_of(scan);
  if (spectrum.rolloff < least_decade * cutoff)
    throw InputError(scan.scan.file + ": its spectrum falls from waves of " + length_text(spectrum.rolloff) +
                     " on, but the mesh carries waves from " + length_text(cutoff) +
                     " on; give more --time or a smaller range of --loads, for a finer mesh");
  spectrum.rms = rms_above(scan, cutoff);
  return spectrum;
}

}  // namespace

MeasuredScan measured_scan(const ScanParameters& scan) {
  MeasuredScan measured{scan, measure_surface(read_topography(scan.file, scan.options), scan.level)};
  measured.shortest_wave = topography_scales(TopographySpec(scan)).shortest_wave;
  const auto& fit = measured.measurement.fit;
  if (fit && fit->has_noise) measured.shortest_wave = std::max(measured.shortest_wave, fit->noise.value);
  return measured;
}

double rolloff_of(const MeasuredScan& scan) {
  const auto& fit = scan.measurement.fit;
  if (!fit) return std::numeric_limits<double>::infinity();
  return fit->has_rolloff ? fit->rolloff.value : side_of(scan.measurement.map);
}

bool from_spectrum(const MeasuredScan& scan, SurfaceFrom asked) {
  if (asked == SurfaceFrom::spectrum && !scan.measurement.fit)
    throw InputError(scan.scan.file +
                     ": the scan is too small or too flat for a spectrum; leave --surface spectrum away");
  if (asked != SurfaceFrom::automatic) return asked == SurfaceFrom::spectrum;
  return scan.measurement.fit && scan.measurement.gaussian.verdict != GaussianTest::Verdict::not_gaussian;
}

TopographySpec topography_of(const MeasuredScan& scan, SurfaceFrom asked, double cutoff) {
  if (from_spectrum(scan, asked)) {
    GeneratorParameters generator;
    generator.spectrum = spectrum_of(scan, cutoff);
    generator.window = side_of(scan.measurement.map);
    return generator;
  }
  ScanParameters smoothed = scan.scan;
  smoothed.cutoff = cutoff;
  smoothed.outside = Outside::mirror;
  return smoothed;
}

double slope_variance_below(const MeasuredScan& scan, double cutoff) {
  const RadialSpectrum& spectrum = scan.measurement.spectrum;
  double all = 0, below = 0;
  for (std::size_t i = 0; i < spectrum.q.size(); ++i) {
    const double variance = std::pow(spectrum.q[i], 3) * spectrum.C[i];  // of equally wide rings
    all += variance;
    if (spectrum.q[i] * cutoff > 2 * M_PI) below += variance;
  }
  return all > 0 ? below / all : 0;
}

std::vector<std::string> scan_sentences(const std::string& body, const MeasuredScan& scan, SurfaceFrom asked,
                                        double cutoff) {
  const SurfaceMeasurement& m = scan.measurement;
  std::vector<std::string> sentences{body + ": " + scan.scan.file + ", " + std::to_string(m.map.nx) + " x " +
                                     std::to_string(m.map.ny) + " pixels, " + length_text(m.map.lx) +
                                     ", Sq " + length_text(m.statistics.Sq) + " after " +
                                     level_name(m.level) + " levelling"};
  if (from_spectrum(scan, asked)) {
    const SpectrumFit& fit = *m.fit;
    std::string drawn =
        "its surface is drawn from the scan's spectrum, Hurst exponent " + printed("%.2f", fit.hurst.value);
    if (hurst_drawn(fit) != fit.hurst.value)
      drawn += printed(" (taken as %g, the nearest that a self-affine surface has)", hurst_drawn(fit));
    drawn += fit.has_rolloff
                 ? ", roll-off " + length_text(fit.rolloff.value)
                 : "; the scan shows no roll-off: waves longer than it are not known and left out";
    sentences.push_back(drawn);
    if (m.gaussian.verdict != GaussianTest::Verdict::consistent) sentences.push_back(m.gaussian.sentence);
  } else {
    sentences.push_back(
        "its heights are used as measured around the scan's centre, mirrored beyond its edges: one place, so "
        "that the scatter over the surface stays unknown" +
        std::string(asked == SurfaceFrom::automatic ? "; " + m.gaussian.sentence : ""));
  }
  sentences.push_back("waves shorter than " + length_text(cutoff) + ", " +
                      printed("%.0f %%", 100 * slope_variance_below(scan, cutoff)) +
                      " of the scan's slope variance, are left out: the mesh does not carry them");
  return sentences;
}

}  // namespace asperity
