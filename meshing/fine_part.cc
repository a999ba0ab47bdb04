#include "meshing/fine_part.h"

namespace asperity::meshing {

KeptCells::KeptCells(const std::vector<LogicalBox>& cells) : cells_(cells) {
  for (LogicalBox box : cells)
    while (box.size < 1) {
      box = parent_of(box);
      if (!wholes_.insert(cell_key(box)).second) break;
    }
}

}  // namespace asperity::meshing
