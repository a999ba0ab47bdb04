// Convolution of a field on a grid with a kernel, by Fourier transforms: along rows, then along columns in
// one pass through the memory. The result does not depend on the number of threads.
#pragma once

#include <functional>
#include <memory>

#include "half_space/grid.h"

namespace asperity::half_space {

/// How a kernel is mirrored at both axes.
enum class Parity { even, odd };

/// Spectrum of a kernel with that parity in x and in y, real either way: of the wave numbers ix, |iy| of a
/// transform of mx x my points, [ix * (my/2 + 1) + |iy|], over the number of points.
struct KernelSpectrum {
  int mx = 0, my = 0;
  Parity parity = Parity::even;
  Field values;

  /// Of the whole spectrum, its mirror images included: the kernel at no distance.
  double sum() const;
};

/// Of a kernel that acts from cell to cell on a grid around which there is nothing: on a transform of at
/// least twice the size, so that nothing repeats (Hockney 1970). corner(x, y): what the integral over a cell
/// is the second difference of, between the corners of the cell [in the kernel's unit]; of the other parity
/// than the kernel, and asked for at x, y > 0 alone.
KernelSpectrum spectrum_of_cells(const Grid& grid, Parity parity,
                                 const std::function<double(double x, double y)>& corner);

class Convolution {
 public:
  Convolution(const Grid& grid, KernelSpectrum spectrum);
  ~Convolution();
  Convolution(Convolution&&) noexcept;

  /// Of the values of all cells. One caller at a time: it shares the work out among threads itself.
  void apply(const Field& values, Field& result) const;

  const Grid& grid() const { return grid_; }
  const KernelSpectrum& spectrum() const { return spectrum_; }

 private:
  struct Transforms;
  void transform_rows(const Field& values) const;
  void convolve_columns() const;
  void transform_rows_back(Field& result) const;

  Grid grid_;
  KernelSpectrum spectrum_;
  std::unique_ptr<Transforms> transforms_;
};

}  // namespace asperity::half_space
