#include "fem/mortar/interface_operator.h"

#include <algorithm>
#include <array>
#include <set>
#include <type_traits>
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

InterfaceOperator::InterfaceOperator(const MeshLevel& level, const std::vector<GapRow>& rows,
                                     const InterfaceNodes& fine_nodes)
    : level_(level), nodes_(level), touched_(nodes_.only({})) {
  set_rows(rows, fine_nodes);
}

void InterfaceOperator::set_rows(const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes) {
  const FaceFinder finder(level_.interface_faces());
  start_.assign(1, 0);
  column_.clear();
  std::vector<double> weights;
  std::vector<std::pair<int, double>> merged;
  for (const auto& row : rows) {
    merged.clear();
    for (const auto& [fine_node, weight] : row.entries) {
      const auto& site = fine_nodes.site(fine_node);
      const InterfaceFace& face = finder.at(site);
      const double s = static_cast<double>(site.i - face.i) / face.size,
                   t = static_cast<double>(site.j - face.j) / face.size;
      const double shape[4] = {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
      for (int v = 0; v < 4; ++v) {
        if (shape[v] == 0) continue;
        const int column = nodes_.index(face.node[v]);
        const auto known =
            std::find_if(merged.begin(), merged.end(), [&](const auto& e) { return e.first == column; });
        if (known == merged.end())
          merged.emplace_back(column, weight * shape[v]);
        else
          known->second += weight * shape[v];
      }
    }
    for (const auto& [column, weight] : merged) {
      column_.push_back(column);
      weights.push_back(weight);
    }
    start_.push_back(static_cast<int>(column_.size()));
  }
  auto& weight = std::get<std::vector<double>>(weights_);
  weight = std::move(weights);
  std::get<std::vector<float>>(weights_).assign(weight.begin(), weight.end());
  set_slopes(rows);
  const long count = static_cast<long>(rows.size());
  const long ranks = dealii::Utilities::MPI::n_mpi_processes(level_.communicator());
  const long rank = dealii::Utilities::MPI::this_mpi_process(level_.communicator());
  first_row_ = static_cast<int>(count * rank / ranks);
  last_row_ = static_cast<int>(count * (rank + 1) / ranks);
  set_stiffness(std::vector<RowStiffness>(rows.size()));
}

void InterfaceOperator::set_slopes(const std::vector<GapRow>& rows) {
  is_summed_up_ = false;
  slope_.clear();
  tilted_ = false;
  for (const auto& row : rows) {
    slope_.push_back(row.slope);
    tilted_ = tilted_ || row.slope[0] != 0 || row.slope[1] != 0;
  }
}

void InterfaceOperator::set_stiffness(const std::vector<RowStiffness>& stiffness) {
  active_.clear();
  is_summed_up_ = false;
  stiffness_ = stiffness;
  for (int r = first_row_; r < last_row_; ++r)
    if (!stiffness[r].open()) active_.push_back(r);
  find_touched();
}

void InterfaceOperator::find_touched() {
  constexpr int untouched = -1;
  std::vector<int> place(nodes_.count(), untouched), touched;
  for (int row = 0; row < rows(); ++row)
    if (!stiffness_[row].open())
      for (int e = start_[row]; e < start_[row + 1]; ++e) place[column_[e]] = 0;
  for (int k = 0; k < nodes_.count(); ++k) {
    if (place[k] == untouched) continue;
    place[k] = static_cast<int>(touched.size());
    touched.push_back(k);
  }
  touched_ = nodes_.only(touched);
  touched_column_.resize(column_.size());
  for (const int row : active_)
    for (int e = start_[row]; e < start_[row + 1]; ++e) touched_column_[e] = place[column_[e]];
}

void InterfaceOperator::set_rotation(const Rotation& rotation) {
  rotation_ = rotation;
  turned_ = rotation != asperity::fem::rotation({});
}

template <typename Number>
void InterfaceOperator::turn(const InterfaceNodes& nodes, std::vector<NodeValue<Number>>& values,
                             bool back) const {
  if (!turned_) return;
  NodeValue<Number> column[3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) column[j][i] = static_cast<Number>(back ? rotation_[j][i] : rotation_[i][j]);
  for (int k = 0; k < nodes.count(); ++k)
    if (nodes.site(k).body == 0)
      values[k] = column[0] * values[k][0] + column[1] * values[k][1] + column[2] * values[k][2];
}

template <typename Number>
std::array<NodeValue<Number>, 3> InterfaceOperator::columns_of(int row) const {
  const RowStiffness& k = stiffness_[row];
  const double n[3] = {slope_[row][0], slope_[row][1], 1};
  const double slip[3][3] = {{k.xx, k.xy, 0}, {k.xy, k.yy, 0}, {0, 0, 0}};
  std::array<NodeValue<Number>, 3> columns{};
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c) columns[d][c] = static_cast<Number>(slip[c][d] + k.normal * n[c] * n[d]);
  return columns;
}

bool InterfaceOperator::has_few_nodes() const {
  std::size_t entries = 0;
  for (const int row : active_) entries += static_cast<std::size_t>(start_[row + 1] - start_[row]);
  // A pair of nodes takes three products of vectors, an entry of a row two.
  const auto nodes = static_cast<std::size_t>(touched_.count());
  return 3 * nodes * nodes < 2 * entries;
}

void InterfaceOperator::sum_up() const {
  is_summed_up_ = true;
  pairs_.clear();
  if (!has_few_nodes()) return;
  const int nodes = touched_.count();
  pairs_.assign(static_cast<std::size_t>(nodes) * nodes, {});
  const auto& weight = std::get<std::vector<float>>(weights_);
  for (const int row : active_) {
    const auto columns = columns_of<float>(row);
    for (int e = start_[row]; e < start_[row + 1]; ++e)
      for (int f = start_[row]; f < start_[row + 1]; ++f) {
        auto& pair = pairs_[static_cast<std::size_t>(touched_column_[e]) * nodes + touched_column_[f]];
        for (int d = 0; d < 3; ++d) pair[d] += weight[e] * weight[f] * columns[d];
      }
  }
}

template <typename Number>
void InterfaceOperator::add_row_forces(const std::vector<NodeValue<Number>>& moved,
                                       std::vector<NodeValue<Number>>& forces) const {
  const auto& weight = std::get<std::vector<Number>>(weights_);
  for (const int row : active_) {
    const auto columns = columns_of<Number>(row);
    NodeValue<Number> jump{};
    for (int e = start_[row]; e < start_[row + 1]; ++e) jump += weight[e] * moved[touched_column_[e]];
    const NodeValue<Number> force = columns[0] * jump[0] + columns[1] * jump[1] + columns[2] * jump[2];
    for (int e = start_[row]; e < start_[row + 1]; ++e) forces[touched_column_[e]] += weight[e] * force;
  }
}

void InterfaceOperator::add_summed_forces(const std::vector<NodeValue<float>>& moved,
                                          std::vector<NodeValue<float>>& forces) const {
  const std::size_t nodes = moved.size();
  for (std::size_t a = 0; a < nodes; ++a) {
    const auto* pair = pairs_.data() + a * nodes;
    NodeValue<float> force{};
    for (std::size_t b = 0; b < nodes; ++b)
      force += pair[b][0] * moved[b][0] + pair[b][1] * moved[b][1] + pair[b][2] * moved[b][2];
    forces[a] += force;
  }
}

template <typename Number>
void InterfaceOperator::apply(const Number* x, Number* y) const {
  auto& work = std::get<Workspace<Number>>(workspaces_);
  touched_.gather<Number>(x, work.moved);
  turn<Number>(touched_, work.moved, false);
  work.forces.assign(touched_.count(), NodeValue<Number>{});
  if constexpr (std::is_same_v<Number, float>) {
    if (!is_summed_up_) sum_up();
    if (pairs_.empty())
      add_row_forces<Number>(work.moved, work.forces);
    else
      add_summed_forces(work.moved, work.forces);
  } else {
    add_row_forces<Number>(work.moved, work.forces);
  }
  turn<Number>(touched_, work.forces, true);
  touched_.scatter_add<Number>(work.forces, y);
}

void InterfaceOperator::add_diagonal(double* diagonal) const {
  const auto& weight = std::get<std::vector<double>>(weights_);
  std::vector<NodeValue<double>> result(touched_.count(), NodeValue<double>{});
  for (const int row : active_) {
    const RowStiffness& stiffness = stiffness_[row];
    const double n[3] = {slope_[row][0], slope_[row][1], 1};
    const double slip[3][3] = {{stiffness.xx, stiffness.xy, 0}, {stiffness.xy, stiffness.yy, 0}, {0, 0, 0}};
    double fixed[3],
        turned[3] = {};  // diagonal of the row's stiffness in the frames of the substrate and of the particle
    for (int c = 0; c < 3; ++c) {
      fixed[c] = slip[c][c] + n[c] * n[c] * stiffness.normal;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          turned[c] += rotation_[i][c] * (slip[i][j] + n[i] * n[j] * stiffness.normal) * rotation_[j][c];
    }
    for (int e = start_[row]; e < start_[row + 1]; ++e) {
      const int node = touched_column_[e];
      const double* k = turned_ && touched_.site(node).body == 0 ? turned : fixed;
      for (int c = 0; c < 3; ++c) result[node][c] += k[c] * weight[e] * weight[e];
    }
  }
  touched_.scatter_add<double>(result, diagonal);
}

std::vector<double> InterfaceOperator::jumps(const double* x, int component) const {
  const auto& weight = std::get<std::vector<double>>(weights_);
  auto& moved = std::get<Workspace<double>>(workspaces_).moved;
  nodes_.gather<double>(x, moved);
  turn<double>(nodes_, moved, false);
  std::vector<double> jumps(rows(), 0.0);
  for (int row = 0; row < rows(); ++row)
    for (int e = start_[row]; e < start_[row + 1]; ++e)
      jumps[row] += weight[e] * moved[column_[e]][component];
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
  auto& forces = std::get<Workspace<double>>(workspaces_).forces;
  forces.assign(nodes_.count(), NodeValue<double>{});
  const auto& weight = std::get<std::vector<double>>(weights_);
  for (int row = first_row_; row < last_row_; ++row)
    for (int e = start_[row]; e < start_[row + 1]; ++e)
      forces[column_[e]][component] += weight[e] * row_forces[row];
  turn<double>(nodes_, forces, true);
  nodes_.scatter_add<double>(forces, y);
}

template void InterfaceOperator::apply<double>(const double*, double*) const;
template void InterfaceOperator::apply<float>(const float*, float*) const;

}  // namespace asperity::fem
