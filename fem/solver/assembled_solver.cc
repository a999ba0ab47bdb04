#include "fem/solver/assembled_solver.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <map>

#include "core/error.h"
#include "fem/solver/conjugate_gradients.h"

namespace asperity::fem {
namespace {

using dealii::types::global_dof_index;
constexpr int rigid_body_modes = 6, unknowns_per_hex = 24;

}  // namespace

struct AssembledSolver::Trilinos {
  dealii::TrilinosWrappers::SparseMatrix matrix;
  dealii::TrilinosWrappers::SparseMatrix preconditioned;  // what the hierarchy was made of
  dealii::TrilinosWrappers::PreconditionAMG preconditioner;
};

AssembledSolver::AssembledSolver(const LinearProblem& problem)
    : problem_(problem),
      constraints_(problem.level.constraints()),
      cells_(problem.level, problem.positions, problem.materials),
      trilinos_(std::make_unique<Trilinos>()) {
  resolve_rows();
  make_pattern();
  make_rigid_body_modes();
}

AssembledSolver::~AssembledSolver() = default;

std::string AssembledSolver::description() const {
  return std::to_string(trilinos_->matrix.n_nonzero_elements() / 1000000) +
         " million matrix entries, algebraic multigrid";
}

void AssembledSolver::recouple(const RigidMotion& motion) {
  if (motion.roll != 0)
    throw InputError("the assembled solver cannot roll; set Solver/Backend = matrix-free");
  resolve_rows();
  make_pattern();
  row_stiffness_.clear();
}

void AssembledSolver::resolve_rows() {
  row_.clear();
  const MeshLevel& level = problem_.level;
  const InterfaceNodes& nodes = problem_.interface.nodes();
  // Rows reach over nodes of any rank, and only a node's owner is sure to know how it is constrained.
  const auto& owned = level.dofs().locally_owned_dofs();
  std::vector<std::pair<global_dof_index, Row>> known;
  for (int k = 0; k < nodes.count(); ++k)
    for (int c = 0; c < 3; ++c) {
      const auto dof = static_cast<global_dof_index>(3 * nodes.global_node(k) + c);
      if (!owned.is_element(dof) || !constraints_.is_constrained(dof)) continue;
      const auto* entries = constraints_.get_constraint_entries(dof);
      known.emplace_back(dof, entries ? *entries : Row{});
    }
  std::map<global_dof_index, Row> masters;
  for (const auto& part : dealii::Utilities::MPI::all_gather(level.communicator(), known))
    masters.insert(part.begin(), part.end());

  const auto [first, last] = problem_.interface.share();
  for (int r = first; r < last; ++r) {
    auto& jump = row_.emplace_back();
    for (int c = 0; c < 3; ++c) {
      std::map<global_dof_index, double> sum;
      const auto add = [&](int node, int component, double weight) {
        const auto dof = static_cast<global_dof_index>(3 * nodes.global_node(node) + component);
        const auto constrained = masters.find(dof);
        if (constrained == masters.end())
          sum[dof] += weight;
        else
          for (const auto& [master, share] : constrained->second) sum[master] += weight * share;
      };
      problem_.interface.for_row(r, [&](int node, double weight) {
        if (nodes.site(node).body != 0) return add(node, c, weight);
        for (int own = 0; own < 3; ++own)
          if (const double turn = problem_.interface.rotation()[c][own]; turn != 0)
            add(node, own, weight * turn);
      });
      jump[c].assign(sum.begin(), sum.end());
    }
  }
}

void AssembledSolver::make_pattern() {
  const MeshLevel& level = problem_.level;
  const auto& owned = level.dofs().locally_owned_dofs();
  dealii::IndexSet written = level.partitioner()->ghost_indices();
  written.add_indices(owned);
  for (const auto& jump : row_)
    for (const auto& row : jump)
      for (const auto& entry : row) written.add_index(entry.first);
  written.compress();
  dealii::TrilinosWrappers::SparsityPattern pattern(owned, owned, written, level.communicator());
  dealii::DoFTools::make_sparsity_pattern(level.dofs(), pattern, constraints_, false,
                                          dealii::Utilities::MPI::this_mpi_process(level.communicator()));
  const auto couple = [&](const Row& one, const Row& other) {
    std::vector<global_dof_index> columns;
    for (const auto& entry : other) columns.push_back(entry.first);
    for (const auto& entry : one) pattern.add_entries(entry.first, columns.begin(), columns.end(), true);
  };
  for (const auto& jump : row_)
    for (const auto& one : jump)
      for (const auto& other : jump) couple(one, other);
  if (level.owns_driven_dof()) pattern.add(level.driven_dof(), level.driven_dof());
  pattern.compress();
  trilinos_->matrix.reinit(pattern);
}

void AssembledSolver::make_rigid_body_modes() {
  // Three translations and three rotations about the origin, mode by mode over the owned unknowns; lengths in
  // units of the particle's radius, so that all modes are of one size.
  const auto& x = problem_.positions;
  const std::size_t n = x.locally_owned_size();
  const double unit = 1 / problem_.mesh.sizes.radius;
  modes_.assign(rigid_body_modes * n, 0.0);
  for (std::size_t node = 0; node < n / 3; ++node) {
    const double p[3] = {unit * x.local_element(3 * node), unit * x.local_element(3 * node + 1),
                         unit * x.local_element(3 * node + 2)};
    for (int c = 0; c < 3; ++c) {
      const int a = (c + 1) % 3, b = (c + 2) % 3;
      modes_[c * n + 3 * node + c] = 1;
      modes_[(3 + c) * n + 3 * node + a] = -p[b];
      modes_[(3 + c) * n + 3 * node + b] = p[a];
    }
  }
}

void AssembledSolver::assemble_bodies(const TangentField* tangent) {
  cells_.set_tangent(tangent);
  const MeshLevel& level = problem_.level;
  std::vector<global_dof_index> dofs(unknowns_per_hex);
  dealii::FullMatrix<double> local(unknowns_per_hex, unknowns_per_hex);
  HexOperator<double>::CellMatrices matrices;
  for (int b = 0; b < static_cast<int>(level.batches().size()); ++b) {
    const CellBatch& batch = level.batches()[b];
    cells_.cell_matrices(b, matrices);
    for (int l = 0; l < batch.count; ++l) {
      for (int v = 0; v < vertices_per_hex; ++v)
        for (int c = 0; c < 3; ++c)
          dofs[3 * v + c] = level.partitioner()->local_to_global(3 * batch.node[v][l] + c);
      for (int i = 0; i < unknowns_per_hex; ++i)
        for (int j = 0; j < unknowns_per_hex; ++j) local(i, j) = matrices[i][j][l];
      constraints_.distribute_local_to_global(local, dofs, trilinos_->matrix);
    }
  }
}

void AssembledSolver::assemble_interface(const std::vector<RowStiffness>& row_stiffness) {
  const int first = problem_.interface.share().first;
  std::vector<global_dof_index> columns;
  std::vector<double> values;
  const auto add = [&](const Row& one, const Row& other, double stiffness) {
    if (stiffness == 0) return;
    for (const auto& [dof, weight] : one) {
      columns.clear();
      values.clear();
      for (const auto& [column, other_weight] : other) {
        columns.push_back(column);
        values.push_back(stiffness * weight * other_weight);
      }
      trilinos_->matrix.add(dof, columns.size(), columns.data(), values.data());
    }
  };
  for (std::size_t r = 0; r < row_.size(); ++r) {
    const RowStiffness& k = row_stiffness[first + r];
    const auto& m = problem_.interface.slope(first + static_cast<int>(r));
    const double normal[3] = {m[0], m[1], 1}, slip[3][3] = {{k.xx, k.xy, 0}, {k.xy, k.yy, 0}, {0, 0, 0}};
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) add(row_[r][c], row_[r][d], k.normal * normal[c] * normal[d] + slip[c][d]);
  }
}

void AssembledSolver::update(const std::vector<RowStiffness>& row_stiffness, const TangentField* tangent,
                             double driven_spring) {
  auto& matrix = trilinos_->matrix;
  matrix = 0;
  assemble_bodies(tangent);
  assemble_interface(row_stiffness);
  if (driven_spring != 0 && problem_.level.owns_driven_dof())
    matrix.add(problem_.level.driven_dof(), problem_.level.driven_dof(), driven_spring);
  matrix.compress(dealii::VectorOperation::add);
  if (!needs_new_hierarchy(row_stiffness)) return;
  row_stiffness_ = row_stiffness;
  iterations_at_first_ = iterations_at_last_ = 0;
  make_hierarchy();
}

/// A hierarchy of an earlier matrix serves as long as the same contacts are closed and stick, but for a few,
/// each of which costs an iteration or two, and while iterations show that the bodies' tangent is not
/// another.
bool AssembledSolver::needs_new_hierarchy(const std::vector<RowStiffness>& row_stiffness) const {
  if (row_stiffness_.size() != row_stiffness.size()) return true;
  constexpr int few = 8;
  if (iterations_at_last_ > 2 * iterations_at_first_ + few) return true;
  constexpr double much = 3;
  const auto differs = [](double a, double b) { return std::max(a, b) > much * std::min(a, b); };
  int others = 0;
  for (std::size_t r = 0; r < row_stiffness.size(); ++r) {
    const RowStiffness &a = row_stiffness_[r], &b = row_stiffness[r];
    others += differs(a.normal, b.normal) || differs(a.xx + a.yy, b.xx + b.yy);
  }
  return others > few;
}

void AssembledSolver::make_hierarchy() {
  trilinos_->preconditioned.copy_from(trilinos_->matrix);
  Teuchos::ParameterList parameters;
  parameters.set("max levels", 10);
  parameters.set("prec type", "MGV");
  parameters.set("increasing or decreasing", "increasing");
  parameters.set("aggregation: damping factor", 1.333);
  parameters.set("eigen-analysis: type", "cg");
  parameters.set("eigen-analysis: iterations", 10);
  parameters.set("PDE equations", 3);
  parameters.set("null space: type", "pre-computed");
  parameters.set("null space: dimension", rigid_body_modes);
  parameters.set("null space: vectors", modes_.data());
  parameters.set("aggregation: type", "Uncoupled");
  parameters.set("aggregation: threshold", 1e-3);
  parameters.set("smoother: type", "Chebyshev");
  parameters.set("smoother: sweeps", 4);
  parameters.set("smoother: Chebyshev alpha", 10.0);
  parameters.set("coarse: type", "Amesos-KLU");
  parameters.set("coarse: max size", 500);
  parameters.set("ML output", 0);
  trilinos_->preconditioner.initialize(trilinos_->preconditioned, parameters);
}

int AssembledSolver::solve(Vector<double>& x, const Vector<double>& rhs, double relative_tolerance) const {
  iterations_at_last_ = conjugate_gradients(problem_.level, trilinos_->matrix, trilinos_->preconditioner, x,
                                            rhs, relative_tolerance);
  if (iterations_at_first_ == 0) iterations_at_first_ = iterations_at_last_;
  return iterations_at_last_;
}

}  // namespace asperity::fem
