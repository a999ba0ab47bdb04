// The interface nodes of a mesh level and their values, which are gathered on all ranks.
#pragma once

#include <utility>
#include <vector>

#include "fem/levels/mesh_level.h"

namespace asperity::fem {

/// Three components of a node and one that stays 0, so that the processor takes them at once.
template <typename Number>
struct NodeValueOf {
  typedef Number type __attribute__((vector_size(4 * sizeof(Number))));
};
template <typename Number>
using NodeValue = typename NodeValueOf<Number>::type;

/// The interface nodes of one level, the same list on every rank, and where this rank keeps its own.
class InterfaceNodes {
 public:
  explicit InterfaceNodes(const MeshLevel& level);
  /// Some of them, by rising index; the same on every rank.
  InterfaceNodes only(const std::vector<int>& indices) const;
  int count() const { return static_cast<int>(global_.size()); }
  /// Index of a global node.
  int index(long global_node) const;
  /// Global node of an index.
  long global_node(int index) const { return global_[index]; }
  /// Lattice position of a node: body and coordinates in units of 2^-lattice_bits.
  struct Site {
    int body, i, j;
  };
  const Site& site(int node) const { return sites_[node]; }
  /// Values of one component at all interface nodes, from all ranks.
  std::vector<double> gather(const double* local, int component) const;
  /// The three components at all interface nodes, from all ranks.
  template <typename Number>
  void gather(const Number* local, std::vector<NodeValue<Number>>& values) const;
  /// Sums contributions of all ranks and adds each to the local vector of the node's owner.
  template <typename Number>
  void scatter_add(std::vector<NodeValue<Number>>& values, Number* local) const;

 private:
  template <typename Number>
  void sum_over_ranks(std::vector<NodeValue<Number>>& values) const;

  InterfaceNodes(MPI_Comm communicator, bool parallel) : communicator_(communicator), parallel_(parallel) {}

  MPI_Comm communicator_;
  bool parallel_;
  std::vector<long> global_;
  std::vector<Site> sites_;
  std::vector<std::pair<int, int>> owned_;  ///< index in the list, local node
};

}  // namespace asperity::fem
