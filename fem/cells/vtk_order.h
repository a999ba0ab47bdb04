// Order of a hexahedron's corners in VTK, as places in deal.II's.
#pragma once

namespace asperity::fem {

constexpr int vtk_order[8] = {0, 1, 3, 2, 4, 5, 7, 6};

}  // namespace asperity::fem
