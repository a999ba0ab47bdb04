// A whole experiment, solved into a folder and read back from its files.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "fem/solve_case.h"

namespace asperity::test {

struct SolvedExperiment {
  CsvTable history;
  nlohmann::json result;
  double at(const std::string& column, std::size_t row) const { return history.numbers(column).at(row); }
};

inline SolvedExperiment solve_experiment(const CaseInput& input, const std::filesystem::path& folder,
                                         bool resume = false) {
  SolveOptions options;
  options.output = folder;
  options.resume = resume;
  solve_case(input, options);
  return {read_csv(folder / "history.csv"), nlohmann::json::parse(read_file(folder / "result.json"))};
}

/// The same; `cut` gets what the folder holds once `after` steps are accepted, which is what a run that was
/// stopped there leaves.
inline SolvedExperiment solve_and_copy_after(const CaseInput& input, const std::filesystem::path& folder,
                                             const std::filesystem::path& cut, int after) {
  SolveOptions options;
  options.output = folder;
  int steps = 0;
  options.progress = [&](const std::string& line) {
    if (line.rfind("step ", 0) == 0 && ++steps == after)
      std::filesystem::copy(folder, cut, std::filesystem::copy_options::recursive);
  };
  solve_case(input, options);
  if (steps <= after) throw std::logic_error("nothing is left to resume after step " + std::to_string(after));
  return {read_csv(folder / "history.csv"), nlohmann::json::parse(read_file(folder / "result.json"))};
}

}  // namespace asperity::test
