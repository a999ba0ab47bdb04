// The last accepted state on disk, one file per rank and a manifest, written last, that says length and
// SHA-256 of each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "fem/case/fine_path.h"
#include "fem/contact/steady_prediction.h"
#include "fem/output/measured_stiffness.h"
#include "results/history.h"

namespace asperity::fem {

struct Checkpoint {
  Provenance provenance;
  std::vector<HistoryRow> records;  ///< of the accepted steps
  double load = 0;                  ///< of the last: force [N] or approach [m]
  double wall_time = 0;             ///< [s]
  MeasuredStiffness stiffness;
  FineParts parts;                        ///< of the path that are finely meshed
  std::vector<meshing::LogicalBox> kept;  ///< cells that have yielded before this mesh was made
  InterfaceState interface;
  PathMemory path;
  std::vector<double> displacement;  ///< locally owned
  std::vector<double> history;       ///< PlasticBodies::save_history

  int steps() const { return static_cast<int>(records.size()); }
};

/// Collective. The checkpoint before stays valid until this one is complete.
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint,
                      MPI_Comm communicator);

/// Why the checkpoint in `folder` cannot be gone on with (another program, other inputs, damaged), as the end
/// of a sentence that begins with its name; empty if it can, or if there is none. Reads all of its files.
std::string objection_to_resume(const std::filesystem::path& folder, const Provenance& now);

/// The latest complete checkpoint; empty if there is none. Throws WorkError if it is of another number of
/// ranks, or for what objection_to_resume says.
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& folder, const Provenance& now,
                                          MPI_Comm communicator);

}  // namespace asperity::fem
