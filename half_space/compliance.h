// Normal displacements of the surface of an elastic half-space by pressures on it. E* of the pair stands for
// both bodies: their displacements add up.
//
// free: a uniform pressure on each cell, the displacement at its centre (Love 1929, Phil. Trans. R. Soc. A
// 228, 377; Johnson 1985, eq. 3.25; Liu, Wang & Liu 2000, Wear 243, 101). periodic: u(q) = 2 p(q) / (E* q)
// for each wave, the mean left out (Johnson 1985, ch. 13).
#pragma once

#include "half_space/convolution.h"

namespace asperity::half_space {

class Compliance {
 public:
  /// modulus: E* [Pa]. A periodic grid has even numbers of cells. Throws InputError for a grid without cells
  /// or a modulus that is not above 0.
  Compliance(const Grid& grid, Boundary boundary, double modulus);

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
