// Stiffness and compliance that an experiment measures once, for its result and its checkpoints.
#pragma once

namespace asperity::fem {

struct MeasuredStiffness {
  double far_field = 0;          ///< compliance of the finite bodies, taken out of the approach [m/N]
  double lateral_far_field = 0;  ///< the same of the shift [m/N]
  // Elastic, without slip, of half-spaces at the largest load; 0: not known.
  double normal = 0;   ///< [N/m]
  double lateral = 0;  ///< [N/m]
  double torsion = 0;  ///< [N m/rad]
};

}  // namespace asperity::fem
