// The gap operator G of the finest mesh seen from one mesh level, and its stiffness G^T E G.
//
// G maps displacements to what the particle's surface moves relative to the substrate's at each contact row:
// along z the gap opens, along x and y it slips. The weights of a row are the same for the three components.
// Where the row has a slope m, slip along m opens the gap too: the row's normal is n = (m_x, m_y, 1), to
// first order in slopes. Rows, jumps and forces are in the substrate's frame; where the particle's frame is
// turned, its displacements are rotated into the substrate's frame and its forces back. The rows are the
// contact nodes of the finest mesh on every level: coarse functions are evaluated at them, which makes
// G_coarse = G P exactly and spares triple products when the active set changes. Where many rows meet few
// nodes, their stiffness is summed up for pairs of nodes. Interface values are
// gathered on all ranks; each rank works on its share of the rows.
#pragma once

#include <array>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "fem/levels/mesh_level.h"
#include "fem/mortar/interface_nodes.h"
#include "fem/mortar/mortar.h"
#include "fem/mortar/rigid_motion.h"

namespace asperity::fem {

/// Stiffness of a contact row [N/m]: against closing, and symmetric against slip in the plane. All 0: open.
struct RowStiffness {
  /// against_closing [N/m].
  RowStiffness(double against_closing = 0) : normal(against_closing) {}
  double normal, xx = 0, xy = 0, yy = 0;
  bool open() const { return normal == 0 && !resists_slip(); }
  bool resists_slip() const { return xx != 0 || xy != 0 || yy != 0; }
};

class InterfaceOperator {
 public:
  /// rows: of the finest mesh with its node numbering `fine_nodes`; level: where displacements live.
  /// precision: single leaves apply<float>() and add_diagonal() alone; both keeps what apply<float>() needs
  /// from its first call on.
  enum class Precision { both, single };
  InterfaceOperator(const MeshLevel& level, const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes,
                    Precision precision = Precision::both);

  /// Other rows, or the same ones with other weights.
  void set_rows(const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes);

  /// Turn of the particle's frame.
  void set_rotation(const Rotation& rotation);
  const Rotation& rotation() const { return rotation_; }

  /// The slopes of the same rows.
  void set_slopes(const std::vector<GapRow>& rows);

  int rows() const { return static_cast<int>(start_.size()) - 1; }
  const InterfaceNodes& nodes() const { return nodes_; }
  /// One for each row of the coupling.
  void set_stiffness(std::shared_ptr<const std::vector<RowStiffness>> stiffness);
  void set_stiffness(std::vector<RowStiffness> stiffness) {
    set_stiffness(std::make_shared<const std::vector<RowStiffness>>(std::move(stiffness)));
  }

  /// y += G^T E G x.
  template <typename Number>
  void apply(const Number* x, Number* y) const;
  void add_diagonal(double* diagonal) const;

  /// One component of G x: one value per row, on every rank.
  std::vector<double> jumps(const double* x, int component) const;
  /// n . G x: by how much gaps open.
  std::vector<double> gaps(const double* x) const;
  /// y += G^T f for forces along one component.
  void add_forces(const std::vector<double>& row_forces, double* y, int component = 2) const;
  /// y += G^T n f for forces along the rows' normals.
  void add_normal_forces(const std::vector<double>& row_forces, double* y) const;
  /// m of a row.
  std::array<double, 2> slope(int row) const {
    return slope_.empty() ? std::array<double, 2>{} : slope_[row];
  }
  /// Visits the entries (interface node, weight) of a row.
  template <typename Visit>
  void for_row(int row, const Visit& visit) const {
    for (int e = start_[row]; e < start_[row + 1]; ++e)
      visit(column_[e], std::get<std::vector<double>>(weights_)[e]);
  }
  /// The rows [first, last) that this rank works on.
  std::pair<int, int> share() const { return {first_row_, last_row_}; }
  const std::vector<int>& active() const { return active_; }

 private:
  /// Turns the particle's values at `nodes` into the substrate's frame, or back.
  template <typename Number>
  void turn(const InterfaceNodes& nodes, std::vector<NodeValue<Number>>& values, bool back) const;
  /// Finds the nodes of the rows that are not open.
  void find_touched();
  /// For apply<float>(): of each touched node.
  void list_rows_of_nodes() const;
  /// E of a row: its force by component of the jump, as columns [N/m].
  template <typename Number>
  std::array<NodeValue<Number>, 3> columns_of(int row) const;
  /// Whether summing up costs less for each product than the rows do.
  bool has_few_nodes() const;
  void sum_up() const;
  /// Fields at interface nodes, and forces of active rows, kept between calls.
  template <typename Number>
  struct Workspace {
    std::vector<NodeValue<Number>> moved, forces, row_forces;
  };
  /// Force of an active row under the jump that `moved` makes, at touched_.
  template <typename Number>
  NodeValue<Number> row_force(int row, const std::vector<NodeValue<Number>>& moved) const;
  /// Forces of all active rows at touched_.
  void find_forces(Workspace<double>& work) const;
  void find_forces(Workspace<float>& work) const;
  void find_summed_forces(Workspace<float>& work) const;

  const MeshLevel& level_;
  Precision precision_;
  InterfaceNodes nodes_;
  Rotation rotation_ = asperity::fem::rotation({});
  bool turned_ = false;
  std::vector<int> start_, column_, active_;
  InterfaceNodes touched_;           ///< nodes of the active rows of all ranks
  std::vector<int> touched_column_;  ///< of active rows: column_ in touched_
  struct RowOfNode {
    int place;  ///< in active_
    float weight;
  };
  mutable std::vector<RowOfNode> touched_row_;  ///< rows of the touched nodes, one after the other
  mutable std::vector<int> touched_start_;      ///< of each its begin there, and the end
  std::shared_ptr<const std::vector<RowStiffness>> stiffness_;
  std::vector<std::array<double, 2>> slope_;  ///< empty: no row is tilted
  /// The same, for both precisions; empty: not needed so far.
  mutable std::tuple<std::vector<double>, std::vector<float>> weights_;
  mutable std::tuple<Workspace<double>, Workspace<float>> workspaces_;
  mutable bool is_summed_up_ = false;
  /// G^T E G of this rank's rows by pair of touched nodes, as columns; empty: rows are cheaper.
  mutable std::vector<std::array<NodeValue<float>, 3>> pairs_;
  int first_row_ = 0, last_row_ = 0;  ///< this rank's share
};

}  // namespace asperity::fem
