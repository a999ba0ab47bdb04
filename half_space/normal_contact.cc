#include "half_space/normal_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/quantity.h"
#include "core/threads.h"
#include "half_space/bounded_gradients.h"

namespace asperity::half_space {
namespace {

/// A grid of fewer cells than that on a side needs no coarser one.
constexpr int smallest_side = 64;

bool has_coarser(const Grid& grid) {
  return grid.nx % 4 == 0 && grid.ny % 4 == 0 && grid.nx / 2 >= smallest_side && grid.ny / 2 >= smallest_side;
}

Grid coarser(const Grid& grid) { return {grid.nx / 2, grid.ny / 2, 2 * grid.dx, 2 * grid.dy}; }

/// Means of four cells.
Field coarsened(const Field& fine, const Grid& grid) {
  const Grid half = coarser(grid);
  Field coarse(half.cells());
  for (int j = 0; j < half.ny; ++j)
    for (int i = 0; i < half.nx; ++i) {
      const double* low = &fine[static_cast<std::size_t>(2 * j) * grid.nx + static_cast<std::size_t>(2 * i)];
      coarse[static_cast<std::size_t>(j) * half.nx + i] =
          0.25 * (low[0] + low[1] + low[grid.nx] + low[grid.nx + 1]);
    }
  return coarse;
}

/// Bilinear between the centres of the coarse cells.
Field refined(const Field& coarse, const Grid& fine, Boundary boundary) {
  const int nx = fine.nx / 2, ny = fine.ny / 2;
  const auto neighbour = [&](int i, int n) {
    const int to = i % 2 == 0 ? i / 2 - 1 : i / 2 + 1;
    return boundary == Boundary::periodic ? (to + n) % n : std::clamp(to, 0, n - 1);
  };
  Field result(fine.cells());
  constexpr int rows_at_a_time = 8;
  for_parts(fine.ny, rows_at_a_time, [&](int j, int end) {
    for (; j < end; ++j) {
      const double* own = &coarse[static_cast<std::size_t>(j / 2) * nx];
      const double* other = &coarse[static_cast<std::size_t>(neighbour(j, ny)) * nx];
      for (int i = 0; i < fine.nx; ++i) {
        const int a = i / 2, b = neighbour(i, nx);
        result[static_cast<std::size_t>(j) * fine.nx + i] =
            0.75 * (0.75 * own[a] + 0.25 * own[b]) + 0.25 * (0.75 * other[a] + 0.25 * other[b]);
      }
    }
  });
  return result;
}

/// Pressures to begin with: the mean one at a given force; under a given approach, of a punch as wide as what
/// overlaps.
Field first_guess(const Grid& grid, const Field& gap, const NormalLoad& load, double modulus,
                  double hardness) {
  if (load.by_force)
    return Field(grid.cells(), load.value / (grid.cell_area() * static_cast<double>(grid.cells())));
  double overlapping = 0;
  for (const double g : gap) overlapping += g < load.value;
  const double width = std::sqrt(std::max(1.0, overlapping) * grid.cell_area());
  Field pressure(grid.cells(), 0.0);
  for (std::size_t k = 0; k < pressure.size(); ++k)
    pressure[k] = std::clamp(modulus * (load.value - gap[k]) / (2 * width), 0.0, hardness);
  return pressure;
}

}  // namespace

NormalContact::NormalContact(const Grid& grid, Boundary boundary, double modulus, Field gap,
                             std::vector<FilmOnBody> films)
    : modulus_(modulus), films_(std::move(films)) {
  levels_.push_back({Compliance(grid, boundary, modulus, films_), std::move(gap)});
  if (levels_[0].gap.size() != grid.cells())
    throw InputError("a half-space contact of " + std::to_string(grid.cells()) +
                     " cells needs a gap for each, not " + std::to_string(levels_[0].gap.size()));
  for (const double g : levels_[0].gap)
    if (!std::isfinite(g)) throw InputError("a half-space contact needs finite gaps");
  while (has_coarser(levels_.back().compliance.grid())) {
    const Grid here = levels_.back().compliance.grid();
    Field coarse = coarsened(levels_.back().gap, here);
    levels_.push_back({Compliance(coarser(here), boundary, modulus, films_), std::move(coarse)});
  }
}

NormalContactSolution NormalContact::at_force(double force, const NormalContactOptions& options) const {
  if (!(force > 0) || !std::isfinite(force)) throw InputError("a half-space contact needs a force above 0");
  if (!(options.hardness > 0)) throw InputError("a half-space contact needs a hardness above 0");
  const double area = grid().cell_area() * static_cast<double>(grid().cells());
  if (force > options.hardness * area)
    throw InputError("a hardness of " + format_quantity(options.hardness, Dimension::pressure) + " carries " +
                     format_quantity(options.hardness * area, Dimension::force) +
                     " on all of the grid, less than the " + format_quantity(force, Dimension::force) +
                     " that press; take a larger grid");
  return solve({true, force}, options);
}

NormalContactSolution NormalContact::at_approach(double approach, const NormalContactOptions& options) const {
  if (!std::isfinite(approach)) throw InputError("a half-space contact needs a finite approach");
  if (!(options.hardness > 0)) throw InputError("a half-space contact needs a hardness above 0");
  const auto& gap = levels_.front().gap;
  const double touch = *std::min_element(gap.begin(), gap.end());
  if (approach <= touch)
    throw InputError("nothing touches at an approach of " + format_quantity(approach, Dimension::length) +
                     "; the surfaces meet at " + format_quantity(touch, Dimension::length));
  return solve({false, approach}, options);
}

NormalContactSolution NormalContact::solve(const NormalLoad& load,
                                           const NormalContactOptions& options) const {
  NormalContactSolution solution;
  const Level& coarsest = levels_.back();
  solution.pressure = first_guess(coarsest.compliance.grid(), coarsest.gap, load, modulus_, options.hardness);
  for (std::size_t level = levels_.size(); level-- > 0;) {
    constexpr double enough_for_a_guess = 1e-4;
    NormalContactOptions here = options;
    if (level > 0) here.tolerance = std::max(options.tolerance, enough_for_a_guess);
    const Compliance& compliance = levels_[level].compliance;
    if (level + 1 < levels_.size())
      solution.pressure = refined(solution.pressure, compliance.grid(), compliance.boundary());
    solution.convolutions = 0;
    iterate(compliance, levels_[level].gap, load, here, solution);
  }
  return solution;
}

double NormalContact::stiffness(const NormalContactSolution& solution) const {
  // Conjugate gradients for K t = 1 on the closed cells; the sum of t is the stiffness, whose error is the
  // square of the residual's.
  const Compliance& compliance = levels_.front().compliance;
  const Field& pressure = solution.pressure;
  const std::size_t cells = pressure.size();
  Field traction(cells, 0.0), residual(cells, 0.0), direction(cells, 0.0), response;
  for (std::size_t k = 0; k < cells; ++k) residual[k] = direction[k] = pressure[k] > 0 ? 1.0 : 0.0;
  constexpr int most = 1000;
  constexpr double enough = 1e-3;
  const auto squares_of = [&] {
    return sums_over<1>(cells, [&](std::size_t k, auto& sum) { sum[0] += residual[k] * residual[k]; })[0];
  };
  double squares = squares_of();
  const double first = squares;
  for (int n = 0; n < most && squares > enough * enough * first; ++n) {
    compliance.apply(direction, response);
    const double along =
        sums_over<1>(cells, [&](std::size_t k, auto& sum) { sum[0] += direction[k] * response[k]; })[0];
    if (!(along > 0))
      return std::numeric_limits<double>::infinity();  // closed everywhere on a grid that repeats
    const double length = squares / along;
    for_entries(static_cast<int>(cells), [&](int k) {
      if (pressure[k] > 0) traction[k] += length * direction[k], residual[k] -= length * response[k];
    });
    const double before = std::exchange(squares, squares_of());
    const double keep = squares / before;
    for_entries(static_cast<int>(cells), [&](int k) { direction[k] = residual[k] + keep * direction[k]; });
  }
  return compliance.grid().cell_area() *
         sums_over<1>(cells, [&](std::size_t k, auto& sum) { sum[0] += traction[k]; })[0];
}

}  // namespace asperity::half_space
