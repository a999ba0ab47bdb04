// The last accepted state on disk, one file per rank and a manifest that is written last.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "fem/contact/contact_solver.h"
#include "fem/output/step_record.h"

namespace asperity::fem {

struct Checkpoint {
  int steps = 0;                       ///< accepted so far
  double load = 0, far_field = 0, lateral_far_field = 0, wall_time = 0;
  double stiffness_at_peak = 0, lateral_stiffness = 0, torsion_stiffness = 0;
  std::vector<StepRecord> records;
  std::vector<double> displacement;    ///< locally owned
  std::vector<double> multiplier;
  std::array<std::vector<double>, 2> shear;
  std::vector<double> bonded;  ///< see ContactState
  RigidMotion motion;
  Coupling coupling;  ///< see ContactState
  double approach = 0;
  std::vector<double> history;         ///< PlasticBodies::save_history
};

/// Collective. The checkpoint before stays valid until this one is complete.
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint, MPI_Comm communicator);

/// Whether a checkpoint in `folder` was written by a program of this version; true where there is none.
bool is_of_this_version(const std::filesystem::path& folder);

/// The latest complete checkpoint; empty if there is none. Throws WorkError if it was made by another number of ranks or version.
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& folder, MPI_Comm communicator);

}  // namespace asperity::fem
