// The radially averaged power spectral density C(q) of a height map (convention: surfaces/spectrum_model.h).
#pragma once

#include <vector>

#include "surfaces/spectrum_model.h"
#include "surfaces/topography.h"

namespace asperity {

/// Rings of wave vectors of width 2 pi / min(lx, ly), centred at its multiples, up to the Nyquist wave
/// number.
struct RadialSpectrum {
  std::vector<double> q;  ///< mean wave number of the ring [rad/m]
  std::vector<double> C;  ///< mean of lx ly |a_q|^2 over the ring [m^4]
  /// independent periodograms averaged: the wave vectors of half the ring; after a window fewer, counted for
  /// means over several rings, since what the window makes dependent lies partly in neighbouring rings
  std::vector<double> modes;

  double rms = 0;  ///< the Sq that all rings add up to [m]
  /// As a model to generate from; rings without power are left out.
  TabulatedSpectrum table() const;
};

/// Periodic maps are transformed as they are. Others: the mean plane is removed, then a Hann window in x and
/// y of mean square one; Hann smears each wave vector over its neighbours (only 1/3.78 of them stay
/// independent) but leaks as q^-6 in amplitude^2, steeper than any self-affine spectrum. Missing points are
/// filled first (fill_missing.h).
RadialSpectrum radial_spectrum(const Topography& map);

}  // namespace asperity
