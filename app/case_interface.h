// Entries of a case file about friction and adhesion.
#pragma once

#include <vector>

#include "app/case_declaration.h"

namespace asperity {

/// Those of subsection Interface: the registered laws' own, and what all laws of adhesion have.
void add_interface(std::vector<CaseEntry>& entries);

}  // namespace asperity
