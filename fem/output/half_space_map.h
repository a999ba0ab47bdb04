// Pressure of the contact that half-spaces solved beside a case, for ParaView and for the report.
#pragma once

#include <filesystem>

#include "half_space/case_contact.h"

namespace asperity::fem {

/// Writes half_space.vtp into the folder of a case: the part of the grid that holds the contact, about the
/// particle's axis, with `pressure` [Pa], attraction taken off as in interface/.
void write_half_space_map(const std::filesystem::path& folder, const half_space::CaseContact& contact);

}  // namespace asperity::fem
