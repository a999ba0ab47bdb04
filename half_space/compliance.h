// Normal displacements of the surface of an elastic half-space by pressures on it, as a convolution by
// Fourier transforms. E* of the pair stands for both bodies: their displacements add up.
//
// free: a uniform pressure on each cell, the displacement at its centre (Love 1929, Phil. Trans. R. Soc. A
// 228, 377; Johnson 1985, eq. 3.25), on a grid of twice the size so that nothing repeats (Hockney 1970; Liu,
// Wang & Liu 2000, Wear 243, 101). periodic: u(q) = 2 p(q) / (E* q) for each wave, the mean left out (Johnson
// 1985, ch. 13). The result does not depend on the number of threads.
#pragma once

#include <memory>

#include "half_space/grid.h"

namespace asperity::half_space {

class Compliance {
 public:
  /// modulus: E* [Pa]. A periodic grid has even numbers of cells. Throws InputError for a grid without cells
  /// or a modulus that is not above 0.
  Compliance(const Grid& grid, Boundary boundary, double modulus);
  ~Compliance();
  Compliance(Compliance&&) noexcept;

  /// The displacement into the bodies [m], by which the gap opens, of each cell by the pressure [Pa] of all.
  /// One caller at a time: it shares the work out among threads itself.
  void apply(const Field& pressure, Field& displacement) const;

  /// Displacement of a cell by a unit pressure on itself [m/Pa].
  double of_one_cell() const { return of_one_cell_; }

  const Grid& grid() const { return grid_; }
  Boundary boundary() const { return boundary_; }

 private:
  struct Transforms;
  void transform_rows(const Field& pressure) const;
  void convolve_columns() const;
  void transform_rows_back(Field& displacement) const;

  Grid grid_;
  Boundary boundary_;
  int mx_, my_;  ///< sizes of the transforms
  double of_one_cell_ = 0;
  Field spectrum_;  ///< of the kernel, real and even: [ix * (my/2 + 1) + |iy|], over the number of points
  std::unique_ptr<Transforms> transforms_;
};

}  // namespace asperity::half_space
