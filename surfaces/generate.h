// Random Gaussian height maps with a given power spectral density, made in Fourier space.
#pragma once

#include <cstdint>

#include "core/topography_spec.h"
#include "surfaces/spectrum_model.h"
#include "surfaces/topography.h"

namespace asperity {

/// Size and seed of a map.
struct GenerateOptions {
  int nx = 0, ny = 0;     ///< pixels
  double lx = 0, ly = 0;  ///< size [m]
  std::uint64_t seed = 1;
  Amplitudes amplitudes = Amplitudes::random;
  /// Sq that the discrete sum over the period is scaled to [m]; negative: the spectrum's own magnitude is
  /// kept
  double rms = -1;
};

/// The self-affine spectrum of a map with pixels of `spacing` [m]; a roll-off or cut-off of 0 follows from
/// the pixels: cut-off 20 nm but not below four of them, roll-off 200 nm but not below ten cut-offs. Throws
/// InputError where pixels are too large for the cut-off, or the spectrum is none.
SelfAffineSpectrum spectrum_on_pixels(double rms, double hurst, double rolloff, double cutoff,
                                      double spacing);

/// Periodic map with period lx x ly. The amplitude of a wave vector depends on (seed, its integer wave
/// numbers) only: the result is bit for bit the same on any number of threads, and the same surface on any
/// pixel grid that resolves the spectrum. Wave vectors at or above the Nyquist wave number are left out.
/// Throws InputError if nothing of the spectrum fits between the period and two pixels.
Topography generate_periodic(const Spectrum& spectrum, const GenerateOptions& options);

/// Non-periodic map: a window of lx x ly (pixels nx x ny, the same pixel size) in the centre of a larger
/// periodic map whose period is at least lx + 8 `longest_wavelength`; `rms` then belongs to the larger map.
Topography generate_window(const Spectrum& spectrum, double longest_wavelength,
                           const GenerateOptions& options);

/// sum over the wave vectors of a periodic map of C(|q|)/(lx ly) [m^2]: the expected Sq^2 of
/// generate_periodic.
double discrete_variance(const Spectrum& spectrum, int nx, int ny, double lx, double ly);

/// The nx x ny pixels of a periodic map that start at pixel (ix, iy), as a non-periodic map; every
/// `stride`-th is taken.
Topography cut_window(const Topography& periodic, int ix, int iy, int nx, int ny, int stride = 1);

}  // namespace asperity
