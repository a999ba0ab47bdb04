// Normal displacements of the surface of an elastic half-space by pressures on it. E* of the pair stands for
// both bodies: their displacements add up.
//
// free: a uniform pressure on each cell, the displacement at its centre (Love 1929, Phil. Trans. R. Soc. A
// 228, 377; Johnson 1985, eq. 3.25; Liu, Wang & Liu 2000, Wear 243, 101). periodic: u(q) = 2 p(q) / (E* q)
// for each wave, the mean left out (Johnson 1985, ch. 13).
// A film that is bonded to one of the bodies changes that (film_on_body.h): around a force on a free grid,
// wave by wave on one that repeats.
#pragma once

#include <vector>

#include "half_space/convolution.h"
#include "half_space/film_on_body.h"

namespace asperity::half_space {

class Compliance {
 public:
  /// modulus: E* of the bodies [Pa]. A periodic grid has even numbers of cells. Throws InputError for a grid
  /// without cells, or a modulus or thickness that is not above 0.
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
