// A state of the contact as another mesh of the same lattice takes it over: displacement, history of the
// bodies, tractions.
//
// Both meshes are cut from one lattice of the same map, so that a node of both is the same material point.
// Cells that both have keep all they had; a cell that is refined gives its parts its displacement, trilinear,
// and each of them the history of the point of integration in its octant; parts that become one keep the
// displacement of its corners and the mean of their history.
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "fem/contact/contact_state.h"
#include "fem/contact/contact_system.h"
#include "fem/contact/steady_prediction.h"

namespace asperity::fem {

class CarriedState {
 public:
  /// Of the accepted `state` and what is remembered of the path to it. Collective: every rank has all of it.
  CarriedState(const ContactSystem& system, const ContactState& state, const PathMemory& path);

  /// The cells that have yielded.
  std::shared_ptr<const meshing::KeptCells> yielded() const;

  /// What one mesh makes of it. state: of that mesh, without displacement; rows that it had not start anew.
  struct Taken {
    ContactState state;
    PathMemory path;
  };
  /// Gives the history to the bodies of `system`. Collective.
  Taken taken_by(ContactSystem& system, const ContactState& untouched) const;

 private:
  static constexpr int fields = 2;  ///< displacement of the state, and of that before the last step
  using Corner = std::array<double, 3>;
  struct Cell {
    std::array<std::array<Corner, fields>, vertices_per_hex> corner{};  ///< displacements [m]
    std::optional<PlasticBodies::CellHistory> history;
  };

  void collect(const ContactSystem& system, const std::array<const Vector<double>*, fields>& displacement);
  void share(MPI_Comm communicator);
  /// The cell, or the whole that it is a part of; null where parts of it are all there is.
  const Cell* find(meshing::LogicalBox& box) const;
  std::array<Corner, fields> at_corner(const meshing::LogicalBox& box, int vertex) const;
  std::optional<PlasticBodies::CellHistory> history_of(const meshing::LogicalBox& box) const;
  std::vector<int> rows_in(const ContactSystem& system) const;

  std::unordered_map<meshing::CellKey, Cell> cells_;
  std::vector<meshing::LogicalBox> yielded_;
  std::unordered_map<long, int> row_at_;  ///< by place of its node in the lattice
  InterfaceState interface_;
  PathMemory path_;
  double approach_error_ = 0;  ///< of the bodies [m]
};

}  // namespace asperity::fem
