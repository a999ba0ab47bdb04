// A whole experiment, solved into a folder and read back from its files.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
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

}  // namespace asperity::test
