#include "meshing/logical_box.h"

#include <cmath>

namespace asperity::meshing {

CellKey cell_key(const LogicalBox& box) {
  constexpr int bits_of_axis = 18, bits_of_level = 5;
  auto key = static_cast<CellKey>(box.tree) << bits_of_level | static_cast<CellKey>(-std::ilogb(box.size));
  for (const double corner : box.corner)
    key = key << bits_of_axis | static_cast<CellKey>(std::lround(corner / box.size));
  return key;
}

LogicalBox parent_of(LogicalBox box) {
  box.size *= 2;
  for (double& corner : box.corner) corner = std::floor(corner / box.size) * box.size;
  return box;
}

LogicalBox part_of(LogicalBox box, int octant) {
  box.size *= 0.5;
  for (int d = 0; d < 3; ++d) box.corner[d] += ((octant >> d) & 1) * box.size;
  return box;
}

std::array<double, 8> corner_weights(const LogicalBox& box, const Point3& point) {
  std::array<double, 8> weights;
  for (int v = 0; v < 8; ++v) {
    weights[v] = 1;
    for (int d = 0; d < 3; ++d) {
      const double place = (point[d] - box.corner[d]) / box.size;
      weights[v] *= (v >> d) & 1 ? place : 1 - place;
    }
  }
  return weights;
}

}  // namespace asperity::meshing
