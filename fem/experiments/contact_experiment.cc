#include "fem/experiments/contact_experiment.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/build_commit.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "core/quantity.h"
#include "core/wait_text.h"
#include "fem/experiments/energy_balance.h"
#include "fem/output/added_column.h"
#include "fem/output/contact_fields.h"
#include "fem/output/progress_line.h"
#include "fem/programs/free_rolling.h"
#include "fem/solver/load_step_error.h"

namespace asperity::fem {
namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ContactExperiment::ContactExperiment(const CaseInput& input, const SolveOptions& options)
    : input_(with_derived_path_length(input)),
      options_(options),
      setup_(set_up(input_)),
      program_(make_program(input_.experiment, setup_.motion)),
      path_(input_, setup_, program_),
      frames_(frames_of(input_.experiment, program_, setup_.motion,
                        setup_.system.control == Control::force ? setup_.largest_load : setup_.hertz_approach,
                        input_.output.fields_every)) {
  rank_ = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  ranks_ = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
}

double ContactExperiment::wall_time() const { return time_before_ + seconds() - started_; }

void ContactExperiment::say(const std::string& line) const {
  if (speaks() && options_.progress) options_.progress(line);
}

Provenance ContactExperiment::provenance() const { return {options_.inputs_sha256, build_commit()}; }

void ContactExperiment::run() {
  started_ = seconds();
  const bool resumed = start();
  if (speaks()) {
    if (options_.before_writing) options_.before_writing();
    make_folder(options_.output);
    // What an earlier run left is of another history: a study would take a run that is stopped now for a
    // finished one.
    if (!resumed) std::filesystem::remove(options_.output / "result.json");
  }
  MPI_Barrier(MPI_COMM_WORLD);
  if (!resumed || !path_.travels()) measure_far_field();
  const std::size_t steps = program_.size(), first = records_.size();
  for (std::size_t k = first; k < steps; ++k) {
    const double began = seconds();
    step_to(program_[k], static_cast<int>(k) + 1);
    const double left =
        (seconds() - started_) / static_cast<double>(k + 1 - first) * static_cast<double>(steps - k - 1);
    say("step " + std::to_string(k + 1) + "/" + std::to_string(steps) + progress_of(records_.back()) + "  " +
        wait_text(seconds() - began) + "  left ~" + wait_text(left));
  }
  write_result();
}

RigidMotion ContactExperiment::towards(const Station& station, const Station* previous) const {
  RigidMotion motion = station.motion;
  if (!previous) return motion;
  // The shift by which free rolling has relieved lateral force stays.
  if (input_.experiment.type == Motion::program) {
    motion.x = state_.motion.x + station.motion.x - previous->motion.x;
    motion.y = state_.motion.y + station.motion.y - previous->motion.y;
  }
  if (!station.rolls_freely) return motion;
  const double stiffness = solver_->has_friction() ? stiffness_.lateral : 0.0;
  const RollingStep step =
      free_rolling(program_, records_, {setup_.motion.rolling_radius, setup_.hertz_radius, stiffness});
  const double path_length = step.path_per_angle * (motion.roll - state_.motion.roll) - step.back;
  const double heading = 0.5 * (motion.spin + state_.motion.spin);
  motion.x = state_.motion.x + path_length * std::cos(heading);
  motion.y = state_.motion.y + path_length * std::sin(heading);
  return motion;
}

double ContactExperiment::expected_approach(double target) const {
  // Under a growing load most of what Hertz would add; unloading needs no guess. No more for roughness,
  // though the first touch of rough surfaces is far off: where asperities overlap rigidly they yield in the
  // first guess, and a deep one takes three times the iterations.
  if (setup_.system.control != Control::force || target <= load_) return 0;
  const auto hertz = [&](double force) {
    return setup_.hertz_approach * std::pow(force / setup_.largest_contact_force(), 2.0 / 3);
  };
  constexpr double cautious_share = 0.8;
  return cautious_share * (hertz(target) - hertz(load_));
}

int ContactExperiment::parts_needed(const ContactState& trial, double force_before, double force,
                                    double flow_turn) const {
  const double approach_change =
      trial.approach - state_.approach - stiffness_.far_field * (force - force_before);
  return parts_of_step(flow_turn, approach_change, force - force_before, force,
                       input_.experiment.load_step_error);
}

void ContactExperiment::accept(ContactState& trial, double load) {
  load_ = load;
  state_.take(trial);
  system_->bodies().accept_step();
}

ContactExperiment::Attempt ContactExperiment::attempt(ContactState& trial, const Target& target,
                                                      double force_before) {
  Attempt made;
  made.force = force_before;
  try {
    solver_->push_rigidly(trial, expected_approach(target.load));
    made.report = solver_->solve(trial, target.load, target.motion, target.time - state_.time);
    if (!made.report.converged) return made;
    // Without normal force the approach is undefined and so is its load step error.
    if (target.load != load_) made.force = solver_->resultants(trial).force;
    made.energies = system_->bodies().try_step(state_.displacement, trial.displacement,
                                               telling_change(made.force - force_before, made.force));
  } catch (const StepFailure& failure) {
    made.report.converged = false;
    made.failure = failure.what();
  }
  return made;
}

void ContactExperiment::divide(std::vector<Target>& pending, int parts, bool divided) const {
  const Target whole = pending.back();
  pending.back().divided = divided;
  for (int part = parts - 1; part > 0; --part) {
    const double fraction = static_cast<double>(part) / parts;
    pending.push_back({load_ + fraction * (whole.load - load_),
                       between(state_.motion, whole.motion, fraction),
                       state_.time + fraction * (whole.time - state_.time), divided});
  }
}

void ContactExperiment::refuse_after(const Attempt& made, bool moves) const {
  const std::string why = made.failure.empty()
                              ? "unbalanced force " + std::to_string(made.report.residual) + " of the load"
                              : made.failure;
  throw WorkError("no equilibrium found at step " + std::to_string(records_.size() + 1) + " (" + why +
                  ") after halving the step six times; use more Experiment/" +
                  (moves ? "Motion steps" : "Load steps"));
}

void ContactExperiment::solve_with_retries(double target, const RigidMotion& motion, double duration) {
  // Steps that fail are halved from the last accepted state, those that leave too much of the flow's turn
  // divided; what is reached in between is accepted and kept in the history.
  std::vector<Target> pending{{target, motion, state_.time + duration}};
  int failures = 0;
  BodyEnergies energies;
  const HistoryRow before = records_.empty() ? HistoryRow() : records_.back();
  double force_before = before.normal_force + setup_.attraction_force;
  HistoryRow sums;
  sums.plastic_work = before.plastic_work;
  sums.friction_work = before.friction_work;
  sums.adhesion_loss = before.adhesion_loss;
  while (!pending.empty()) {
    ContactState trial = state_;
    const Attempt made = attempt(trial, pending.back(), force_before);
    const SolveReport& report = made.report;
    last_report_.newton += report.newton;
    last_report_.linear += report.linear;
    last_report_.penetration = report.penetration;
    last_report_.residual = report.residual;
    if (report.restarts > 0) say("the quick iteration found no equilibrium; solved cautiously instead");
    if (!report.converged) {
      if (++failures > 6) refuse_after(made, !(motion == state_.motion));
      divide(pending, 2, pending.back().divided);
      continue;
    }
    energies = made.energies;
    const bool presses = pending.back().load != load_;
    const int parts = pending.back().divided || !presses
                          ? 1
                          : parts_needed(trial, force_before, made.force, energies.flow_turn);
    if (parts > 1) {
      divide(pending, parts, true);
      continue;
    }
    accept(trial, pending.back().load);
    force_before = made.force;
    pending.pop_back();
    sums.friction_work += report.friction_work;
    sums.adhesion_loss += report.adhesion_loss;
    sums.adhesion_energy = report.adhesion_energy - setup_.attraction_force * state_.approach;
    sums.plastic_work += energies.plastic_work;
  }
  records_.push_back(record(energies, sums));
  balance_energy(records_, solver_->has_adhesion() || setup_.attraction_force > 0,
                 setup_.motion.rolling_radius);
  HistoryRow& row = records_.back();
  row.added = added_values({*system_, *solver_, state_, row, records_.size() > 1 ? &row - 1 : nullptr});
}

void ContactExperiment::measure_stiffness() {
  const auto without_far_field = [](double stiffness, double compliance) {
    return 1 / (1 / stiffness - compliance);
  };
  stiffness_.normal = without_far_field(solver_->elastic_stiffness(state_), stiffness_.far_field);
  const Motion type = input_.experiment.type;
  const bool moves_as_written = type == Motion::program && solver_->has_friction();
  // A contact that is only pressed tells all three, as if its active contact nodes stuck.
  const bool in_all_directions = type == Motion::normal || moves_as_written;
  if (type == Motion::sliding || type == Motion::rolling || in_all_directions)
    stiffness_.lateral = without_far_field(solver_->lateral_stiffness(state_), stiffness_.lateral_far_field);
  if (type == Motion::torsion || in_all_directions) stiffness_.torsion = solver_->torsion_stiffness(state_);
  for (const double stiffness : {stiffness_.normal, stiffness_.lateral, stiffness_.torsion})
    if (std::isnan(stiffness))
      say("a stiffness was not measured: the linear solver did not converge; it is left out of result.json");
}

void ContactExperiment::step_to(const Station& station, int index) {
  last_report_ = {};
  const double fraction = station.load;
  const RigidMotion motion = towards(station, index > 1 ? &program_[index - 2] : nullptr);
  travel_to(motion);
  solve_with_retries(setup_.system.control == Control::force
                         ? fraction * setup_.largest_load + setup_.attraction_force
                         : fraction * setup_.hertz_approach,
                     motion, station.duration);
  if (fraction == 1.0 && stiffness_.normal == 0) measure_stiffness();
  if (input_.output.fields && frames_.shown[index - 1])
    write_contact_fields(options_.output,
                         {index, input_.title, solver_->resultants(state_).force - setup_.attraction_force},
                         frames_, *system_, *solver_, state_);
  write_step();
}

}  // namespace asperity::fem
