#include "fem/solver/multigrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "core/threads.h"
#include "fem/solver/smoothed_part.h"

namespace asperity::fem {
Multigrid::Multigrid(const meshing::ContactMeshOptions& options, const MeshLevel& finest, Control control,
                     const meshing::RoughGeometry& geometry, const CellMaterials& materials) {
  const int finest_level = std::max(geometry.map().finest_level(meshing::Body::particle),
                                    geometry.map().finest_level(meshing::Body::substrate));
  level_.resize(static_cast<std::size_t>(std::max(finest_level, 1)));
  // Of the coarser levels' cells nothing is kept but what the transfer to the next level needs, until then.
  std::unique_ptr<meshing::Triangulation> forest;
  for (std::size_t l = 0; l < level_.size(); ++l) {
    Level& level = level_[l];
    const int coarsenings = static_cast<int>(level_.size() - 1 - l);
    std::unique_ptr<meshing::Triangulation> own_forest;
    if (coarsenings > 0) {
      own_forest = meshing::make_forest(finest.communicator(), options, coarsenings);
      level.owned_mesh = std::make_unique<MeshLevel>(*own_forest, control, finest.communicator());
      level.owned_mesh->take_films(geometry, materials);
    }
    level.mesh = level.owned_mesh ? level.owned_mesh.get() : &finest;
    level.matrix =
        std::make_unique<HexOperator<float>>(*level.mesh, level.mesh->node_positions(geometry), materials);
    level.matrix->take_cells_as_parallelepipeds();
    for (auto* v : {&level.solution, &level.defect, &level.scratch}) level.mesh->initialise(*v);
    if (l > 0) {
      level.transfer = std::make_unique<LevelTransfer>(*level.mesh, *level_[l - 1].mesh);
      SmoothedPart part = smoothed_part(*level.mesh, *level.transfer);
      level.matrix->set_part(std::move(part.batch));
      level.smoother.set_smoothed(std::move(part.node));
      level_[l - 1].owned_mesh->release_cells();
    }
    forest = std::move(own_forest);
  }
  find_coarse_unknowns();
}

void Multigrid::find_coarse_unknowns() {
  const MeshLevel& coarse = *level_[0].mesh;
  std::vector<int> free(coarse.size(), 1), at_contact(coarse.size(), 0);
  const auto& layout = *coarse.partitioner();
  for (const int local : coarse.constrained()) free[layout.local_to_global(local)] = 0;
  dealii::Utilities::MPI::min(free, coarse.communicator(),
                              free);  // each rank knows the constraints near its own cells
  // What an unknown moves of the interface, hanging nodes included: the transpose of forces on all of it.
  Vector<float> forces;
  coarse.initialise(forces);
  for (const auto& face : coarse.interface_faces())
    for (const long node : face.node)
      for (int c = 0; c < 3; ++c)
        if (const auto dof = static_cast<dealii::types::global_dof_index>(3 * node + c);
            layout.in_local_range(dof))
          forces(dof) = 1;
  coarse.condense(forces.begin());
  forces.compress(dealii::VectorOperation::add);
  for (dealii::types::global_dof_index i = 0; i < coarse.size(); ++i)
    if (layout.in_local_range(i) && (forces(i) != 0 || i == coarse.driven_dof())) at_contact[i] = 1;
  dealii::Utilities::MPI::max(at_contact, coarse.communicator(), at_contact);
  for (dealii::types::global_dof_index i = 0; i < coarse.size(); ++i) {
    if (!free[i]) continue;
    if (at_contact[i]) coarse_at_contact_.push_back(static_cast<int>(coarse_free_.size()));
    coarse_free_.push_back(i);
  }
}

void Multigrid::set_interface_rows(const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes,
                                   const RigidMotion& motion) {
  if (motion.roll != roll_) coarse_bodies_.resize(0, 0);  // the driven plane moves along another direction
  roll_ = motion.roll;
  for (auto& level : level_) {
    if (level.owned_mesh) level.owned_mesh->set_drive_tilt(-std::tan(motion.roll));
    if (level.interface) {
      level.interface->set_rows(rows, fine_nodes);
    } else {
      level.interface = std::make_unique<InterfaceOperator>(*level.mesh, rows, fine_nodes,
                                                            InterfaceOperator::Precision::single);
      level.matrix->set_interface(level.interface.get());
    }
    level.interface->set_rotation(rotation(motion));
  }
}

void Multigrid::update(const std::vector<RowStiffness>& row_stiffness, const TangentField* tangent,
                       double driven_spring) {
  level_.back().matrix->set_tangent(tangent);
  const auto stiffness = std::make_shared<const std::vector<RowStiffness>>(row_stiffness);
  for_parts(levels(), 1, [&](int l, int end) {
    for (; l < end; ++l) level_[l].interface->set_stiffness(stiffness);
  });
  for (std::size_t l = 0; l < level_.size(); ++l) {
    level_[l].matrix->set_driven_spring(driven_spring);
    if (l > 0) level_[l].smoother.update(*level_[l].matrix);
  }
  factor_coarsest();
}

template <typename Multiply>
Eigen::MatrixXd Multigrid::coarse_columns(const std::vector<int>& of, const Multiply& multiply) const {
  const Level& level = level_[0];
  const int n = static_cast<int>(coarse_free_.size());
  Vector<float> unit, column;
  level.mesh->initialise(unit);
  level.mesh->initialise(column);
  const auto is_own = [&](int i) { return level.mesh->partitioner()->in_local_range(coarse_free_[i]); };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (const int k : of) {
    unit = 0.0f;
    if (is_own(k)) unit(coarse_free_[k]) = 1.0f;
    multiply(column, unit);
    for (int i = 0; i < n; ++i)
      if (is_own(i)) matrix(i, k) = column(coarse_free_[i]);
  }
  if (dealii::Utilities::MPI::n_mpi_processes(level.mesh->communicator()) > 1)
    MPI_Allreduce(MPI_IN_PLACE, matrix.data(), n * n, MPI_DOUBLE, MPI_SUM, level.mesh->communicator());
  return matrix;
}

void Multigrid::factor_coarsest() {
  // Columns of the condensed operator by applying it to unit vectors; the coarsest level has a few hundred
  // unknowns. Its bodies stay as they are, and few unknowns move the interface.
  const HexOperator<float>& coarsest = *level_[0].matrix;
  std::vector<int> all(coarse_free_.size());
  std::iota(all.begin(), all.end(), 0);
  const bool bodies_change = levels() == 1;  // tangents are those of the finest level
  if (coarse_bodies_.size() == 0 || bodies_change)
    coarse_bodies_ =
        coarse_columns(all, [&](auto& column, const auto& unit) { coarsest.vmult_of_bodies(column, unit); });
  Eigen::MatrixXd matrix = coarse_columns(
      coarse_at_contact_, [&](auto& column, const auto& unit) { coarsest.vmult_of_contact(column, unit); });
  matrix += coarse_bodies_;
  matrix = 0.5 * (matrix + matrix.transpose()).eval();
  coarse_factor_.compute(matrix);
  if (coarse_factor_.info() != Eigen::Success)
    throw WorkError(
        "the coarsest level is singular: no contact holds the particle; start from a state in contact or "
        "control the displacement");
}

void Multigrid::solve_coarsest() const {
  const Level& level = level_[0];
  const int n = static_cast<int>(coarse_free_.size());
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < n; ++i)
    if (level.mesh->partitioner()->in_local_range(coarse_free_[i])) rhs[i] = level.defect(coarse_free_[i]);
  if (dealii::Utilities::MPI::n_mpi_processes(level.mesh->communicator()) > 1)
    MPI_Allreduce(MPI_IN_PLACE, rhs.data(), n, MPI_DOUBLE, MPI_SUM, level.mesh->communicator());
  const Eigen::VectorXd x = coarse_factor_.solve(rhs);
  level.solution = 0.0f;
  for (int i = 0; i < n; ++i)
    if (level.mesh->partitioner()->in_local_range(coarse_free_[i]))
      level.solution(coarse_free_[i]) = static_cast<float>(x[i]);
}

void Multigrid::cycle(int index) const {
  if (index == 0) {
    solve_coarsest();
    return;
  }
  const Level& level = level_[index];
  const Level& coarse = level_[index - 1];
  level.smoother.smooth(*level.matrix, level.solution, level.defect, true, level.scratch);
  level.matrix->vmult(level.scratch, level.solution);
  // At constrained unknowns both are 0, whatever the solution holds there.
  float* left = level.scratch.begin();
  const float* defect = level.defect.begin();
  for_entries(static_cast<int>(level.scratch.locally_owned_size()),
              [=](int i) { left[i] = defect[i] - left[i]; });
  level.transfer->restrict_to(coarse.defect, level.scratch);
  cycle(index - 1);
  level.transfer->prolongate_and_add(level.solution, coarse.solution);
  level.smoother.smooth(*level.matrix, level.solution, level.defect, false, level.scratch);
}

void Multigrid::vmult(Vector<double>& dst, const Vector<double>& src) const {
  const Level& finest = level_.back();
  const int count = static_cast<int>(src.locally_owned_size());
  const double* from = src.begin();
  // Scaled to unit size: forces of nN on nm spacings would leave the range of single precision.
  const double scale = std::sqrt(dealii::Utilities::MPI::sum(
      sum_over_entries(count, [=](int i) { return from[i] * from[i]; }), finest.mesh->communicator()));
  if (scale == 0) {
    dst = 0.0;
    return;
  }
  float* defect = finest.defect.begin();
  for_entries(count, [=](int i) { defect[i] = static_cast<float>(from[i] / scale); });
  cycle(levels() - 1);
  double* to = dst.begin();
  const float* solution = finest.solution.begin();
  for_entries(count, [=](int i) { to[i] = scale * static_cast<double>(solution[i]); });
}

}  // namespace asperity::fem
