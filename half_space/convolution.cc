#include "half_space/convolution.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "core/threads.h"
#include "surfaces/fft2d.h"
#include "surfaces/fftw_parts.h"

namespace asperity::half_space {
namespace {

/// A kernel's integrals over cells up to a distance of mx/2 and my/2 of them.
class CellKernel {
 public:
  CellKernel(const Grid& grid, Parity parity, int mx, int my,
             const std::function<double(double, double)>& corner)
      : nx_(mx / 2 + 1),
        mirrored_(parity == Parity::even ? -1 : 1),
        corner_(static_cast<std::size_t>(nx_) * (my / 2 + 1)) {
    for_parts(my / 2 + 1, 1, [&](int j, int end) {
      for (; j < end; ++j)
        for (int i = 0; i < nx_; ++i)
          corner_[static_cast<std::size_t>(j) * nx_ + i] = corner((i + 0.5) * grid.dx, (j + 0.5) * grid.dy);
    });
  }
  double operator()(int i, int j) const {
    // Corners half a cell before the origin mirror those behind it.
    const int x = std::max(0, i - 1), y = std::max(0, j - 1);
    const double across = i == 0 ? mirrored_ : 1, along = j == 0 ? mirrored_ : 1;
    return at(i, j) - across * at(x, j) - along * at(i, y) + across * along * at(x, y);
  }

 private:
  double at(int i, int j) const { return corner_[static_cast<std::size_t>(j) * nx_ + i]; }
  int nx_;
  double mirrored_;
  Field corner_;
};

/// Copies what lies before the middle of a line behind it.
void mirror(double* line, int n, Parity parity) {
  const double sign = parity == Parity::even ? 1 : -1;
  for (int i = n / 2 + 1; i < n; ++i) line[i] = sign * line[n - i];
  if (parity == Parity::odd) line[0] = line[n / 2] = 0;
}

constexpr int columns_at_a_time = 4;                       // a cache line of each row
constexpr int lines_at_a_time = 16, blocks_at_a_time = 4;  // of a thread, some tens of microseconds

}  // namespace

double KernelSpectrum::sum() const {
  if (parity == Parity::odd) return 0;
  const int columns = mx / 2 + 1, rows = my / 2 + 1;
  double sum = 0;
  for (int ix = 0; ix < columns; ++ix)
    for (int iy = 0; iy < rows; ++iy) {
      const double images = (ix == 0 || 2 * ix == mx ? 1 : 2) * (iy == 0 || 2 * iy == my ? 1 : 2);
      sum += images * values[static_cast<std::size_t>(ix) * rows + iy];
    }
  return sum;
}

/// Each transform of a line is real for an even kernel, imaginary for an odd one, whose two transforms have a
/// real product; a quarter says all.
KernelSpectrum spectrum_of_cells(const Grid& grid, Parity parity,
                                 const std::function<double(double, double)>& corner) {
  KernelSpectrum spectrum{fast_fft_length(2.0 * grid.nx), fast_fft_length(2.0 * grid.ny), parity, {}};
  const int mx = spectrum.mx, my = spectrum.my, columns = mx / 2 + 1, rows = my / 2 + 1;
  const CellKernel kernel(grid, parity, mx, my, corner);
  const FftwPlan along_x = plan_to_complex(mx), along_y = plan_to_complex(my);
  const int part = parity == Parity::even ? 0 : 1;
  const double scale = (parity == Parity::even ? 1 : -1) / (static_cast<double>(mx) * my);
  spectrum.values.resize(static_cast<std::size_t>(columns) * rows);
  for_parts(rows, lines_at_a_time, [&](int iy, int end) {
    const auto in = fftw_reals(mx);
    const auto out = fftw_complexes(columns);
    for (; iy < end; ++iy) {
      for (int ix = 0; ix < columns; ++ix) in[ix] = kernel(ix, iy);
      mirror(in.get(), mx, parity);
      fftw_execute_dft_r2c(along_x.get(), in.get(), out.get());
      for (int ix = 0; ix < columns; ++ix)
        spectrum.values[static_cast<std::size_t>(ix) * rows + iy] = out[ix][part];
    }
  });
  for_parts(columns, lines_at_a_time, [&](int ix, int end) {
    const auto in = fftw_reals(my);
    const auto out = fftw_complexes(rows);
    for (; ix < end; ++ix) {
      double* const line = &spectrum.values[static_cast<std::size_t>(ix) * rows];
      std::copy_n(line, rows, in.get());
      mirror(in.get(), my, parity);
      fftw_execute_dft_r2c(along_y.get(), in.get(), out.get());
      for (int iy = 0; iy < rows; ++iy) line[iy] = scale * out[iy][part];
    }
  });
  return spectrum;
}

struct Convolution::Transforms {
  FftwPlan rows, rows_back, columns, columns_back;
  std::vector<std::complex<double>> half;  ///< spectra of the grid's own rows: [iy * columns + ix]
};

Convolution::~Convolution() = default;
Convolution::Convolution(Convolution&&) noexcept = default;

Convolution::Convolution(const Grid& grid, KernelSpectrum spectrum)
    : grid_(grid), spectrum_(std::move(spectrum)) {
  const int columns = spectrum_.mx / 2 + 1;
  transforms_ = std::make_unique<Transforms>(Transforms{plan_to_complex(spectrum_.mx),
                                                        plan_to_real(spectrum_.mx),
                                                        plan_complex(spectrum_.my, FFTW_FORWARD),
                                                        plan_complex(spectrum_.my, FFTW_BACKWARD),
                                                        {}});
  transforms_->half.resize(static_cast<std::size_t>(columns) * grid.ny);
}

void Convolution::apply(const Field& values, Field& result) const {
  result.resize(grid_.cells());
  transform_rows(values);
  convolve_columns();
  transform_rows_back(result);
}

void Convolution::transform_rows(const Field& values) const {
  const int columns = spectrum_.mx / 2 + 1;
  for_parts(grid_.ny, lines_at_a_time, [&](int iy, int end) {
    const auto in = fftw_reals(spectrum_.mx);
    std::fill_n(in.get(), spectrum_.mx, 0.0);
    const auto out = fftw_complexes(columns);
    for (; iy < end; ++iy) {
      std::copy_n(&values[static_cast<std::size_t>(iy) * grid_.nx], grid_.nx, in.get());
      fftw_execute_dft_r2c(transforms_->rows.get(), in.get(), out.get());
      std::copy_n(reinterpret_cast<const std::complex<double>*>(out.get()), columns,
                  &transforms_->half[static_cast<std::size_t>(iy) * columns]);
    }
  });
}

void Convolution::convolve_columns() const {
  const int columns = spectrum_.mx / 2 + 1, rows = spectrum_.my / 2 + 1, ny = grid_.ny;
  const double mirrored = spectrum_.parity == Parity::even ? 1 : -1;
  const int blocks = (columns + columns_at_a_time - 1) / columns_at_a_time;
  for_parts(blocks, blocks_at_a_time, [&](int block, int end) {
    // In one pass through the memory: there, product, and back.
    const auto buffer = fftw_complexes(columns_at_a_time * spectrum_.my);
    const auto line = [&](int b) {
      return reinterpret_cast<std::complex<double>*>(buffer.get()) +
             static_cast<std::size_t>(b) * spectrum_.my;
    };
    for (; block < end; ++block) {
      const int first = block * columns_at_a_time;
      const int width = std::min(columns_at_a_time, columns - first);
      for (int iy = 0; iy < ny; ++iy)
        for (int b = 0; b < width; ++b)
          line(b)[iy] = transforms_->half[static_cast<std::size_t>(iy) * columns + first + b];
      for (int b = 0; b < width; ++b) {
        std::complex<double>* const values = line(b);
        std::fill(values + ny, values + spectrum_.my, std::complex<double>());
        auto* const raw = reinterpret_cast<fftw_complex*>(values);
        fftw_execute_dft(transforms_->columns.get(), raw, raw);
        const double* const kernel = &spectrum_.values[static_cast<std::size_t>(first + b) * rows];
        for (int iy = 0; iy < rows; ++iy) values[iy] *= kernel[iy];
        for (int iy = rows; iy < spectrum_.my; ++iy) values[iy] *= mirrored * kernel[spectrum_.my - iy];
        fftw_execute_dft(transforms_->columns_back.get(), raw, raw);
      }
      for (int iy = 0; iy < ny; ++iy)
        for (int b = 0; b < width; ++b)
          transforms_->half[static_cast<std::size_t>(iy) * columns + first + b] = line(b)[iy];
    }
  });
}

void Convolution::transform_rows_back(Field& result) const {
  const int columns = spectrum_.mx / 2 + 1;
  for_parts(grid_.ny, lines_at_a_time, [&](int iy, int end) {
    const auto in = fftw_complexes(columns);
    const auto out = fftw_reals(spectrum_.mx);
    for (; iy < end; ++iy) {
      std::copy_n(&transforms_->half[static_cast<std::size_t>(iy) * columns], columns,
                  reinterpret_cast<std::complex<double>*>(in.get()));
      fftw_execute_dft_c2r(transforms_->rows_back.get(), in.get(), out.get());
      std::copy_n(out.get(), grid_.nx, &result[static_cast<std::size_t>(iy) * grid_.nx]);
    }
  });
}

}  // namespace asperity::half_space
