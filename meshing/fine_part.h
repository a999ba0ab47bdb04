// Which part of a body's fine region is meshed finely, where the mesh travels with the contact.
#pragma once

#include <limits>
#include <unordered_set>
#include <vector>

#include "meshing/logical_box.h"

namespace asperity::meshing {

/// Places along x that the contact's centre takes, from the middle of its body's lattice [m].
struct FinePart {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();

  /// x and tolerance [m].
  bool holds(double x, double tolerance) const { return x >= low - tolerance && x <= high + tolerance; }
};

/// Cells that stay as they are wherever the fine part is.
class KeptCells {
 public:
  explicit KeptCells(const std::vector<LogicalBox>& cells);

  /// Whether the cell has to be refined for one of them.
  bool has_within(const LogicalBox& box) const { return wholes_.count(cell_key(box)) > 0; }
  const std::vector<LogicalBox>& cells() const { return cells_; }

 private:
  std::vector<LogicalBox> cells_;
  std::unordered_set<CellKey> wholes_;  ///< what they are parts of
};

}  // namespace asperity::meshing
