// What a case will show, in seconds: its normal contact by half-spaces, and the mesh that it needs.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/case.h"
#include "half_space/case_contact.h"

namespace asperity {

/// The mesh that a solve would make.
struct MeshPreview {
  double spacing = 0, region = 0;  ///< of the interface's nodes; half width of the fine region [m]
  double unknowns = 0, memory = 0, seconds = 0;  ///< [-], [byte], [s], roughly (fem/solve_cost.h)
  int steps = 0;
};

/// The contact by half-spaces, and that mesh.
struct PreviewedCase {
  half_space::CasePreview contact;
  double hardness = 0;                ///< of `contact.capped` [Pa]; infinite: none
  std::optional<MeshPreview> mesh;    ///< none: refused
  std::string refusal;                ///< what `asperity solve` would say
  std::vector<std::string> left_out;  ///< sentences
};

/// hardness: largest pressure [Pa]; 0: three times the lower yield stress (Tabor 1951), where a body yields.
/// Of cases that move, adhere or rub the normal contact under the largest load is previewed, and `left_out`
/// says what is not. Throws InputError as half_space::contact_of_case does, and where a case cannot be meant.
PreviewedCase preview_case(const CaseInput& input, double hardness);

/// The same in lines for a person.
void say_preview(const CaseInput& input, const PreviewedCase& preview,
                 const std::function<void(const std::string&)>& say);

/// The same as JSON ("asperity-preview/1", docs/result.md).
std::string preview_json(const CaseInput& input, const PreviewedCase& preview);

}  // namespace asperity
