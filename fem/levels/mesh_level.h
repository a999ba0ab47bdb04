// Unknowns, constraints and cells of one mesh level, in the arrays that the kernels read.
#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>
#include <vector>

#include "core/threads.h"
#include "fem/cells/simd.h"
#include "fem/levels/cell_materials.h"
#include "fem/levels/constraint_lines.h"
#include "meshing/contact_mesh.h"

namespace asperity::fem {

template <typename Number>
using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

/// Whether the driven plane's common displacement along z is an unknown (force) or given (displacement).
enum class Control { force, displacement };

/// Eight cells, siblings where all eight are at hand: local node numbers [vertex][lane]; lanes beyond `count`
/// repeat lane 0 and are not written.
struct CellBatch {
  std::array<std::array<int, lanes>, vertices_per_hex> node;
  std::array<unsigned char, lanes> body;
  std::array<unsigned char, lanes> material;  ///< its number (cell_materials.h); the body's without a film
  int count = 0;
};

/// A square face of an interface in the logical lattice of its tree, with global node numbers.
struct InterfaceFace {
  int body;                  ///< 0 particle, 1 substrate
  int i, j, size;            ///< lower corner and width in units of 2^-lattice_bits of the tree
  std::array<long, 4> node;  ///< global nodes, lexicographic
};
constexpr int lattice_bits = 20;

class MeshLevel {
 public:
  MeshLevel(const dealii::Triangulation<3>& triangulation, Control control)
      : MeshLevel(triangulation, control, triangulation.get_communicator()) {}
  /// communicator: of the vectors, for a level that outlives its triangulation.
  MeshLevel(const dealii::Triangulation<3>& triangulation, Control control, MPI_Comm communicator);

  /// Numbers the unknowns again if they have been released. Collective; until release_cells().
  const dealii::DoFHandler<3>& dofs() const;
  /// Lets deal.II's numbering go, some 40 bytes an unknown, until dofs() asks for it.
  void release_dofs() { dofs_.reset(); }
  /// For deal.II's own assembly; made anew by each call, since nothing else needs them.
  dealii::AffineConstraints<double> constraints() const;
  /// Gives up the cells as deal.II describes them, with dofs() and constraints(): what is left multiplies,
  /// constrains and moves vectors. The triangulation may go too.
  void release_cells();
  const std::shared_ptr<const dealii::Utilities::MPI::Partitioner>& partitioner() const {
    return partitioner_;
  }
  MPI_Comm communicator() const { return communicator_; }
  const std::vector<CellBatch>& batches() const { return batches_; }
  /// Numbers the materials of cells that lie in films.
  void take_films(const meshing::RoughGeometry& geometry, const CellMaterials& materials);
  /// Batch and lane of an owned cell, by its number among the active cells.
  std::pair<int, int> place_of(unsigned active_cell) const {
    return {place_of_cell_[active_cell] / lanes, place_of_cell_[active_cell] % lanes};
  }
  /// Faces of both interfaces of all ranks, sorted; the same on every rank.
  const std::vector<InterfaceFace>& interface_faces() const { return interface_faces_; }
  dealii::types::global_dof_index size() const { return size_; }
  /// Global dof of the driven plane's displacement along z; constrained under displacement control.
  dealii::types::global_dof_index driven_dof() const { return driven_dof_; }
  bool owns_driven_dof() const { return partitioner_->in_local_range(driven_dof_); }
  int local_driven_dof() const { return static_cast<int>(partitioner_->global_to_local(driven_dof_)); }
  /// Local nodes of the driven plane, owned here.
  const std::vector<int>& driven_nodes() const { return driven_nodes_; }
  /// Unknowns (local) that follow the driven plane's displacement along z, and how much of it they get.
  const std::vector<std::pair<int, double>>& driven_share() const { return driven_share_; }
  /// The driven plane moves by `tilt` times as much along x as along z: under a particle that has rolled by
  /// an angle, -tan(angle) keeps its motion upright.
  /// tilt [-].
  void set_drive_tilt(double tilt);
  /// Local z dofs, owned here, of the nodes of the fixed plane that are not hanging.
  const std::vector<int>& fixed_z() const { return fixed_z_; }

  /// Positions of all nodes in the layout of a displacement vector.
  Vector<double> node_positions(const meshing::RoughGeometry& geometry) const;

  /// Gives a vector this level's layout, with zeros.
  template <typename Number>
  void initialise(Vector<Number>& vector) const {
    vector.reinit(partitioner_);
  }

  /// Sets constrained entries from the free ones (homogeneous part). Ghosts must be up to date.
  template <typename Number>
  void distribute(Number* x) const {
    lines_.all().distribute(x);
  }
  /// Transpose: moves what constrained rows received to the free ones and zeroes them.
  template <typename Number>
  void condense(Number* y) const {
    lines_.all().condense(y);
  }
  const ConstraintLines& lines() const { return lines_; }
  /// The same with a given displacement of the driven plane along z (displacement control).
  /// x and driven [m].
  void distribute(double* x, double driven) const {
    distribute(x);
    for (const auto& [dof, share] : driven_share_) x[dof] += share * driven;
  }
  const std::vector<int>& constrained() const { return lines_.constrained(); }
  void condense_diagonal(double* y) const { lines_.condense_diagonal(y); }

  /// Batches in runs, one round of them after the other; the threads of a round write without meeting.
  /// work(first, last), pointers to numbers of batches.
  template <typename Work>
  void for_each_run(const Work& work) const {
    for (const auto& round : rounds_) {
      const int* batches = ordered_batches_.data();
      for_parts(static_cast<int>(round.size()) - 1, 1, [&](int run, int end) {
        for (; run < end; ++run) work(batches + round[run], batches + round[run + 1]);
      });
    }
  }
  /// The same, one by one.
  template <typename Work>
  void for_each_batch(const Work& work) const {
    for_each_run([&](const int* first, const int* last) {
      for (const int* batch = first; batch != last; ++batch) work(*batch);
    });
  }

 private:
  /// How much of the driven plane's common displacement each unknown gets along z, and along x when tilted.
  struct DriveShares;
  /// What nodes of both planes and hanging ones follow, whatever the control.
  struct TiedNodes;

  /// Collective, in this order: driven unknown, constraints whatever the control, those of the control,
  /// layout of vectors, arrays for the kernels.
  void make_constraints();
  void choose_driven_dof();
  dealii::IndexSet relevant_dofs() const;
  /// Nodes of the driven plane follow one of them, hanging nodes their masters, whatever the control.
  TiedNodes tie_nodes(const dealii::IndexSet& relevant) const;
  /// Displacement control takes the plane's common displacement out of the unknowns; how much of it each node
  /// gets is kept in `shares`.
  dealii::AffineConstraints<double> constrain(const dealii::AffineConstraints<double>& tied,
                                              DriveShares& shares) const;
  void make_partitioner(const dealii::IndexSet& relevant, const dealii::AffineConstraints<double>& tied);
  void fill_arrays(const dealii::AffineConstraints<double>& constraints, const DriveShares& shares);
  void make_batches();
  using Cell = dealii::DoFHandler<3>::active_cell_iterator;
  void add_to_batch(const Cell& cell, int index);
  /// Slab along an axis of each of these batches, all with as many batches: few of them meet.
  std::vector<int> slabs_of_batches(const std::vector<int>& batches, int slabs, int axis) const;
  void make_thread_runs();
  /// Adds a round of `runs` over these batches; returns those that would meet others of the round.
  std::vector<int> add_round(const std::vector<int>& batches, int runs, int axis);
  void collect_interfaces();

  MPI_Comm communicator_;
  dealii::FESystem<3> element_;
  Control control_;
  const dealii::Triangulation<3>* triangulation_;
  mutable std::unique_ptr<dealii::DoFHandler<3>> dofs_;
  dealii::types::global_dof_index size_;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
  dealii::types::global_dof_index first_owned_ = 0, driven_dof_ = dealii::numbers::invalid_dof_index;
  std::vector<int> driven_nodes_, fixed_z_;
  std::vector<std::pair<int, double>> driven_share_, share_along_z_, share_along_x_;
  std::vector<std::pair<int, double>> tilted_entry_;  ///< entries that hold a share along x, and that share
  std::vector<CellBatch> batches_;
  std::vector<int> ordered_batches_;
  std::vector<std::vector<int>> rounds_;  ///< of each the begins of its runs in ordered_batches_, and the end
  ConstraintLines lines_;
  std::vector<InterfaceFace> interface_faces_;
  std::vector<int> place_of_cell_;  ///< lanes * batch + lane; -1: not owned
};

}  // namespace asperity::fem
