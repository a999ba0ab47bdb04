#include "fem/mortar/interface_nodes.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>

namespace asperity::fem {

InterfaceNodes::InterfaceNodes(const MeshLevel& level)
    : communicator_(level.communicator()),
      parallel_(dealii::Utilities::MPI::n_mpi_processes(communicator_) > 1) {
  std::map<long, Site> found;
  for (const auto& face : level.interface_faces())
    for (int v = 0; v < 4; ++v)
      found[face.node[v]] = {face.body, face.i + (v & 1) * face.size, face.j + (v >> 1) * face.size};
  const auto& partitioner = *level.partitioner();
  for (const auto& [node, site] : found) {
    if (partitioner.in_local_range(3 * static_cast<dealii::types::global_dof_index>(node)))
      owned_.emplace_back(static_cast<int>(global_.size()),
                          static_cast<int>(partitioner.global_to_local(3 * node) / 3));
    global_.push_back(node);
    sites_.push_back(site);
  }
}

InterfaceNodes InterfaceNodes::only(const std::vector<int>& indices) const {
  InterfaceNodes some(communicator_, parallel_);
  auto owned = owned_.begin();
  for (const int index : indices) {
    while (owned != owned_.end() && owned->first < index) ++owned;
    if (owned != owned_.end() && owned->first == index) some.owned_.emplace_back(some.count(), owned->second);
    some.global_.push_back(global_[index]);
    some.sites_.push_back(sites_[index]);
  }
  return some;
}

int InterfaceNodes::index(long global_node) const {
  return static_cast<int>(std::lower_bound(global_.begin(), global_.end(), global_node) - global_.begin());
}

std::vector<double> InterfaceNodes::gather(const double* local, int component) const {
  std::vector<double> values(global_.size(), 0.0);
  for (const auto& [index, node] : owned_) values[index] = local[3 * node + component];
  if (parallel_) dealii::Utilities::MPI::sum(values, communicator_, values);
  return values;
}

template <typename Number>
void InterfaceNodes::gather(const Number* local, std::vector<NodeValue<Number>>& values) const {
  values.assign(global_.size(), NodeValue<Number>{});
  for (const auto& [index, node] : owned_) {
    const Number* own = local + 3 * static_cast<std::ptrdiff_t>(node);
    values[index] = NodeValue<Number>{own[0], own[1], own[2], 0};
  }
  sum_over_ranks<Number>(values);
}

template <typename Number>
void InterfaceNodes::scatter_add(std::vector<NodeValue<Number>>& values, Number* local) const {
  sum_over_ranks<Number>(values);
  for (const auto& [index, node] : owned_)
    for (int c = 0; c < 3; ++c) local[3 * static_cast<std::ptrdiff_t>(node) + c] += values[index][c];
}

template <typename Number>
void InterfaceNodes::sum_over_ranks(std::vector<NodeValue<Number>>& values) const {
  if (!parallel_ || values.empty()) return;
  auto* numbers = reinterpret_cast<Number*>(values.data());
  const std::size_t count = 4 * values.size();
  dealii::Utilities::MPI::sum(dealii::ArrayView<const Number>(numbers, count), communicator_,
                              dealii::ArrayView<Number>(numbers, count));
}

template void InterfaceNodes::gather<double>(const double*, std::vector<NodeValue<double>>&) const;
template void InterfaceNodes::gather<float>(const float*, std::vector<NodeValue<float>>&) const;
template void InterfaceNodes::scatter_add<double>(std::vector<NodeValue<double>>&, double*) const;
template void InterfaceNodes::scatter_add<float>(std::vector<NodeValue<float>>&, float*) const;

}  // namespace asperity::fem
