// What a case will show, in seconds: its normal contact by half-spaces, and the mesh that it needs.
#pragma once

#include "core/case.h"
#include "half_space/previewed_case.h"

namespace asperity {

/// hardness: largest pressure [Pa]; 0: three times the lower yield stress (Tabor 1951), where a body yields.
/// Of cases that move, adhere or rub the normal contact under the largest load is previewed, and `left_out`
/// says what is not. Throws InputError as half_space::contact_of_case does, and where a case cannot be meant.
PreviewedCase preview_case(const CaseInput& input, double hardness,
                           const half_space::OnSeparation& on_separation = nullptr);

/// The mesh that `asperity solve` would make of the case, and what that costs, without meshing. Throws
/// InputError where solve would refuse.
MeshPreview preview_mesh(const CaseInput& input);

}  // namespace asperity
