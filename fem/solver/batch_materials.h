// Materials of the cells of a batch, lane by lane.
#pragma once

#include "fem/levels/cell_materials.h"
#include "fem/levels/mesh_level.h"

namespace asperity::fem {

struct BatchMaterials {
  const J2Material* lane[lanes];
  Simd<double> shear, bulk;  ///< [Pa]
  bool can_yield = false;

  BatchMaterials(const CellBatch& batch, const CellMaterials& materials) {
    for (int l = 0; l < lanes; ++l) {
      lane[l] = &materials[batch.material[l]];
      shear[l] = lane[l]->shear_modulus;
      bulk[l] = lane[l]->bulk_modulus;
      can_yield = can_yield || lane[l]->can_yield();
    }
  }
};

}  // namespace asperity::fem
