// A case file as the simulation of a diagnosis: solved with changed entries, each solution in a folder named
// by its inputs, so that what was solved once is not solved again.
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "app/other_surfaces.h"
#include "app/refused_cases.h"
#include "app/solved_cases.h"
#include "app/study.h"
#include "app/study_summary.h"
#include "core/case.h"
#include "core/parameter_file.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// With what cases are solved, and where they are kept.
struct FiniteElementModelOptions {
  std::filesystem::path solver;  ///< program called as: solver solve CASE.prm ...
  std::filesystem::path folder;  ///< for the solved cases
  SolvedCases earlier;           ///< solved elsewhere: taken as they are, and nothing is written there
  int cores = 1;
  double seconds = 30 * 60;  ///< wall time for all solutions but the case's as it is, from the start on [s]
  std::function<void(const std::string&)> say;  ///< receives progress, line by line
};

/// What one solution may take of the time for all of them, of which so much is spent [s]: half of what is
/// left for it and for others to come, and a quarter of all in any case.
inline double longest_solution(double for_all, double spent) {
  constexpr double half = 0.5, quarter = 0.25;
  return std::max(half * (for_all - spent), quarter * for_all);
}

class FiniteElementModel : public ForwardModel {
 public:
  /// Throws InputError where the case is none that a recording can be set against, naming the entry.
  FiniteElementModel(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     FiniteElementModelOptions options);

  SimulatedBodies bodies() const override;
  void refuse_unless_normal() const override { refuse_for_normal_recordings(input_, file_); }
  /// Throws InputError for a change that the case refuses, WorkError where it cannot be solved.
  std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                    const std::vector<LoadingProtocol>& protocols,
                                    const EnoughOfIt& enough) override;
  /// By half-spaces. Throws InputError, WorkError as these do.
  OtherSurfaces on_other_surfaces(double largest_force) override {
    return other_surfaces_of(input_, largest_force);
  }
  std::vector<MotionProtocol> solved_motions(Motion motion) override;
  /// Throws InputError for a change that the case refuses, WorkError where it does not slip as a
  /// whole, or roll steadily.
  std::vector<SolvedMotion> move(const std::vector<CaseChange>& changes,
                                 const std::vector<MotionProtocol>& protocols, bool must_end) override;

  /// Every entry of the case as given, for a corrected case to be written from.
  const Settings& settings() const { return settings_; }

 private:
  /// A case to be solved, or solved already in `folder`.
  struct Asked {
    std::filesystem::path folder;
    bool is_earlier = false, is_pressed_further = false;
    std::string ended_early;  ///< why what is there is enough; empty: it is complete, or to be solved
  };
  /// The case as it is driven; what is not solved elsewhere is added to `study`.
  Asked asked_of(const Settings& driven, Study& study) const;
  /// The case with these changes, driven so. Throws InputError for what it cannot take.
  template <class Protocol>
  Settings driven_by(const Protocol& protocol, const std::vector<CaseChange>& changes) const;
  /// A solution at hand of the same contact that was pressed as far or further, in enough steps; empty: none.
  std::filesystem::path pressed_further(const Settings& driven, const LoadingProtocol& protocol) const;
  Study empty_study() const;
  std::vector<SolvedMotion> move_once(const std::vector<CaseChange>& changes,
                                      const std::vector<MotionProtocol>& protocols, bool must_end);
  /// Why a solution that took so many seconds ends; empty: it goes on.
  std::string out_of_time(double seconds) const;
  std::vector<CaseProgress> run(const Study& study, const EnoughOfIt& enough,
                                const std::vector<std::string>& unchosen);
  double seconds_spent() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  }

  std::filesystem::path file_;
  Settings settings_;
  CaseInput input_;
  FiniteElementModelOptions options_;
  std::chrono::steady_clock::time_point begun_;
  double longest_ = std::numeric_limits<double>::infinity();  ///< what one of the solutions may take [s]
};

}  // namespace asperity
