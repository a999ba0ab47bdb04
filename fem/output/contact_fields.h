// Fields of a state for ParaView: the bodies (fields/step_NNNN.vtu) and the contact surface
// (interface/step_NNNN.vtp).
#pragma once

#include <filesystem>
#include <string>

#include "fem/contact/contact_solver.h"
#include "fem/output/frames.h"

namespace asperity::fem {

/// What a frame says of itself in the field data.
struct FrameNotes {
  int step;           ///< counted from 1
  std::string title;  ///< of the case
  double load;        ///< normal force [N]
};

/// Collective. One volume file per rank; fields.pvd and interface.pvd list all steps in the folder at their
/// times, and show_in_paraview.py opens both.
void write_contact_fields(const std::filesystem::path& folder, const FrameNotes& notes, const Frames& frames,
                          const ContactSystem& system, const ContactSolver& solver,
                          const ContactState& state);

}  // namespace asperity::fem
