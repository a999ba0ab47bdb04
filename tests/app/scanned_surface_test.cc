// What characterise takes from a scan: spectrum, RMS without the waves that no mesh carries, their share of
// the slope; held against closed forms of the spectrum that the scan was drawn from.
#include "app/scanned_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surfaces/generate.h"
#include "surfaces/read_topography.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::TemporaryFolder;

const SelfAffineSpectrum drawn_from{1.5e-9, 0.8, 300e-9, 40e-9};

MeasuredScan scan_of(const Topography& map, const TemporaryFolder& folder) {
  ScanParameters scan;
  scan.file = (folder.path / "scan.gsf").string();
  write_gsf(scan.file, map);
  return measured_scan(scan);
}

Topography gaussian_map() {
  GenerateOptions options;
  options.nx = options.ny = 512;
  options.lx = options.ly = 5e-6;
  options.seed = 11;
  return generate_window(drawn_from, drawn_from.rolloff, options);
}

/// The same plateau with a longer cut-off: what is left of the surface [m].
SelfAffineSpectrum without_waves_below(double cutoff) {
  SelfAffineSpectrum left = drawn_from;
  left.cutoff = cutoff;
  left.rms = drawn_from.rms * std::sqrt(drawn_from.plateau() / left.plateau());
  return left;
}

TEST(ScannedSurface_analytic, is_drawn_from_the_scans_spectrum_with_the_rms_of_the_waves_that_are_left) {
  const TemporaryFolder folder;
  const MeasuredScan scan = scan_of(gaussian_map(), folder);
  ASSERT_TRUE(from_spectrum(scan, SurfaceFrom::automatic));
  // A scan of 17 roll-offs: Hurst exponent and roll-off scatter by their stated errors, Sq by some 5 %.
  for (const double cutoff : {60e-9, 120e-9}) {
    const TopographySpec spec = topography_of(scan, SurfaceFrom::automatic, cutoff);
    ASSERT_NE(spec.generator(), nullptr);
    const GeneratorParameters& drawn = *spec.generator();
    EXPECT_NEAR(drawn.spectrum.hurst, drawn_from.hurst, 0.15);
    EXPECT_NEAR(drawn.spectrum.rolloff / drawn_from.rolloff, 1, 0.3);
    EXPECT_EQ(drawn.spectrum.cutoff, cutoff);
    EXPECT_NEAR(drawn.window, 5e-6, 1e-12);
    const SelfAffineSpectrum left = without_waves_below(cutoff);
    EXPECT_NEAR(drawn.spectrum.rms / scan.measurement.statistics.Sq, left.rms / drawn_from.rms, 0.01)
        << cutoff;
    const double slope_left = std::pow(left.rms_slope() / drawn_from.rms_slope(), 2);
    EXPECT_NEAR(slope_variance_below(scan, cutoff), 1 - slope_left, 0.03) << cutoff;
  }
}

TEST(ScannedSurface_behaviour, of_pits_keeps_its_heights_at_one_place) {
  const TemporaryFolder folder;
  Topography map = gaussian_map();
  for (double& height : map.heights) height = -std::pow(height * 1e9, 4) * 1e-9;
  const MeasuredScan scan = scan_of(map, folder);
  EXPECT_FALSE(from_spectrum(scan, SurfaceFrom::automatic));
  const TopographySpec spec = topography_of(scan, SurfaceFrom::automatic, 80e-9);
  ASSERT_NE(spec.scan(), nullptr);
  EXPECT_EQ(spec.scan()->cutoff, 80e-9);
  EXPECT_EQ(spec.scan()->outside, Outside::mirror);
  EXPECT_TRUE(from_spectrum(scan, SurfaceFrom::spectrum));  // where the user says so
}

}  // namespace
}  // namespace asperity
