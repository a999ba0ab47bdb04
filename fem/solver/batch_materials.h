// Materials of the cells of a batch, lane by lane.
#pragma once

#include "fem/levels/cell_materials.h"
#include "fem/levels/mesh_level.h"

namespace asperity::fem {

struct BatchMaterials {
  const J2Material* lane[lanes];
  Simd<double> shear, bulk;  ///< [Pa]
  bool is_inelastic = false, relaxes = false;

  BatchMaterials(const CellBatch& batch, const CellMaterials& materials) {
    for (int l = 0; l < lanes; ++l) {
      lane[l] = &materials[batch.material[l]];
      shear[l] = lane[l]->shear_modulus;
      bulk[l] = lane[l]->bulk_modulus;
      is_inelastic = is_inelastic || lane[l]->is_inelastic();
      relaxes = relaxes || lane[l]->relaxation.is_there();
    }
  }
};

}  // namespace asperity::fem
