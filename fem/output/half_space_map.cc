#include "fem/output/half_space_map.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "fem/output/vtk_writer.h"
#include "results/solved_case.h"

namespace asperity::fem {
namespace {

/// Cells of one side from the middle on that the contact needs, an edge without pressure included.
int half_side(const half_space::CaseContact& contact) {
  constexpr int edge = 8;
  const half_space::Grid& grid = contact.grid;
  int reach = 0;
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix)
      if (contact.solution.pressure[static_cast<std::size_t>(iy) * grid.nx + ix] > 0)
        reach = std::max({reach, std::abs(ix - grid.nx / 2), std::abs(iy - grid.ny / 2)});
  return std::min(reach + edge, std::min(grid.nx, grid.ny) / 2);
}

}  // namespace

void write_half_space_map(const std::filesystem::path& folder, const half_space::CaseContact& contact) {
  const half_space::Grid& grid = contact.grid;
  const int half = half_side(contact), side = 2 * half, left = grid.nx / 2 - half, low = grid.ny / 2 - half;
  VtkMesh mesh;
  mesh.points_per_cell = 4;
  VtkArray pressure{"pressure", 1, {}, "Pa"};
  for (int iy = low; iy < low + side; ++iy)
    for (int ix = left; ix < left + side; ++ix) {
      mesh.points.insert(mesh.points.end(), {grid.x(ix), grid.y(iy), 0});
      const double carried = contact.solution.pressure[static_cast<std::size_t>(iy) * grid.nx + ix];
      pressure.values.push_back(carried > 0 ? static_cast<float>(carried - contact.attraction_in_touch)
                                            : 0.0F);
    }
  for (int iy = 0; iy + 1 < side; ++iy)
    for (int ix = 0; ix + 1 < side; ++ix) {
      const int corner = iy * side + ix;
      mesh.connectivity.insert(mesh.connectivity.end(),
                               {corner, corner + 1, corner + side + 1, corner + side});
    }
  mesh.point_data.push_back(std::move(pressure));
  write_vtk(folder / half_space_map, mesh);
}

}  // namespace asperity::fem
