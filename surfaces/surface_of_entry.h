// The surface that a case's entry `Topography` stands for (core/topography_spec.h): its heights and its
// scales.
#pragma once

#include <limits>

#include "core/topography_spec.h"
#include "surfaces/generate.h"
#include "surfaces/sampler.h"
#include "surfaces/topography.h"

namespace asperity {

/// The spectrum of the surface itself: that whose scans show spectrum.rms, if it was measured in a window.
SelfAffineSpectrum surface_spectrum(const GeneratorParameters& parameters);

/// Side of a generated surface whose size is not given [m]: 64 roll-off wavelengths, but no more than 2048
/// pixels carry, and 8 roll-offs at least. It depends on the spectrum alone.
double default_period(const SelfAffineSpectrum& spectrum);

/// The grid on which a generated surface lives: its period, in square pixels of at most a quarter of the
/// cut-off. Like the surface itself it depends on the entry alone, never on a mesh, load or path: the same
/// entry is the same surface in every case. Throws InputError where that takes more pixels than memory holds.
struct GeneratorGrid {
  double period = 0;
  int pixels = 0;
};
GeneratorGrid generator_grid(const GeneratorParameters& parameters);

/// What a mesh has to know of a surface before its region is known.
struct TopographyScales {
  double rms = 0;  ///< as given, or of the whole scan [m]
  /// Wavelength down to which a mesh has to follow the surface [m]; infinite where there is no roughness.
  /// Generated: the cut-off. A scan: its cutoff= where that is given, else the wave above which lie 99 % of
  /// its slope variance, but no less than four pixels, for shorter waves are measured by too few heights.
  double shortest_wave = std::numeric_limits<double>::infinity();
  double unresolved = 0;  ///< share of a scan's slope variance in waves shorter than that [-]
  double period =
      std::numeric_limits<double>::infinity();  ///< of a generated surface, beyond which it repeats [m]
};
TopographyScales topography_scales(const TopographySpec& spec);

/// The whole topography that an entry names, centred on the contact; decided by the entry alone.
/// smooth: one pixel of height zero. A scan: see prepared_scan. generated(...): one period, expected Sq = rms
/// over the period, or, where rms was measured in a window, with the power spectral density of the surface it
/// was measured on.
Topography topography_for(const TopographySpec& spec);

/// Its heights over a square of side `size` [m] around the contact. A generated surface repeats beyond its
/// period. Throws ScanError where a scan is smaller and its entry does not ask for mirror images.
HeightSampler heights_over(const TopographySpec& spec, double size);

}  // namespace asperity
