// One experiment in accepted steps: pressing the particle on the substrate, holding, sliding or spinning it,
// unloading, cycles.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "fem/case/case_setup.h"
#include "fem/case/fine_path.h"
#include "fem/contact/contact_solver.h"
#include "fem/experiments/delayed_far_field.h"
#include "fem/experiments/solve_options.h"
#include "fem/output/checkpoint.h"
#include "fem/output/frames.h"
#include "fem/output/measured_stiffness.h"
#include "fem/programs/program.h"
#include "results/history.h"

namespace asperity::fem {

class ContactExperiment {
 public:
  ContactExperiment(const CaseInput& input, const SolveOptions& options);
  /// All steps, with history, fields and checkpoints written on the way.
  void run();

 private:
  /// Whether it goes on from a checkpoint.
  bool start();
  void resume(const Checkpoint& checkpoint);
  /// System and solver with fine cells on `parts` and those that are kept.
  void mesh(const FineParts& parts, const std::shared_ptr<const meshing::KeptCells>& kept);
  void require_mesh_quality();
  /// Meshes anew where a motion leads off the fine cells, and takes the accepted state over.
  void travel_to(const RigidMotion& motion);
  void measure_far_field();
  void step_to(const Station& station, int index);
  double expected_approach(double target) const;
  /// Motion prescribed at a station, after the one before; a freely rolling particle is shifted further so
  /// that no lateral force builds up.
  RigidMotion towards(const Station& station, const Station* before) const;
  /// Target of a step, or of a part of one.
  struct Target {
    double load;  ///< force [N] or approach [m]
    RigidMotion motion;
    double time;           ///< see InterfacePoint
    bool divided = false;  ///< for what finite load steps leave
  };
  /// Outcome of a step to a target; from `report` alone where it has not converged.
  struct Attempt {
    SolveReport report;
    double force;  ///< [N]
    BodyEnergies energies;
    std::string failure;  ///< that broke it off
  };
  Attempt attempt(ContactState& trial, const Target& target, double force_before);
  void solve_with_retries(double target, const RigidMotion& motion, double duration);
  /// The last target in equal parts, from the accepted state.
  void divide(std::vector<Target>& pending, int parts, bool divided) const;
  [[noreturn]] void refuse_after(const Attempt& made, bool moves) const;
  /// Into how many parts a step that was tried has to be divided.
  int parts_needed(const ContactState& trial, double force_before, double force, double flow_turn) const;
  void accept(ContactState& trial, double load);
  /// The row of the step that was accepted; `sums`: work that was dissipated up to its end.
  HistoryRow record(const BodyEnergies& energies, const HistoryRow& sums) const;
  void write_step();
  void write_result();
  /// Recommends a number of load steps where their error exceeds that of the mesh.
  void say_load_steps() const;
  /// Once, where the contact has come to the edge of the finely meshed region.
  void say_rim() const;
  void measure_stiffness();
  bool speaks() const { return rank_ == 0; }
  Provenance provenance() const;
  double wall_time() const;  ///< of this run and those it goes on from [s]
  void say(const std::string& line) const;

  const CaseInput input_;
  SolveOptions options_;
  CaseSetup setup_;
  std::vector<Station> program_;
  FinePath path_;
  Frames frames_;
  int rank_, ranks_;
  std::unique_ptr<ContactSystem> system_;
  std::unique_ptr<ContactSolver> solver_;
  FineParts parts_;                          ///< of the path that are finely meshed now
  long most_unknowns_ = 0, most_cells_ = 0;  ///< of the largest mesh so far
  ContactState state_;
  std::vector<HistoryRow> records_;
  MeasuredStiffness stiffness_;
  DelayedFarField delayed_far_field_{};
  double load_ = 0;                       ///< of the accepted state: force [N] or approach [m]
  double started_ = 0, time_before_ = 0;  ///< wall time of this run's start and of earlier runs [s]
  SolveReport last_report_;
};

}  // namespace asperity::fem
