// Fields of a state for ParaView: the bodies (fields/step_NNNN.vtu) and the contact surface
// (interface/step_NNNN.vtp).
#pragma once

#include <filesystem>

#include "fem/contact/contact_solver.h"

namespace asperity::fem {

/// Collective. One volume file per rank; fields.pvd and interface.pvd list all steps in the folder.
void write_contact_fields(const std::filesystem::path& folder, int step, const ContactSystem& system,
                          const ContactSolver& solver, const ContactState& state);

}  // namespace asperity::fem
