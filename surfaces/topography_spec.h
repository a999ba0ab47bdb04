// What a case file's entry `Topography` means: smooth | a scan (surfaces/scan_spec.h) | generated(rms=1.5 nm, ...).
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "surfaces/generate.h"
#include "surfaces/topography.h"

namespace asperity {

/// Arguments of generated(...): a self-affine spectrum (surfaces/spectrum_model.h) and a seed.
struct GeneratorParameters {
  SelfAffineSpectrum spectrum{0.0, 0.8, 200e-9, 20e-9};
  std::uint64_t seed = 1;
  Amplitudes amplitudes = Amplitudes::random;
  /// Side of the scans in which spectrum.rms was measured [m] (512 x 512 pixels, mean plane removed, mean over many scans:
  /// surfaces/virtual_afm.h); 0: spectrum.rms is that of the whole surface.
  double window = 0;

  /// The spectrum of the surface itself: that whose scans show spectrum.rms, if it was measured.
  SelfAffineSpectrum surface_spectrum() const;

  /// "generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=20 nm, seed=3)"
  std::string text() const;
};

/// True if the entry calls the generator.
bool is_generator_call(const std::string& spec);

/// Reads "generated(key=value, ...)". Keys: rms (needed), window, hurst, rolloff, cutoff, seed, amplitudes (random
/// or fixed). Throws InputError naming the key that is unknown, missing, twice there, or has a value out of
/// range.
GeneratorParameters parse_generator(const std::string& spec);

/// The grid on which a generated surface lives. It depends on the spectrum and, for large regions, on the
/// size of the region, never on a mesh: period = 8 roll-off wavelengths, doubled until it is at least `size`;
/// square pixels of at most a quarter of the cut-off. The same seed thus is the same surface for every region
/// of up to 8 roll-offs, and the surface repeats beyond its period.
struct GeneratorGrid {
  double period = 0;
  int pixels = 0;
};
GeneratorGrid generator_grid(const GeneratorParameters& parameters, double size);

/// True if the entry names a measured scan.
bool is_scan(const std::string& spec);

/// What a mesh has to know of a surface before its region is known.
struct TopographyScales {
  double rms = 0;                                                   ///< as given, or of the whole scan [m]
  double shortest_wave = std::numeric_limits<double>::infinity();  ///< [m]; infinite where there is none or it is not known
};
TopographyScales topography_scales(const std::string& spec);

/// The topography of a square region of side `size` [m] around the contact.
/// smooth: one pixel of height zero. A scan: see scan_over. generated(...): the whole period, expected Sq = rms over the
/// period, or, where rms was measured in a window, with the power spectral density of the surface it was measured on.
/// `spacing` [m] is the mesh's; the surface does not depend on it (a mesh coarser than the pixels samples the surface).
Topography topography_for(const std::string& spec, double size, double spacing);

}  // namespace asperity
