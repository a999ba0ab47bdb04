// A case file as the simulation of a diagnosis: solved with changed entries, each solution in a folder named
// by its inputs, so that what was solved once is not solved again.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/parameter_file.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// With what cases are solved, and where they are kept.
struct FiniteElementModelOptions {
  std::filesystem::path solver;  ///< program called as: solver solve CASE.prm ...
  std::filesystem::path folder;  ///< for the solved cases
  int cores = 1;
  std::function<void(const std::string&)> say;  ///< receives progress, line by line
};

class FiniteElementModel : public ForwardModel {
 public:
  /// Throws InputError where the case is none that a normal recording can be set against, naming the entry.
  FiniteElementModel(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     FiniteElementModelOptions options);

  SimulatedBodies bodies() const override;
  /// Throws InputError for a change that the case refuses, WorkError where it cannot be solved.
  std::vector<SolvedResponse> solve(const std::vector<CaseChange>& changes,
                                    const std::vector<LoadingProtocol>& protocols) override;

  /// Every entry of the case as given, for a corrected case to be written from.
  const Settings& settings() const { return settings_; }

 private:
  std::filesystem::path file_;
  Settings settings_;
  CaseInput input_;
  FiniteElementModelOptions options_;
};

}  // namespace asperity
