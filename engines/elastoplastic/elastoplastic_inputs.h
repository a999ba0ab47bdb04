// Elasto-plastic normal laws as engines take them: what a user pastes for one contact. Each throws InputError
// for a record without the law's numbers (`asperity derive` finds them of contacts that yield).
#pragma once

#include <string>

#include "engines/input_notes.h"

namespace asperity {

/// Luding 2008.
std::string yade_luding(InputNotes& notes);
std::string liggghts_luding(InputNotes& notes);
std::string mercurydpm_luding(InputNotes& notes);
/// Zunker & Kamrin 2024, from E* and p_y of Thornton & Ning's law.
std::string lammps_mdr(InputNotes& notes);

}  // namespace asperity
