// The siblings of a mesh level that are nearly parallelepipeds, for the operator of the multigrid.
//
// Families of eight are the same on any number of ranks, and so is the operator.
#pragma once

#include <vector>

#include "fem/cells/parallelepiped.h"
#include "fem/cells/sibling_patch.h"
#include "fem/levels/mesh_level.h"

namespace asperity::fem {

class ParallelepipedBatches {
 public:
  /// positions: local nodes [m]; shear and bulk modulus by number of the material [Pa].
  ParallelepipedBatches(const MeshLevel& level, const std::vector<float>& positions,
                        const std::vector<float>& shear, const std::vector<float>& bulk);

  /// Whether a batch is one of them.
  bool holds(int batch) const { return place_[batch] >= 0; }

  /// Adds the nodal forces [N] of two batches that are held, or of the first one alone (second: -1), for
  /// displacements x [m].
  void apply(int first, int second, const float* x, float* y) const;

 private:
  struct Siblings {
    std::array<std::array<Simd<float>, 3>, 3> gradient;
    Simd<float> bulk_ratio;
    PatchNodes node;
    bool is_last;  ///< no number follows one of its nodes
  };
  static void load(const Siblings& siblings, const float* x, PatchGrid (&grid)[3]);

  std::vector<int> place_;  ///< in siblings_, by batch; -1: not held
  std::vector<Siblings> siblings_;
};

}  // namespace asperity::fem
