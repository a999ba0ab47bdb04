#include "half_space/contact_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::half_space {
namespace {

/// Numbers of the cells that press and are joined by sides, by filling.
int count_spots(const Grid& grid, const Field& pressure) {
  std::vector<char> seen(pressure.size(), 0);
  std::vector<int> todo;
  int spots = 0;
  const auto visit = [&](int cell) {
    if (!seen[cell] && pressure[cell] > 0) seen[cell] = 1, todo.push_back(cell);
  };
  for (int start = 0; start < static_cast<int>(pressure.size()); ++start) {
    visit(start);
    if (todo.empty()) continue;
    ++spots;
    while (!todo.empty()) {
      const int cell = todo.back(), ix = cell % grid.nx;
      todo.pop_back();
      if (ix > 0) visit(cell - 1);
      if (ix + 1 < grid.nx) visit(cell + 1);
      if (cell >= grid.nx) visit(cell - grid.nx);
      if (cell + grid.nx < static_cast<int>(pressure.size())) visit(cell + grid.nx);
    }
  }
  return spots;
}

}  // namespace

ContactShape contact_shape(const Grid& grid, const Field& pressure, double hardness) {
  ContactShape shape;
  double closed = 0, at_bound = 0, sum = 0, moment_x = 0, moment_y = 0, sides_x = 0, sides_y = 0,
         elastic_sides = 0;
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const std::size_t cell = static_cast<std::size_t>(iy) * grid.nx + ix;
      const double p = pressure[cell];
      const bool presses = p > 0;
      const auto add_side = [&](double neighbour, double& sides) {
        if (presses == (neighbour > 0)) return;
        sides += 1, elastic_sides += std::max(p, neighbour) < hardness;
      };
      if (ix + 1 < grid.nx) add_side(pressure[cell + 1], sides_y);
      if (iy + 1 < grid.ny) add_side(pressure[cell + grid.nx], sides_x);
      if (!presses) continue;
      closed += 1, at_bound += p >= hardness, sum += p;
      moment_x += p * grid.x(ix), moment_y += p * grid.y(iy);
      shape.largest_pressure = std::max(shape.largest_pressure, p);
      shape.reach =
          std::max({shape.reach, std::abs(grid.x(ix)) + 0.5 * grid.dx, std::abs(grid.y(iy)) + 0.5 * grid.dy});
      if (ix == 0 || iy == 0 || ix + 1 == grid.nx || iy + 1 == grid.ny) shape.reaches_edge = true;
    }
  const double excess = (M_PI - 1 + std::log(2.0)) / 24, cell = grid.cell_area();
  shape.area_of_cells = closed * cell;
  shape.area_at_bound = at_bound * cell;
  shape.perimeter = sides_x * grid.dx + sides_y * grid.dy;
  shape.area = shape.area_of_cells - excess * elastic_sides * cell;
  shape.force = sum * cell;
  shape.mean_pressure = shape.area > 0 ? shape.force / shape.area : 0;
  if (sum > 0) shape.centre_x = moment_x / sum, shape.centre_y = moment_y / sum;
  shape.spots = count_spots(grid, pressure);
  return shape;
}

}  // namespace asperity::half_space
