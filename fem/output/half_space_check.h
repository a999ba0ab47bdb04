// The elastic normal contact of a solved case once more, by half-spaces: a judge that knows nothing of
// meshes.
#pragma once

#include <optional>
#include <string>

#include "fem/case/case_setup.h"
#include "half_space/case_contact.h"
#include "results/history.h"

namespace asperity::fem {

/// The same surfaces under the force of the step `peak`, on the square of the mesh's fine region in cells of
/// half its spacing, or a third of the zone of attraction where that is less, 512 along a side at most, or
/// 256 of surfaces that attract each other. None where half-spaces do not solve the same problem: bodies that
/// have yielded, attraction told as a force, motion; where so many cells do not resolve the attraction; or
/// where nothing presses. tension: largest of the history [N]; where there is any, the pull-off is solved
/// too.
std::optional<half_space::CaseContact> half_space_check(const CaseInput& input, const CaseSetup& setup,
                                                        const HistoryRow& peak, double tension);

/// Both answers in one line. stiffness, tension: of finite elements [N/m], [N].
std::string half_space_text(const half_space::CaseContact& check, const HistoryRow& peak, double stiffness,
                            double tension);

}  // namespace asperity::fem
