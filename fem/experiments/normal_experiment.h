// Pressing the particle on the substrate: loading, holding, unloading and reloading in accepted steps.
#pragma once

#include <memory>
#include <vector>

#include "fem/case_setup.h"
#include "fem/contact/contact_solver.h"
#include "fem/output/step_record.h"
#include "fem/solve_case.h"

namespace asperity::fem {

/// Targets of the steps, as fractions of the largest load (force control) or approach (displacement control).
/// Loading and unloading advance evenly in the approach of a Hertzian contact. The last unloading step keeps a
/// thousandth of the load: without any contact nothing holds the particle.
std::vector<double> load_program(const ExperimentInput& experiment);

class NormalExperiment {
 public:
  NormalExperiment(const CaseInput& input, const SolveOptions& options);
  void run();

 private:
  void start();
  bool resume();
  void step_to(double fraction, int index);
  double expected_approach(double target) const;
  void solve_with_retries(double target);
  void balance_energy();
  StepRecord record(int step, const SolveReport& report);
  void write_step(int step);
  void write_result();
  bool speaks() const { return rank_ == 0; }
  void say(const std::string& line) const;

  const CaseInput& input_;
  SolveOptions options_;
  CaseSetup setup_;
  std::vector<double> program_;
  int rank_, ranks_;
  std::unique_ptr<ContactSystem> system_;
  std::unique_ptr<ContactSolver> solver_;
  ContactState state_;
  std::vector<StepRecord> records_;
  double far_field_ = 0;            ///< [m/N]
  double load_ = 0;                 ///< of the accepted state: force [N] or approach [m]
  double started_ = 0, time_before_ = 0;  ///< wall time of this run's start and of earlier runs [s]
  double stiffness_at_peak_ = 0;
  SolveReport last_report_;
};

}  // namespace asperity::fem
