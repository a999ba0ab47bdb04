#include "half_space/compliance.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/error.h"
#include "surfaces/fft2d.h"
#include "surfaces/fftw_parts.h"

namespace asperity::half_space {
namespace {

/// Of whose second differences the displacement by a uniform pressure on a rectangle is made, over p / (pi
/// E*); odd in x and y (Johnson 1985, eq. 3.25).
double love_corner(double x, double y) { return x * std::asinh(y / x) + y * std::asinh(x / y); }

/// Displacements by a unit pressure on one cell, up to a distance of mx/2 and my/2 cells [m/Pa].
class LoveKernel {
 public:
  LoveKernel(const Grid& grid, int mx, int my, double modulus)
      : nx_(mx / 2 + 1), scale_(1 / (M_PI * modulus)), corner_(static_cast<std::size_t>(nx_) * (my / 2 + 1)) {
#pragma omp parallel for schedule(static)
    for (int j = 0; j <= my / 2; ++j)
      for (int i = 0; i < nx_; ++i) at(i, j) = love_corner((i + 0.5) * grid.dx, (j + 0.5) * grid.dy);
  }
  double operator()(int i, int j) const {
    // Corners half a cell before the origin mirror those behind it.
    const int x = std::max(0, i - 1), y = std::max(0, j - 1);
    const double across = i == 0 ? -1 : 1, along = j == 0 ? -1 : 1;
    return scale_ * (at(i, j) - across * at(x, j) - along * at(i, y) + across * along * at(x, y));
  }

 private:
  double& at(int i, int j) { return corner_[static_cast<std::size_t>(j) * nx_ + i]; }
  double at(int i, int j) const { return corner_[static_cast<std::size_t>(j) * nx_ + i]; }
  int nx_;
  double scale_;
  Field corner_;
};

/// The kernel is even along both axes, so that each transform of a line is real and a quarter says all.
Field free_spectrum(const Grid& grid, int mx, int my, double modulus) {
  const int columns = mx / 2 + 1, rows = my / 2 + 1;
  const LoveKernel kernel(grid, mx, my, modulus);
  const FftwPlan along_x = plan_to_complex(mx), along_y = plan_to_complex(my);
  const double scale = 1 / (static_cast<double>(mx) * my);
  Field spectrum(static_cast<std::size_t>(columns) * rows);
#pragma omp parallel
  {
    const auto in = fftw_reals(std::max(mx, my));
    const auto out = fftw_complexes(std::max(columns, rows));
#pragma omp for schedule(static)
    for (int iy = 0; iy < rows; ++iy) {
      for (int ix = 0; ix < columns; ++ix) in[ix] = kernel(ix, iy);
      for (int ix = columns; ix < mx; ++ix) in[ix] = in[mx - ix];
      fftw_execute_dft_r2c(along_x.get(), in.get(), out.get());
      for (int ix = 0; ix < columns; ++ix) spectrum[static_cast<std::size_t>(ix) * rows + iy] = out[ix][0];
    }
#pragma omp for schedule(static)
    for (int ix = 0; ix < columns; ++ix) {
      double* const line = &spectrum[static_cast<std::size_t>(ix) * rows];
      for (int iy = 0; iy < rows; ++iy) in[iy] = line[iy];
      for (int iy = rows; iy < my; ++iy) in[iy] = line[my - iy];
      fftw_execute_dft_r2c(along_y.get(), in.get(), out.get());
      for (int iy = 0; iy < rows; ++iy) line[iy] = scale * out[iy][0];
    }
  }
  return spectrum;
}

Field periodic_spectrum(const Grid& grid, double modulus) {
  const int columns = grid.nx / 2 + 1, rows = grid.ny / 2 + 1;
  const double scale = 1 / static_cast<double>(grid.cells());
  Field spectrum(static_cast<std::size_t>(columns) * rows);
  for (int ix = 0; ix < columns; ++ix)
    for (int iy = 0; iy < rows; ++iy) {
      const double q = 2 * M_PI * std::hypot(ix / (grid.nx * grid.dx), iy / (grid.ny * grid.dy));
      spectrum[static_cast<std::size_t>(ix) * rows + iy] = q > 0 ? scale * 2 / (modulus * q) : 0.0;
    }
  return spectrum;
}

/// Of the whole spectrum, its mirror images included.
double sum_of(const Field& spectrum, int mx, int my) {
  const int columns = mx / 2 + 1, rows = my / 2 + 1;
  double sum = 0;
  for (int ix = 0; ix < columns; ++ix)
    for (int iy = 0; iy < rows; ++iy) {
      const double images = (ix == 0 || 2 * ix == mx ? 1 : 2) * (iy == 0 || 2 * iy == my ? 1 : 2);
      sum += images * spectrum[static_cast<std::size_t>(ix) * rows + iy];
    }
  return sum;
}

constexpr int columns_at_a_time = 4;  // a cache line of each row

}  // namespace

struct Compliance::Transforms {
  FftwPlan rows, rows_back, columns, columns_back;
  std::vector<std::complex<double>> half;  ///< spectra of the grid's own rows: [iy * columns + ix]
};

Compliance::~Compliance() = default;
Compliance::Compliance(Compliance&&) noexcept = default;

Compliance::Compliance(const Grid& grid, Boundary boundary, double modulus)
    : grid_(grid), boundary_(boundary), mx_(grid.nx), my_(grid.ny) {
  const bool is_free = boundary == Boundary::free;
  if (grid.nx < 1 || grid.ny < 1 || !(grid.dx > 0) || !(grid.dy > 0) || !std::isfinite(grid.dx + grid.dy))
    throw InputError("a half-space needs a grid with cells of some size");
  if (!(modulus > 0) || !std::isfinite(modulus))
    throw InputError("a half-space needs a finite modulus above 0");
  if (!is_free && (grid.nx % 2 != 0 || grid.ny % 2 != 0))
    throw InputError("a half-space that repeats needs even numbers of cells");
  if (is_free) mx_ = fast_fft_length(2.0 * grid.nx), my_ = fast_fft_length(2.0 * grid.ny);
  spectrum_ = is_free ? free_spectrum(grid, mx_, my_, modulus) : periodic_spectrum(grid, modulus);
  of_one_cell_ = sum_of(spectrum_, mx_, my_);
  const int columns = mx_ / 2 + 1;
  transforms_ = std::make_unique<Transforms>(Transforms{plan_to_complex(mx_),
                                                        plan_to_real(mx_),
                                                        plan_complex(my_, FFTW_FORWARD),
                                                        plan_complex(my_, FFTW_BACKWARD),
                                                        {}});
  transforms_->half.resize(static_cast<std::size_t>(columns) * grid.ny);
}

void Compliance::apply(const Field& pressure, Field& displacement) const {
  displacement.resize(grid_.cells());
  transform_rows(pressure);
  convolve_columns();
  transform_rows_back(displacement);
}

void Compliance::transform_rows(const Field& pressure) const {
  const int columns = mx_ / 2 + 1;
#pragma omp parallel
  {
    const auto in = fftw_reals(mx_);
    std::fill_n(in.get(), mx_, 0.0);
    const auto out = fftw_complexes(columns);
#pragma omp for schedule(static)
    for (int iy = 0; iy < grid_.ny; ++iy) {
      std::copy_n(&pressure[static_cast<std::size_t>(iy) * grid_.nx], grid_.nx, in.get());
      fftw_execute_dft_r2c(transforms_->rows.get(), in.get(), out.get());
      std::copy_n(reinterpret_cast<const std::complex<double>*>(out.get()), columns,
                  &transforms_->half[static_cast<std::size_t>(iy) * columns]);
    }
  }
}

void Compliance::convolve_columns() const {
  const int columns = mx_ / 2 + 1, rows = my_ / 2 + 1, ny = grid_.ny;
#pragma omp parallel
  {
    // In one pass through the memory: there, product, and back.
    const auto buffer = fftw_complexes(columns_at_a_time * my_);
    const auto line = [&](int b) {
      return reinterpret_cast<std::complex<double>*>(buffer.get()) + static_cast<std::size_t>(b) * my_;
    };
#pragma omp for schedule(static)
    for (int first = 0; first < columns; first += columns_at_a_time) {
      const int width = std::min(columns_at_a_time, columns - first);
      for (int iy = 0; iy < ny; ++iy)
        for (int b = 0; b < width; ++b)
          line(b)[iy] = transforms_->half[static_cast<std::size_t>(iy) * columns + first + b];
      for (int b = 0; b < width; ++b) {
        std::complex<double>* const values = line(b);
        std::fill(values + ny, values + my_, std::complex<double>());
        auto* const raw = reinterpret_cast<fftw_complex*>(values);
        fftw_execute_dft(transforms_->columns.get(), raw, raw);
        const double* const kernel = &spectrum_[static_cast<std::size_t>(first + b) * rows];
        for (int iy = 0; iy < rows; ++iy) values[iy] *= kernel[iy];
        for (int iy = rows; iy < my_; ++iy) values[iy] *= kernel[my_ - iy];
        fftw_execute_dft(transforms_->columns_back.get(), raw, raw);
      }
      for (int iy = 0; iy < ny; ++iy)
        for (int b = 0; b < width; ++b)
          transforms_->half[static_cast<std::size_t>(iy) * columns + first + b] = line(b)[iy];
    }
  }
}

void Compliance::transform_rows_back(Field& displacement) const {
  const int columns = mx_ / 2 + 1;
#pragma omp parallel
  {
    const auto in = fftw_complexes(columns);
    const auto out = fftw_reals(mx_);
#pragma omp for schedule(static)
    for (int iy = 0; iy < grid_.ny; ++iy) {
      std::copy_n(&transforms_->half[static_cast<std::size_t>(iy) * columns], columns,
                  reinterpret_cast<std::complex<double>*>(in.get()));
      fftw_execute_dft_c2r(transforms_->rows_back.get(), in.get(), out.get());
      std::copy_n(out.get(), grid_.nx, &displacement[static_cast<std::size_t>(iy) * grid_.nx]);
    }
  }
}

}  // namespace asperity::half_space
