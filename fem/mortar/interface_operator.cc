#include "fem/mortar/interface_operator.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/threads.h"
#include "fem/mortar/face_finder.h"

namespace asperity::fem {
namespace {

constexpr int grain_of_rows = 128, grain_of_nodes = 64;  // some microseconds of work

}  // namespace
InterfaceOperator::InterfaceOperator(const MeshLevel& level, const std::vector<GapRow>& rows,
                                     const InterfaceNodes& fine_nodes, Precision precision)
    : level_(level), precision_(precision), nodes_(level), touched_(nodes_.only({})) {
  set_rows(rows, fine_nodes);
}

void InterfaceOperator::set_rows(const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes) {
  constexpr int grain = 64;
  const FaceFinder finder(level_.interface_faces(), nodes_);
  std::vector<FaceFinder::Entries> entries(rows.size());
  for_parts(static_cast<int>(rows.size()), grain, [&](int row, int end) {
    for (; row < end; ++row) entries[row] = finder.entries(rows[row], fine_nodes);
  });
  start_.assign(1, 0);
  for (const auto& row : entries) start_.push_back(start_.back() + static_cast<int>(row.size()));
  column_.clear();
  column_.reserve(start_.back());
  auto& [exact, single] = weights_;
  exact.clear();
  single.clear();
  if (precision_ == Precision::single)
    single.reserve(start_.back());
  else
    exact.reserve(start_.back());
  for (const auto& row : entries)
    for (const auto& [column, weight] : row) {
      column_.push_back(column);
      if (precision_ == Precision::single)
        single.push_back(static_cast<float>(weight));
      else
        exact.push_back(weight);
    }
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
  for (const auto& row : rows)
    if (row.slope[0] != 0 || row.slope[1] != 0) slope_.resize(rows.size());
  for (std::size_t r = 0; r < slope_.size(); ++r) slope_[r] = rows[r].slope;
}

void InterfaceOperator::set_stiffness(std::shared_ptr<const std::vector<RowStiffness>> stiffness) {
  active_.clear();
  is_summed_up_ = false;
  stiffness_ = std::move(stiffness);
  for (int r = first_row_; r < last_row_; ++r)
    if (!(*stiffness_)[r].open()) active_.push_back(r);
  find_touched();
  if (precision_ == Precision::single) sum_up();
}

void InterfaceOperator::find_touched() {
  constexpr int untouched = -1;
  std::vector<int> place(nodes_.count(), untouched), touched;
  for (int row = 0; row < rows(); ++row)
    if (!(*stiffness_)[row].open())
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

void InterfaceOperator::list_rows_of_nodes() const {
  auto& [exact, single] = weights_;
  if (single.empty()) single.assign(exact.begin(), exact.end());
  touched_start_.assign(touched_.count() + 1, 0);
  for (const int row : active_)
    for (int e = start_[row]; e < start_[row + 1]; ++e) ++touched_start_[touched_column_[e] + 1];
  std::partial_sum(touched_start_.begin(), touched_start_.end(), touched_start_.begin());
  touched_row_.resize(touched_start_.back());
  std::vector<int> next(touched_start_.begin(), touched_start_.end() - 1);
  for (std::size_t a = 0; a < active_.size(); ++a)
    for (int e = start_[active_[a]]; e < start_[active_[a] + 1]; ++e)
      touched_row_[next[touched_column_[e]]++] = {static_cast<int>(a), single[e]};
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
  const RowStiffness& k = (*stiffness_)[row];
  const double n[3] = {slope(row)[0], slope(row)[1], 1};
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
  list_rows_of_nodes();
  pairs_.clear();
  if (!has_few_nodes()) return;
  const int nodes = touched_.count();
  pairs_.assign(static_cast<std::size_t>(nodes) * nodes, {});
  const auto& weight = std::get<std::vector<float>>(weights_);
  for_parts(nodes, 1, [&](int node, int end) {
    for (; node < end; ++node) {
      auto* pair = pairs_.data() + static_cast<std::size_t>(node) * nodes;
      for (int k = touched_start_[node]; k < touched_start_[node + 1]; ++k) {
        const int row = active_[touched_row_[k].place];
        const auto columns = columns_of<float>(row);
        for (int f = start_[row]; f < start_[row + 1]; ++f)
          for (int d = 0; d < 3; ++d)
            pair[touched_column_[f]][d] += touched_row_[k].weight * weight[f] * columns[d];
      }
    }
  });
}

template <typename Number>
NodeValue<Number> InterfaceOperator::row_force(int row, const std::vector<NodeValue<Number>>& moved) const {
  const auto& weight = std::get<std::vector<Number>>(weights_);
  const auto columns = columns_of<Number>(row);
  NodeValue<Number> jump{};
  for (int e = start_[row]; e < start_[row + 1]; ++e) jump += weight[e] * moved[touched_column_[e]];
  return columns[0] * jump[0] + columns[1] * jump[1] + columns[2] * jump[2];
}

void InterfaceOperator::find_forces(Workspace<double>& work) const {
  const auto& weight = std::get<std::vector<double>>(weights_);
  work.forces.assign(touched_.count(), NodeValue<double>{});
  for (const int row : active_) {
    const NodeValue<double> force = row_force<double>(row, work.moved);
    for (int e = start_[row]; e < start_[row + 1]; ++e) work.forces[touched_column_[e]] += weight[e] * force;
  }
}

void InterfaceOperator::find_forces(Workspace<float>& work) const {
  if (!is_summed_up_) sum_up();
  if (!pairs_.empty()) return find_summed_forces(work);
  work.forces.resize(touched_.count());
  work.row_forces.resize(active_.size());
  for_parts(static_cast<int>(active_.size()), grain_of_rows, [&](int place, int end) {
    for (; place < end; ++place) work.row_forces[place] = row_force<float>(active_[place], work.moved);
  });
  for_parts(touched_.count(), grain_of_nodes, [&](int node, int end) {
    for (; node < end; ++node) {
      NodeValue<float> force{};
      for (int k = touched_start_[node]; k < touched_start_[node + 1]; ++k)
        force += touched_row_[k].weight * work.row_forces[touched_row_[k].place];
      work.forces[node] = force;
    }
  });
}

void InterfaceOperator::find_summed_forces(Workspace<float>& work) const {
  work.forces.resize(touched_.count());
  const std::size_t nodes = work.moved.size();
  for_parts(touched_.count(), grain_of_nodes, [&](int node, int end) {
    for (; node < end; ++node) {
      const auto* pair = pairs_.data() + static_cast<std::size_t>(node) * nodes;
      NodeValue<float> force{};
      for (std::size_t b = 0; b < nodes; ++b) {
        const NodeValue<float>& moved = work.moved[b];
        force += pair[b][0] * moved[0] + pair[b][1] * moved[1] + pair[b][2] * moved[2];
      }
      work.forces[node] = force;
    }
  });
}

template <typename Number>
void InterfaceOperator::apply(const Number* x, Number* y) const {
  auto& work = std::get<Workspace<Number>>(workspaces_);
  touched_.gather<Number>(x, work.moved);
  turn<Number>(touched_, work.moved, false);
  find_forces(work);
  turn<Number>(touched_, work.forces, true);
  touched_.scatter_add<Number>(work.forces, y);
}

void InterfaceOperator::add_diagonal(double* diagonal) const {
  const auto& [exact, single] = weights_;
  std::vector<NodeValue<double>> result(touched_.count(), NodeValue<double>{});
  for (const int row : active_) {
    const RowStiffness& stiffness = (*stiffness_)[row];
    const double n[3] = {slope(row)[0], slope(row)[1], 1};
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
      const double weight = exact.empty() ? static_cast<double>(single[e]) : exact[e];
      for (int c = 0; c < 3; ++c) result[node][c] += k[c] * weight * weight;
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
  for_parts(rows(), grain_of_rows, [&](int row, int end) {
    for (; row < end; ++row)
      for (int e = start_[row]; e < start_[row + 1]; ++e)
        jumps[row] += weight[e] * moved[column_[e]][component];
  });
  return jumps;
}

std::vector<double> InterfaceOperator::gaps(const double* x) const {
  std::vector<double> gaps = jumps(x, 2);
  if (slope_.empty()) return gaps;
  for (int c = 0; c < 2; ++c) {
    const std::vector<double> slips = jumps(x, c);
    for (std::size_t r = 0; r < gaps.size(); ++r) gaps[r] += slope_[r][c] * slips[r];
  }
  return gaps;
}

void InterfaceOperator::add_normal_forces(const std::vector<double>& row_forces, double* y) const {
  add_forces(row_forces, y);
  if (slope_.empty()) return;
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
