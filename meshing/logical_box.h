// Cells of a forest by their place in its trees, the same in every forest that has them.
#pragma once

#include <array>
#include <cstdint>

#include "meshing/body_map.h"

namespace asperity::meshing {

/// The logical box of a cell within its tree: lower corner and edge length.
struct LogicalBox {
  int tree;
  Point3 corner;
  /// Side of the box in its tree, a fraction [-].
  double size;
  Point3 vertex(int v) const {
    return {corner[0] + (v & 1) * size, corner[1] + ((v >> 1) & 1) * size, corner[2] + ((v >> 2) & 1) * size};
  }
  Point3 centre() const { return {corner[0] + 0.5 * size, corner[1] + 0.5 * size, corner[2] + 0.5 * size}; }
};

/// A number of its own for each cell that a forest can have.
using CellKey = std::uint64_t;
CellKey cell_key(const LogicalBox& box);

/// The cell that this one is a part of; size < 1.
LogicalBox parent_of(LogicalBox box);
/// One of its eight parts.
LogicalBox part_of(LogicalBox box, int octant);

/// Trilinear functions of the corners of a box at a logical point within it [-].
std::array<double, 8> corner_weights(const LogicalBox& box, const Point3& point);

}  // namespace asperity::meshing
