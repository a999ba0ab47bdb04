#include "fem/contact/interface_operator.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <unordered_map>

#include "core/error.h"

namespace asperity::fem {
namespace {

/// Finds the face of a level that holds a lattice site.
class FaceFinder {
 public:
  explicit FaceFinder(const std::vector<InterfaceFace>& faces) : faces_(faces) {
    std::set<int> sizes;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      sizes.insert(faces[f].size);
      by_corner_[key(faces[f].body, faces[f].i, faces[f].j, faces[f].size)] = static_cast<int>(f);
    }
    sizes_.assign(sizes.begin(), sizes.end());
  }
  const InterfaceFace& at(const InterfaceNodes::Site& site) const {
    constexpr int end = 1 << lattice_bits;
    const int i = std::min(site.i, end - 1), j = std::min(site.j, end - 1);
    for (const int size : sizes_) {
      const auto face = by_corner_.find(key(site.body, i & ~(size - 1), j & ~(size - 1), size));
      if (face != by_corner_.end()) return faces_[face->second];
    }
    throw WorkError("an interface node lies on no face of a coarser mesh; this is an error of the program");
  }

 private:
  static std::uint64_t key(int body, int i, int j, int size) {
    int log = 0;
    while ((1 << log) < size) ++log;
    return (((static_cast<std::uint64_t>(body) << 5 | log) << 24 | i) << 24) | j;
  }
  const std::vector<InterfaceFace>& faces_;
  std::unordered_map<std::uint64_t, int> by_corner_;
  std::vector<int> sizes_;
};

}  // namespace

InterfaceNodes::InterfaceNodes(const MeshLevel& level)
    : communicator_(level.communicator()), parallel_(dealii::Utilities::MPI::n_mpi_processes(communicator_) > 1) {
  std::map<long, Site> found;
  for (const auto& face : level.interface_faces())
    for (int v = 0; v < 4; ++v)
      found[face.node[v]] = {face.body, face.i + (v & 1) * face.size, face.j + (v >> 1) * face.size};
  const auto& partitioner = *level.partitioner();
  for (const auto& [node, site] : found) {
    if (partitioner.in_local_range(3 * static_cast<dealii::types::global_dof_index>(node)))
      owned_.emplace_back(static_cast<int>(global_.size()), static_cast<int>(partitioner.global_to_local(3 * node) / 3));
    global_.push_back(node);
    sites_.push_back(site);
  }
}

int InterfaceNodes::index(long global_node) const {
  return static_cast<int>(std::lower_bound(global_.begin(), global_.end(), global_node) - global_.begin());
}

template <typename Number>
std::vector<Number> InterfaceNodes::gather(const Number* local, int component) const {
  std::vector<Number> values(global_.size(), Number(0));
  for (const auto& [index, node] : owned_) values[index] = local[3 * node + component];
  if (parallel_) dealii::Utilities::MPI::sum(values, communicator_, values);
  return values;
}

template <typename Number>
void InterfaceNodes::scatter_add(std::vector<Number>& values, int component, Number* local) const {
  if (parallel_) dealii::Utilities::MPI::sum(values, communicator_, values);
  for (const auto& [index, node] : owned_) local[3 * node + component] += values[index];
}

InterfaceOperator::InterfaceOperator(const MeshLevel& level, const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes)
    : level_(level), nodes_(level) {
  set_rows(rows, fine_nodes);
}

void InterfaceOperator::set_rows(const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes) {
  const FaceFinder finder(level_.interface_faces());
  start_.assign(1, 0);
  column_.clear();
  weight_.clear();
  active_.clear();
  std::vector<std::pair<int, double>> merged;
  for (const auto& row : rows) {
    merged.clear();
    for (const auto& [fine_node, weight] : row.entries) {
      const auto& site = fine_nodes.site(fine_node);
      const InterfaceFace& face = finder.at(site);
      const double s = static_cast<double>(site.i - face.i) / face.size, t = static_cast<double>(site.j - face.j) / face.size;
      const double shape[4] = {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
      for (int v = 0; v < 4; ++v) {
        if (shape[v] == 0) continue;
        const int column = nodes_.index(face.node[v]);
        const auto known = std::find_if(merged.begin(), merged.end(), [&](const auto& e) { return e.first == column; });
        if (known == merged.end()) merged.emplace_back(column, weight * shape[v]);
        else known->second += weight * shape[v];
      }
    }
    for (const auto& [column, weight] : merged) {
      column_.push_back(column);
      weight_.push_back(weight);
    }
    start_.push_back(static_cast<int>(column_.size()));
  }
  set_slopes(rows);
  const long count = static_cast<long>(rows.size());
  const long ranks = dealii::Utilities::MPI::n_mpi_processes(level_.communicator());
  const long rank = dealii::Utilities::MPI::this_mpi_process(level_.communicator());
  first_row_ = static_cast<int>(count * rank / ranks);
  last_row_ = static_cast<int>(count * (rank + 1) / ranks);
  stiffness_.assign(rows.size(), RowStiffness());
}

void InterfaceOperator::set_slopes(const std::vector<GapRow>& rows) {
  slope_.clear();
  tilted_ = false;
  for (const auto& row : rows) {
    slope_.push_back(row.slope);
    tilted_ = tilted_ || row.slope[0] != 0 || row.slope[1] != 0;
  }
}

void InterfaceOperator::set_stiffness(const std::vector<RowStiffness>& stiffness) {
  active_.clear();
  stiffness_ = stiffness;
  resists_slip_ = std::any_of(stiffness.begin(), stiffness.end(), [](const auto& row) { return row.resists_slip(); });
  for (int r = first_row_; r < last_row_; ++r)
    if (!stiffness[r].open()) active_.push_back(r);
}

void InterfaceOperator::set_rotation(const Rotation& rotation) {
  rotation_ = rotation;
  turned_ = rotation != asperity::fem::rotation({});
}

template <typename Number>
std::array<std::vector<Number>, 3> InterfaceOperator::gather_turned(const Number* x, int first) const {
  std::array<std::vector<Number>, 3> values;
  for (int c = turned_ ? 0 : first; c < 3; ++c) values[c] = nodes_.gather(x, c);
  if (!turned_) return values;
  for (int k = 0; k < nodes_.count(); ++k) {
    if (nodes_.site(k).body != 0) continue;
    const Number own[3] = {values[0][k], values[1][k], values[2][k]};
    for (int c = 0; c < 3; ++c)
      values[c][k] = static_cast<Number>(rotation_[c][0]) * own[0] + static_cast<Number>(rotation_[c][1]) * own[1] + static_cast<Number>(rotation_[c][2]) * own[2];
  }
  return values;
}

template <typename Number>
void InterfaceOperator::scatter_turned(std::array<std::vector<Number>, 3>& values, int first, Number* y) const {
  if (turned_) {
    for (auto& component : values) component.resize(nodes_.count(), Number(0));
    for (int k = 0; k < nodes_.count(); ++k) {
      if (nodes_.site(k).body != 0) continue;
      const Number turned[3] = {values[0][k], values[1][k], values[2][k]};
      for (int c = 0; c < 3; ++c)
        values[c][k] = static_cast<Number>(rotation_[0][c]) * turned[0] + static_cast<Number>(rotation_[1][c]) * turned[1] + static_cast<Number>(rotation_[2][c]) * turned[2];
    }
  }
  for (int c = turned_ ? 0 : first; c < 3; ++c)
    if (!values[c].empty()) nodes_.scatter_add(values[c], c, y);
}

template <typename Number>
void InterfaceOperator::apply(const Number* x, Number* y) const {
  const int first = resists_slip_ || tilted_ ? 0 : 2;
  const std::array<std::vector<Number>, 3> values = gather_turned(x, first);
  std::array<std::vector<Number>, 3> result;
  for (int c = first; c < 3; ++c) result[c].assign(nodes_.count(), Number(0));
  for (const int row : active_) {
    const RowStiffness& k = stiffness_[row];
    Number jump[3] = {}, force[3] = {};
    for (int e = start_[row]; e < start_[row + 1]; ++e)
      for (int c = first; c < 3; ++c) jump[c] += static_cast<Number>(weight_[e]) * values[c][column_[e]];
    const Number mx = static_cast<Number>(slope_[row][0]), my = static_cast<Number>(slope_[row][1]);
    force[2] = static_cast<Number>(k.normal) * (jump[2] + mx * jump[0] + my * jump[1]);
    force[0] = static_cast<Number>(k.xx) * jump[0] + static_cast<Number>(k.xy) * jump[1] + mx * force[2];
    force[1] = static_cast<Number>(k.xy) * jump[0] + static_cast<Number>(k.yy) * jump[1] + my * force[2];
    for (int e = start_[row]; e < start_[row + 1]; ++e)
      for (int c = first; c < 3; ++c) result[c][column_[e]] += static_cast<Number>(weight_[e]) * force[c];
  }
  scatter_turned(result, first, y);
}

void InterfaceOperator::add_diagonal(double* diagonal) const {
  std::array<std::vector<double>, 3> result;
  for (auto& component : result) component.assign(nodes_.count(), 0.0);
  for (const int row : active_) {
    const RowStiffness& stiffness = stiffness_[row];
    const double n[3] = {slope_[row][0], slope_[row][1], 1};
    const double slip[3][3] = {{stiffness.xx, stiffness.xy, 0}, {stiffness.xy, stiffness.yy, 0}, {0, 0, 0}};
    double fixed[3], turned[3] = {};  // diagonal of the row's stiffness in the frames of the substrate and of the particle
    for (int c = 0; c < 3; ++c) {
      fixed[c] = slip[c][c] + n[c] * n[c] * stiffness.normal;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) turned[c] += rotation_[i][c] * (slip[i][j] + n[i] * n[j] * stiffness.normal) * rotation_[j][c];
    }
    for (int e = start_[row]; e < start_[row + 1]; ++e) {
      const double* k = turned_ && nodes_.site(column_[e]).body == 0 ? turned : fixed;
      for (int c = 0; c < 3; ++c) result[c][column_[e]] += k[c] * weight_[e] * weight_[e];
    }
  }
  for (int c = resists_slip_ || tilted_ || turned_ ? 0 : 2; c < 3; ++c) nodes_.scatter_add(result[c], c, diagonal);
}

std::vector<double> InterfaceOperator::jumps(const double* x, int component) const {
  const std::vector<double> values = turned_ ? gather_turned(x, 0)[component] : nodes_.gather(x, component);
  std::vector<double> jumps(rows(), 0.0);
  for (int row = 0; row < rows(); ++row)
    for (int e = start_[row]; e < start_[row + 1]; ++e) jumps[row] += weight_[e] * values[column_[e]];
  return jumps;
}

std::vector<double> InterfaceOperator::gaps(const double* x) const {
  std::vector<double> gaps = jumps(x, 2);
  if (!tilted_) return gaps;
  for (int c = 0; c < 2; ++c) {
    const std::vector<double> slips = jumps(x, c);
    for (std::size_t r = 0; r < gaps.size(); ++r) gaps[r] += slope_[r][c] * slips[r];
  }
  return gaps;
}

void InterfaceOperator::add_normal_forces(const std::vector<double>& row_forces, double* y) const {
  add_forces(row_forces, y);
  if (!tilted_) return;
  std::vector<double> sideways(row_forces.size());
  for (int c = 0; c < 2; ++c) {
    for (std::size_t r = 0; r < sideways.size(); ++r) sideways[r] = slope_[r][c] * row_forces[r];
    add_forces(sideways, y, c);
  }
}

void InterfaceOperator::add_forces(const std::vector<double>& row_forces, double* y, int component) const {
  std::array<std::vector<double>, 3> result;
  auto& sum = result[component];
  sum.assign(nodes_.count(), 0.0);
  for (int row = first_row_; row < last_row_; ++row)
    for (int e = start_[row]; e < start_[row + 1]; ++e) sum[column_[e]] += weight_[e] * row_forces[row];
  scatter_turned(result, component, y);
}

template void InterfaceOperator::apply<double>(const double*, double*) const;
template void InterfaceOperator::apply<float>(const float*, float*) const;
template std::vector<double> InterfaceNodes::gather<double>(const double*, int) const;
template std::vector<float> InterfaceNodes::gather<float>(const float*, int) const;
template void InterfaceNodes::scatter_add<double>(std::vector<double>&, int, double*) const;
template void InterfaceNodes::scatter_add<float>(std::vector<float>&, int, float*) const;

}  // namespace asperity::fem
