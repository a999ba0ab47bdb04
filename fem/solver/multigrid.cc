#include "fem/solver/multigrid.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "fem/solver/smoothed_part.h"

namespace asperity::fem {
Multigrid::Multigrid(const meshing::ContactMeshOptions& options, const MeshLevel& finest, Control control,
                     const meshing::RoughGeometry& geometry, const CellMaterials& materials) {
  const int finest_level = std::max(geometry.map().finest_level(meshing::Body::particle),
                                    geometry.map().finest_level(meshing::Body::substrate));
  std::vector<std::unique_ptr<MeshLevel>> meshes;
  for (int coarsenings = finest_level - 1; coarsenings > 0; --coarsenings) {
    forests_.push_back(meshing::make_forest(finest.communicator(), options, coarsenings));
    meshes.push_back(std::make_unique<MeshLevel>(*forests_.back(), control));
  }
  level_.resize(meshes.size() + 1);
  for (std::size_t l = 0; l < level_.size(); ++l) {
    Level& level = level_[l];
    if (l + 1 < level_.size()) {
      level.owned_mesh = std::move(meshes[l]);
      level.owned_mesh->take_films(geometry, materials);
    }
    level.mesh = level.owned_mesh ? level.owned_mesh.get() : &finest;
    level.matrix =
        std::make_unique<HexOperator<float>>(*level.mesh, level.mesh->node_positions(geometry), materials);
    level.matrix->take_cells_as_parallelepipeds();
    for (auto* v : {&level.solution, &level.defect, &level.scratch}) level.mesh->initialise(*v);
    if (l == 0) continue;
    level.transfer = std::make_unique<LevelTransfer>(*level.mesh, *level_[l - 1].mesh);
    SmoothedPart part = smoothed_part(*level.mesh, *level.transfer);
    level.matrix->set_part(std::move(part.batch));
    level.smoother.set_smoothed(std::move(part.node));
  }
  const MeshLevel& coarse = *level_[0].mesh;
  std::vector<int> free(coarse.size(), 1);
  for (const auto& line : coarse.constraints().get_lines()) free[line.index] = 0;
  dealii::Utilities::MPI::min(free, coarse.communicator(),
                              free);  // each rank knows the constraints near its own cells
  for (dealii::types::global_dof_index i = 0; i < coarse.size(); ++i)
    if (free[i]) coarse_free_.push_back(i);
}

void Multigrid::set_interface_rows(const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes,
                                   const RigidMotion& motion) {
  for (auto& level : level_) {
    if (level.owned_mesh) level.owned_mesh->set_drive_tilt(-std::tan(motion.roll));
    if (level.interface) {
      level.interface->set_rows(rows, fine_nodes);
    } else {
      level.interface = std::make_unique<InterfaceOperator>(*level.mesh, rows, fine_nodes);
      level.matrix->set_interface(level.interface.get());
    }
    level.interface->set_rotation(rotation(motion));
  }
}

void Multigrid::update(const std::vector<RowStiffness>& row_stiffness, const TangentField* tangent,
                       double driven_spring) {
  level_.back().matrix->set_tangent(tangent);
  for (std::size_t l = 0; l < level_.size(); ++l) {
    level_[l].matrix->set_driven_spring(driven_spring);
    if (level_[l].interface) level_[l].interface->set_stiffness(row_stiffness);
    if (l > 0) level_[l].smoother.update(*level_[l].matrix);
  }
  factor_coarsest();
}

void Multigrid::factor_coarsest() {
  // Columns of the condensed operator by applying it to unit vectors; the coarsest level has a few hundred
  // unknowns.
  const Level& level = level_[0];
  const int n = static_cast<int>(coarse_free_.size());
  Vector<float> unit, column;
  level.mesh->initialise(unit);
  level.mesh->initialise(column);
  const auto apply_unit = [&](int k) {
    unit = 0.0f;
    if (level.mesh->partitioner()->in_local_range(coarse_free_[k])) unit(coarse_free_[k]) = 1.0f;
    level.matrix->vmult(column, unit);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(n);
    for (int i = 0; i < n; ++i)
      if (level.mesh->partitioner()->in_local_range(coarse_free_[i])) values[i] = column(coarse_free_[i]);
    return values;
  };
  Eigen::MatrixXd matrix(n, n);
  for (int k = 0; k < n; ++k) matrix.col(k) = apply_unit(k);
  if (dealii::Utilities::MPI::n_mpi_processes(level.mesh->communicator()) > 1)
    MPI_Allreduce(MPI_IN_PLACE, matrix.data(), n * n, MPI_DOUBLE, MPI_SUM, level.mesh->communicator());
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
  level.smoother.smooth(*level.matrix, level.solution, level.defect, true);
  level.matrix->vmult(level.scratch, level.solution);
  level.scratch.sadd(-1.0f, level.defect);
  for (const int c : level.mesh->constrained())
    if (c < static_cast<int>(level.scratch.locally_owned_size())) level.scratch.local_element(c) = 0;
  level.transfer->restrict_to(coarse.defect, level.scratch);
  cycle(index - 1);
  level.transfer->prolongate_and_add(level.solution, coarse.solution);
  level.smoother.smooth(*level.matrix, level.solution, level.defect, false);
}

void Multigrid::vmult(Vector<double>& dst, const Vector<double>& src) const {
  const Level& finest = level_.back();
  // Scaled to unit size: forces of nN on nm spacings would leave the range of single precision.
  const double scale = src.linfty_norm();
  if (scale == 0) {
    dst = 0.0;
    return;
  }
  for (unsigned i = 0; i < src.locally_owned_size(); ++i)
    finest.defect.local_element(i) = static_cast<float>(src.local_element(i) / scale);
  cycle(levels() - 1);
  for (unsigned i = 0; i < dst.locally_owned_size(); ++i)
    dst.local_element(i) = scale * static_cast<double>(finest.solution.local_element(i));
  for (const int c : finest.mesh->constrained())
    if (c < static_cast<int>(dst.locally_owned_size())) dst.local_element(c) = 0;
}

}  // namespace asperity::fem
