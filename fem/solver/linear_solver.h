// The linearised contact problem and its solution: the one interface that the Newton iteration knows. Behind
// it stand the matrix-free path (geometric multigrid) and the assembled one (algebraic multigrid).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fem/mortar/interface_operator.h"
#include "fem/solver/hex_operator.h"

namespace asperity::fem {

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  static constexpr int most_iterations = 400;

  /// Sets the operator C^T (K + G^T E G) C + k e e^T and prepares its preconditioner.
  /// row_stiffness: E, of each contact row. tangent: of the cell batches that yield, null: elastic;
  /// must live until the next update. driven_spring: k, from the driven plane to the ground [N/m] (force
  /// control).
  virtual void update(const std::vector<RowStiffness>& row_stiffness, const TangentField* tangent,
                      double driven_spring) = 0;

  /// To be called when the rows and the interface have changed (sliding); an update follows.
  virtual void recouple(const RigidMotion& motion) = 0;
  /// To be called when only the slopes of the rows have changed; an update follows.
  virtual void follow_slopes() = 0;

  /// Preconditioned conjugate gradients from x = 0 until the residual has fallen by the tolerance (or after
  /// most_iterations: an inexact direction is still one of descent; who needs the solution looks at what is
  /// returned), or until a direction of negative curvature, where the matrix is indefinite: x is then a
  /// direction of descent and no solution (Steihaug 1983). Constrained entries and ghosts of x are set.
  /// Returns the iterations.
  /// relative_tolerance [-].
  virtual int solve(Vector<double>& x, const Vector<double>& rhs, double relative_tolerance) const = 0;

  /// For the log: what it is and how large, e.g. "9 multigrid levels".
  virtual std::string description() const = 0;
};

/// The parts of a contact problem that a linear solver works on; all must outlive it.
struct LinearProblem {
  const MeshLevel& level;
  const Vector<double>& positions;
  const CellMaterials& materials;
  InterfaceOperator& interface;  ///< of `level`
  const std::vector<GapRow>& rows;
  const meshing::ContactMeshOptions& mesh;
  const meshing::RoughGeometry& geometry;
  Control control;
};

/// By name: "matrix-free" or "assembled". Throws InputError on another.
std::unique_ptr<LinearSolver> make_linear_solver(const std::string& backend, const LinearProblem& problem);

}  // namespace asperity::fem
