#include "tests/fem/support/half_space.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "surfaces/fft2d.h"

namespace asperity::test {
namespace {

using Field = std::vector<double>;

/// Displacement at (x, y) by a unit pressure on a square of side h about the origin, times pi E* (Love 1929;
/// Johnson 1985 eq. 3.25).
double love(double x, double y, double h) {
  const double a = 0.5 * h;
  const auto term = [](double p, double q) {
    return p * std::asinh(q / std::abs(p)) + q * std::asinh(p / std::abs(q));
  };
  return term(x + a, y + a) - term(x - a, y + a) - term(x + a, y - a) + term(x - a, y - a);
}

/// Pressure of n x n cells to the displacement of their centres.
class Compliance {
 public:
  Compliance(int n, double h, double modulus) : n_(n), m_(fast_fft_length(2 * n)) {
    Field kernel(static_cast<std::size_t>(m_) * m_);
    for (int j = 0; j < m_; ++j)
      for (int i = 0; i < m_; ++i)
        kernel[static_cast<std::size_t>(j) * m_ + i] =
            love(signed_wave_number(i, m_) * h, signed_wave_number(j, m_) * h, h) / (M_PI * modulus);
    spectrum_ = forward_fft(kernel, m_, m_);
  }
  Field operator()(const Field& pressure) const {
    Field padded(static_cast<std::size_t>(m_) * m_, 0.0);
    for (int j = 0; j < n_; ++j)
      std::copy_n(&pressure[static_cast<std::size_t>(j) * n_], n_, &padded[static_cast<std::size_t>(j) * m_]);
    HalfSpectrum product = forward_fft(padded, m_, m_);
    for (std::size_t k = 0; k < product.size(); ++k) product[k] *= spectrum_[k];
    const Field whole = inverse_fft(std::move(product), m_, m_);
    Field displacement(pressure.size());
    const double scale = 1.0 / (static_cast<double>(m_) * m_);
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i < n_; ++i)
        displacement[static_cast<std::size_t>(j) * n_ + i] =
            scale * whole[static_cast<std::size_t>(j) * m_ + i];
    return displacement;
  }

 private:
  int n_, m_;
  HalfSpectrum spectrum_;
};

double mean_where(const Field& values, const Field& pressure) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (pressure[k] > 0) sum += values[k], ++count;
  return sum / count;
}

/// Number of sides between closed and open cells.
int sides_of_the_edge(const Field& pressure, int n) {
  int sides = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      sides += (pressure[j * n + i] > 0) != (pressure[j * n + i + 1] > 0);
      sides += (pressure[i * n + j] > 0) != (pressure[(i + 1) * n + j] > 0);
    }
  return sides;
}

}  // namespace

HalfSpaceContact half_space_contact(const std::function<double(double, double)>& gap, double half_width,
                                    int n, double modulus, double force) {
  const double h = 2 * half_width / n, cell = h * h;
  const std::size_t cells = static_cast<std::size_t>(n) * n;
  Field initial(cells), pressure(cells, force / (cells * cell)), direction(cells, 0.0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      initial[static_cast<std::size_t>(j) * n + i] =
          gap((i + 0.5) * h - half_width, (j + 0.5) * h - half_width);
  const Compliance compliance(n, h, modulus);
  HalfSpaceContact result;
  double before = 1, keep = 0;
  constexpr int most = 2000;
  constexpr double accuracy = 1e-7;
  for (result.iterations = 1; result.iterations <= most; ++result.iterations) {
    Field open = compliance(pressure);
    for (std::size_t k = 0; k < cells; ++k) open[k] += initial[k];
    result.approach = mean_where(open, pressure);
    double squares = 0;
    for (std::size_t k = 0; k < cells; ++k) {
      open[k] -= result.approach;
      if (pressure[k] > 0) squares += open[k] * open[k];
    }
    for (std::size_t k = 0; k < cells; ++k)
      direction[k] = pressure[k] > 0 ? open[k] + keep * squares / before * direction[k] : 0.0;
    before = squares;
    Field response = compliance(direction);
    const double mean = mean_where(response, pressure);
    double along = 0, stiffness = 0;
    for (std::size_t k = 0; k < cells; ++k)
      if (pressure[k] > 0) along += open[k] * direction[k], stiffness += (response[k] - mean) * direction[k];
    const double step = along / stiffness;
    double change = 0, sum = 0;
    const Field old = pressure;
    for (std::size_t k = 0; k < cells; ++k)
      if (pressure[k] > 0) pressure[k] = std::max(0.0, pressure[k] - step * direction[k]);
    keep = 1;
    for (std::size_t k = 0; k < cells; ++k) {
      if (pressure[k] == 0 && open[k] < 0) pressure[k] = -step * open[k], keep = 0;
      sum += pressure[k] * cell;
    }
    for (std::size_t k = 0; k < cells; ++k)
      pressure[k] *= force / sum, change += std::abs(pressure[k] - old[k]) * cell;
    if (change < accuracy * force) break;
  }
  if (result.iterations > most) throw WorkError("the half-space contact of the test has not converged");
  double closed = 0;
  for (const double p : pressure)
    closed += p > 0, result.largest_pressure = std::max(result.largest_pressure, p);
  const double excess = (M_PI - 1 + std::log(2.0)) / 24;
  result.area = (closed - excess * sides_of_the_edge(pressure, n)) * cell;
  result.first_touch = *std::min_element(initial.begin(), initial.end());
  for (std::size_t k = 0; k < cells; ++k) {
    const double part = pressure[k] * cell / force;
    result.centre_x += part * ((k % n + 0.5) * h - half_width);
    result.centre_y += part * ((k / n + 0.5) * h - half_width);
  }
  return result;
}

double half_space_stiffness(const std::function<double(double, double)>& gap, double half_width, int n,
                            double modulus, double force) {
  constexpr double share = 0.01;
  const auto approach = [&](double f) { return half_space_contact(gap, half_width, n, modulus, f).approach; };
  return 2 * share * force / (approach((1 + share) * force) - approach((1 - share) * force));
}

}  // namespace asperity::test
