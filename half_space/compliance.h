// Normal displacements of the surface of an elastic half-space by pressures on it. E* of the pair stands for
// both bodies: their displacements add up.
//
// free: a uniform pressure on each cell, the displacement at its centre (Love 1929, Phil. Trans. R. Soc. A
// 228, 377; Johnson 1985, eq. 3.25; Liu, Wang & Liu 2000, Wear 243, 101). periodic: u(q) = 2 p(q) / (E* q)
// for each wave, the mean left out (Johnson 1985, ch. 13).
// A film that is bonded to one of the bodies adds what its body then gives way more, wave by wave (Burmister
// 1945, J. Appl. Phys. 16, 89; Nogi & Kato 1997, J. Tribol. 119, 493), with e = exp(-2 q t):
//   u/p = (1 - nu_f)/(G_f q) [1 + 4 q t K e - lambda K e^2]/[1 - (lambda + K + 4 K q^2 t^2) e + lambda K
//   e^2], lambda = 1 - 4 (1 - nu_f)/[1 + (3 - 4 nu) G_f/G],  K = (G_f/G - 1)/(G_f/G + 3 - 4 nu_f).
// On a free grid this reaches no further than some thicknesses: the film must be thin against the grid.
#pragma once

#include <vector>

#include "core/hertz.h"
#include "half_space/convolution.h"

namespace asperity::half_space {

/// Least width of a free grid over the thickness of a film on it [-].
constexpr double thicknesses_on_grid = 8;

/// An elastic film on an elastic body.
struct FilmOnBody {
  ElasticBody film, body;
  double thickness = 0;  ///< [m]

  /// Displacement over pressure of a wave of wave number q [1/m], less that of the body alone [m/Pa].
  double compliance(double q) const;
};

class Compliance {
 public:
  /// modulus: E* of the bodies [Pa]. A periodic grid has even numbers of cells. Throws InputError for a grid
  /// without cells, a modulus that is not above 0, or a film that is too thick for a free grid.
  Compliance(const Grid& grid, Boundary boundary, double modulus, const std::vector<FilmOnBody>& films = {});

  /// The displacement into the bodies [m], by which the gap opens, of each cell by the pressure [Pa] of all.
  /// One caller at a time: it shares the work out among threads itself.
  void apply(const Field& pressure, Field& displacement) const { convolution_.apply(pressure, displacement); }

  /// Displacement of a cell by a unit pressure on itself [m/Pa].
  double of_one_cell() const { return of_one_cell_; }

  const Grid& grid() const { return convolution_.grid(); }
  Boundary boundary() const { return boundary_; }

 private:
  Boundary boundary_;
  Convolution convolution_;
  double of_one_cell_;
};

}  // namespace asperity::half_space
