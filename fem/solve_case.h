// Solves one case and writes its folder: result.json, history.csv, fields, checkpoints.
#pragma once

#include "core/case.h"
#include "fem/experiments/solve_options.h"

namespace asperity {

/// Collective over MPI_COMM_WORLD. Throws InputError for input that does not fit, WorkError if a step cannot
/// be solved; then the folder holds everything up to the last accepted step.
void solve_case(const CaseInput& input, const SolveOptions& options);

/// Throws what solve_case would before it meshes; reads scans, generates no surface.
void check_case(const CaseInput& input);

}  // namespace asperity
