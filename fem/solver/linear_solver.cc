#include "fem/solver/linear_solver.h"

#include "core/error.h"
#include "fem/solver/assembled_solver.h"
#include "fem/solver/matrix_free_solver.h"

namespace asperity::fem {

std::unique_ptr<LinearSolver> make_linear_solver(const std::string& backend, const LinearProblem& problem) {
  if (backend == "matrix-free") return std::make_unique<MatrixFreeSolver>(problem);
  if (backend == "assembled") return std::make_unique<AssembledSolver>(problem);
  throw InputError("Solver/Backend: '" + backend + "' is not known; use matrix-free or assembled");
}

}  // namespace asperity::fem
