// The part of a mesh level that its smoother works on: the nodes of the cells that the next coarser level
// does not have. Elsewhere the functions of both levels are the same, and the coarser one corrects them
// (Bramble, Pasciak, Wang & Xu 1991; local multigrid).
#pragma once

#include <vector>

#include "fem/solver/level_transfer.h"

namespace asperity::fem {

struct SmoothedPart {
  std::vector<char> node;   ///< of each local node, whether it is smoothed
  std::vector<char> batch;  ///< of each cell batch, whether smoothing moves one of its nodes
};

/// Of a level that is finer than that which `transfer` comes from.
SmoothedPart smoothed_part(const MeshLevel& fine, const LevelTransfer& transfer);

}  // namespace asperity::fem
