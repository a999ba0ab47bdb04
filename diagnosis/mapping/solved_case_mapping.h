// A diagnosis whose simulation is a case of finite elements: the case as it is corrects the reduced laws for
// the search, and the sets that survive it are solved anew and fitted again until the solution and what was
// expected of it agree (space mapping, branch_curves.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/choose/search.h"
#include "diagnosis/mapping/branch_curves.h"
#include "diagnosis/outcome/diagnosis.h"
#include "diagnosis/recording/recording.h"

namespace asperity {

class SolvedCaseMapping {
 public:
  SolvedCaseMapping(ForwardModel& model, std::function<void(const std::string&)> progress)
      : model_(model), progress_(std::move(progress)) {}

  /// The recording with the bodies of the case; what was recorded of them and differs goes to remarks().
  /// Throws InputError where it is not normal.
  Recording with_bodies_of_case(const Recording& recording);
  /// Solves the case as it is.
  void correct(FitProblem& problem);
  /// Solves the case with the effects of the sets worth it, of at most a few solutions each, and leaves in
  /// the search only what finite elements say: these, and sets of instruments.
  void confirm(SearchResult& search, const FitProblem& problem,
               const std::vector<const Candidate*>& survivors);

  /// What the answer rests on.
  SolvedSimulation described(const FitProblem& problem, const ModelFit* chosen,
                             const std::vector<DiagnosedEffect>& effects) const;
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// A set that was worth solving could not be: what is left cannot be the only explanation.
  bool is_incomplete() const { return is_incomplete_; }
  /// Effects that have no form in this case.
  std::vector<std::string> remarks_on_effects_without_form(const Experiment& experiment) const;

 private:
  std::vector<SolvedResponse> solve(const FitProblem& problem, const std::vector<CaseChange>& changes);
  bool confirm_set(Candidate& candidate, const FitProblem& problem);
  void say(const std::string& line) const {
    if (progress_) progress_(line);
  }

  struct Solution {
    std::string effects, source;  ///< names of a set, and where its last solution is
  };
  ForwardModel& model_;
  std::function<void(const std::string&)> progress_;
  RecordedProtocols protocols_;
  std::string before_;
  std::vector<Solution> after_;
  double displacement_error_ = 0;
  int solves_ = 0;
  bool is_incomplete_ = false;
  std::vector<std::string> remarks_;
};

}  // namespace asperity
