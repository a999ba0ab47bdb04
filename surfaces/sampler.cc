#include "surfaces/sampler.h"

#include <cmath>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/fill_missing.h"

namespace asperity {
namespace {

constexpr int degree = 5;

/// Values of the six B-splines that are not zero at t in [0, 1) (Cox and de Boor on uniform knots).
std::array<double, degree + 1> spline_weights(double t) {
  std::array<double, degree + 1> w{1.0};
  for (int p = 1; p <= degree; ++p) {
    double saved = 0;
    for (int r = 0; r < p; ++r) {
      const double share = w[r] / p;
      w[r] = saved + (r + 1 - t) * share;
      saved = (t + p - 1 - r) * share;
    }
    w[p] = saved;
  }
  return w;
}

/// Values to spline coefficients of a periodic line, in place: the recursive filter of Unser et al. (1993).
void to_coefficients(std::vector<double>& line) {
  static const std::array<double, 2> poles{std::sqrt(67.5 - std::sqrt(4436.25)) + std::sqrt(26.25) - 6.5,
                                           std::sqrt(67.5 + std::sqrt(4436.25)) - std::sqrt(26.25) - 6.5};
  const int n = static_cast<int>(line.size());
  for (const double z : poles) {
    const double gain = (1 - z) * (1 - 1 / z);
    for (double& value : line) value *= gain;
    const double wrap = 1 / (1 - std::pow(z, n));
    double sum = 0, power = 1;
    for (int k = 0; k < n; ++k, power *= z) sum += power * line[k == 0 ? 0 : n - k];
    line[0] = sum * wrap;
    for (int k = 1; k < n; ++k) line[k] += z * line[k - 1];
    sum = 0, power = 1;
    for (int k = 0; k < n; ++k, power *= z) sum += power * line[(n - 1 + k) % n];
    line[n - 1] = -z * sum * wrap;
    for (int k = n - 2; k >= 0; --k) line[k] = z * (line[k + 1] - line[k]);
  }
}

/// Filters a line of the map; a line that is not periodic is continued by its mirror image first.
void filter_line(double* values, int n, std::size_t stride, bool periodic, std::vector<double>& line) {
  line.resize(periodic ? n : 2 * n);
  for (int i = 0; i < n; ++i) line[i] = values[i * stride];
  if (!periodic)
    for (int i = 0; i < n; ++i) line[2 * n - 1 - i] = line[i];
  to_coefficients(line);
  for (int i = 0; i < n; ++i) values[i * stride] = line[i];
}

int wrapped(int i, int n, bool periodic) {
  const int period = periodic ? n : 2 * n;
  i %= period;
  if (i < 0) i += period;
  return i < n ? i : 2 * n - 1 - i;
}

}  // namespace

HeightSampler::HeightSampler(const Topography& map, Outside outside)
    : nx_(map.nx),
      ny_(map.ny),
      lx_(map.lx),
      ly_(map.ly),
      periodic_(map.periodic),
      outside_(outside),
      source_(map.source) {
  if (nx_ < 1 || ny_ < 1 || !(lx_ > 0) || !(ly_ > 0))
    throw InputError("the topography '" + source_ + "' has no points or no size");
  coefficients_ = map.missing_count() > 0 ? fill_missing(map).heights : map.heights;
#pragma omp parallel
  {
    std::vector<double> line;
#pragma omp for schedule(static)
    for (int iy = 0; iy < ny_; ++iy)
      filter_line(&coefficients_[static_cast<std::size_t>(iy) * nx_], nx_, 1, periodic_, line);
#pragma omp for schedule(static)
    for (int ix = 0; ix < nx_; ++ix) filter_line(&coefficients_[ix], ny_, nx_, periodic_, line);
  }
}

double HeightSampler::height(double x, double y) const {
  constexpr double rounding = 1e-9;  // of the size: points on the very edge belong to the map
  if (!periodic_ && outside_ == Outside::refuse &&
      (std::abs(x) > (0.5 + rounding) * lx_ || std::abs(y) > (0.5 + rounding) * ly_))
    refuse(x, y);
  const double u = (x / lx_ + 0.5) * nx_ - 0.5, v = (y / ly_ + 0.5) * ny_ - 0.5;
  const double u0 = std::floor(u), v0 = std::floor(v);
  const auto wx = spline_weights(u - u0), wy = spline_weights(v - v0);
  std::array<int, degree + 1> columns;
  for (int i = 0; i <= degree; ++i) columns[i] = wrapped(static_cast<int>(u0) - 2 + i, nx_, periodic_);
  double sum = 0;
  for (int j = 0; j <= degree; ++j) {
    const double* row =
        &coefficients_[static_cast<std::size_t>(wrapped(static_cast<int>(v0) - 2 + j, ny_, periodic_)) * nx_];
    double row_sum = 0;
    for (int i = 0; i <= degree; ++i) row_sum += wx[i] * row[columns[i]];
    sum += wy[j] * row_sum;
  }
  return sum;
}

void HeightSampler::refuse(double x, double y) const {
  const auto length = [](double value) { return format_quantity(value, Dimension::length); };
  throw InputError(
      "the topography '" + source_ + "' covers " + length(lx_) + " x " + length(ly_) +
      " but a height is needed at (" + length(x) + ", " + length(y) +
      ") from its centre; take a larger map, a smaller contact region, or its mirrored continuation");
}

}  // namespace asperity
