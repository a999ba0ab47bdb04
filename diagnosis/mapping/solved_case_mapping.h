// A diagnosis whose simulation is a case of finite elements: the case as it is corrects the reduced laws for
// the search, and the sets that survive it are solved anew and fitted again until the solution and what was
// expected of it agree (space mapping, branch_curves.h).
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "diagnosis/choose/search.h"
#include "diagnosis/mapping/branch_curves.h"
#include "diagnosis/mapping/open_set.h"
#include "diagnosis/mapping/solved_attraction.h"
#include "diagnosis/mapping/solved_resistance.h"
#include "diagnosis/outcome/diagnosis.h"
#include "diagnosis/recording/recording.h"

namespace asperity {

class SolvedCaseMapping {
 public:
  SolvedCaseMapping(ForwardModel& model, std::function<void(const std::string&)> progress)
      : model_(model), progress_(std::move(progress)) {}

  /// The recording with the bodies of the case and its friction; what was recorded of them and differs goes
  /// to remarks(). Throws InputError where it is of a rail, or of several surfaces that no case has.
  Recording with_bodies_of_case(const Recording& recording);
  /// Solves the case as it is.
  void correct(FitProblem& problem);
  /// Solves the case with the effects of the sets worth it, of at most a few solutions each, and leaves in
  /// the search only what finite elements say: these, and sets of instruments.
  void confirm(SearchResult& search, const FitProblem& problem,
               const std::vector<const Candidate*>& survivors);

  /// One solution tells how a law that attracts depends on the size of its attraction, which it scales with,
  /// and not on its shape: intervals of the latter are all that is admissible.
  void widen_untested(const FitProblem& problem, std::vector<DiagnosedEffect>& effects) const;
  /// Fills in the entries of the case that stand for the effects.
  void add_case_entries(const FitProblem& problem, std::vector<DiagnosedEffect>& effects) const;
  /// What the answer rests on; `chosen`: null where nothing is named. Values that the case could not be
  /// solved with go to remarks().
  SolvedSimulation described(const ModelFit* chosen);
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// Sets that were worth solving, could not be solved to the end and are not excluded: what is named cannot
  /// be the only explanation.
  const std::vector<OpenSet>& left_open() const { return open_; }
  /// Effects that have no form in this case.
  std::vector<UntriedEffect> effects_without_form(const Experiment& experiment) const;

 private:
  /// How far a set could be solved.
  struct Confirmation {
    enum State { complete, partial, failed } state = failed;
    Samples part;          ///< the samples that the solutions reached count
    std::string in_words;  ///< of a partial one: how far and why
    bool is_out_of_time = false, may_begin_again = false;
  };

  /// A case with what is to be tried.
  struct Trial {
    std::vector<CaseChange> changes;
    std::vector<const Effect*> effects;
    double approach = 0, opening = 0;  ///< of a contact that attracts: at the largest force, and pulled [m]
    bool returns_on_another_curve = false;  ///< as bodies that yield and surfaces of two works of adhesion do
    bool yields = false;                    ///< the bodies do
  };

  static Trial trial_of(const FitProblem& problem, const ModelFit& fit, double largest_force);
  std::vector<LoadingProtocol> asked_for(const FitProblem& problem, const Trial& trial) const;
  std::shared_ptr<const BranchCorrection> correction_by(const std::vector<SolvedResponse>& solved,
                                                        const Trial& trial, const Mechanics& reduced) const {
    return trial.opening > 0 ? attraction_of(solved.front(), reduced, error_, trial.returns_on_another_curve)
                             : difference_to(solved, protocols_, reduced, error_, surface_errors_);
  }
  /// What the solutions of a set say: the law corrected by them, and how far they came.
  struct SolvedSet {
    std::shared_ptr<const BranchCorrection> correction;
    Confirmation answer;
    std::string source;
  };
  SolvedSet solved_set(const FitProblem& problem, const ModelFit& fit, const std::vector<double>& expected,
                       bool may_begin_again);
  /// Throws InputError for a recording in whose times the case cannot relax.
  void prepare_relaxing(const Recording& recording);
  /// The recording's law is the case's own. Throws InputError for one of several surfaces.
  void prepare_lateral(Recording& recording, const SimulatedBodies& bodies);
  void correct_lateral(FitProblem& problem);
  /// Slides, rolls or spins on each of the recorded surfaces with the changes that the fit has on it; null:
  /// with none.
  std::vector<SolvedMotion> move(const Experiment& experiment, const ModelFit* fit);
  void take_mesh_out(std::vector<SolvedMotion>& moved) const;
  static std::vector<CaseChange> changes_of(const Experiment& experiment, const ModelFit& fit);
  /// One solution for each of the recording's protocols.
  std::vector<SolvedResponse> solve(const FitProblem& problem, const Trial& trial, const EnoughOfIt& enough);
  /// The case as it is; of surfaces that attract pressed until the largest recorded force is reached, which
  /// sets the trial's approach. Throws WorkError where it is not.
  std::vector<SolvedResponse> solved_up_to_largest_force(const FitProblem& problem, Trial& trial);
  /// What a solution in progress is watched for.
  struct Watch {
    const FitProblem& problem;
    const Trial& trial;
    const ModelFit& fit;
    const std::vector<double>& expected;  ///< response of each sample, as the channel's unit
    bool may_begin_again;                 ///< another solution with better values can follow
  };
  /// What the approach may be off by because the recorded surface is another realisation.
  void solve_on_other_surfaces();
  std::string enough_of(const SolvedResponse& so_far, const Watch& watch) const;
  std::vector<Candidate> worth_solutions(const SearchResult& search, const FitProblem& problem,
                                         const std::vector<const Candidate*>& survivors);
  Confirmation reached(const FitProblem& problem, const std::vector<SolvedResponse>& solved) const;
  /// A set that was solved to the end: as fitted, with the values of its last solution, and where that is.
  struct ConfirmedSet {
    ModelFit fit, solved_at;
    std::string source;
  };
  /// Fits a set from the solution of another with the same entries of the case. True: its own values move
  /// what the case does by less than noise and mesh, so that it needs no solution of its own.
  bool is_served_by(const ConfirmedSet& other, ModelFit& fit, const FitProblem& problem) const;
  Confirmation confirm_set(Candidate& candidate, const FitProblem& problem);
  void judge_on_part(const SearchResult& search, const FitProblem& problem, const Candidate& candidate,
                     const Confirmation& answer);
  /// Where the case was solved with other values than a fit has.
  void remark_on_values_as_solved(const ModelFit& fit);
  void say(const std::string& line) const {
    if (progress_) progress_(line);
  }

  struct Solution {
    std::string effects, source;  ///< names of a set, and where its last solution is
  };
  ForwardModel& model_;
  std::function<void(const std::string&)> progress_;
  RecordedProtocols protocols_;          ///< of normal contact
  std::vector<MotionProtocol> motions_;  ///< of sliding, rolling and torsion
  std::vector<double> of_mesh_;          ///< of each in the case as it is [N]
  SurfaceErrors surface_errors_;         ///< of normal contact
  std::string before_;
  std::vector<Solution> after_;
  std::vector<ConfirmedSet> confirmed_;
  double error_ = 0;  ///< of the case as it is: of its approach [m], or of resistance as a part of it [-]
  bool is_lateral_ = false;   ///< slid, rolled or spun
  std::string resistance_{};  ///< what such a motion tells: "friction", "rolling resistance", ...
  int solves_ = 0;
  ModelFit best_measurement_;  ///< the best set that needs no solution: what others have to be better than
  double overdispersion_ = 1;  ///< chi^2 of the best fit per sample [-]
  std::vector<OpenSet> open_;
  std::vector<std::string> remarks_;
};

}  // namespace asperity
