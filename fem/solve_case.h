// Solves one case and writes its folder: result.json, history.csv, fields, checkpoints.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/case.h"

namespace asperity {

struct SolveOptions {
  std::filesystem::path output;
  bool resume = false;
  std::string inputs_sha256;  ///< of the case (app/inputs_hash.h), written into checkpoint and result
  std::function<void()>
      before_writing;  ///< called by the first rank once the case is meshed, before the first file is written
  std::function<void(const std::string&)> progress;  ///< one line per accepted step
};

/// Collective over MPI_COMM_WORLD. Throws InputError for input that does not fit, WorkError if a step cannot
/// be solved; then the folder holds everything up to the last accepted step.
void solve_case(const CaseInput& input, const SolveOptions& options);

/// Throws what solve_case would before it meshes; reads scans, generates no surface.
void check_case(const CaseInput& input);

}  // namespace asperity
