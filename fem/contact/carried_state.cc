#include "fem/contact/carried_state.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria_accessor.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace asperity::fem {
namespace {

using meshing::LogicalBox;
using meshing::part_of;

/// Place of a row's node in the lattice of the particle's surface.
long place_of(const InterfaceNodes::Site& site) {
  return static_cast<long>(site.j) << (lattice_bits + 1) | static_cast<long>(site.i);
}

/// Vectors of the layout of `like` from what a rank owns of them; zero where nothing is given.
Vector<double> with_ghosts(const std::vector<double>& owned, const Vector<double>& like) {
  Vector<double> full = like;
  full.zero_out_ghost_values();
  full = 0;
  std::copy(owned.begin(), owned.end(), full.begin());
  full.update_ghost_values();
  return full;
}

template <typename Visit>
void for_owned_cells(const ContactSystem& system, const Visit& visit) {
  for (const auto& cell : system.level().dofs().active_cell_iterators())
    if (cell->is_locally_owned()) {
      const auto [batch, lane] = system.level().place_of(cell->active_cell_index());
      visit(meshing::logical_box(cell), batch, lane);
    }
}

/// A list with `width` entries of each row on a mesh whose rows were `rows` before, -1: these get those of
/// `anew`. Nothing where the list has none.
template <typename Value>
std::vector<Value> moved(const std::vector<Value>& list, const std::vector<int>& rows, std::size_t width,
                         const std::vector<Value>& anew) {
  if (list.empty()) return list;
  std::vector<Value> result = anew;
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r] >= 0) std::copy_n(list.begin() + rows[r] * width, width, result.begin() + r * width);
  return result;
}

}  // namespace

CarriedState::CarriedState(const ContactSystem& system, const ContactState& state, const PathMemory& path)
    : interface_(state), path_(path), approach_error_(system.bodies().approach_error()) {
  const InterfaceNodes nodes(system.level());
  for (std::size_t r = 0; r < system.rows().size(); ++r)
    row_at_[place_of(nodes.site(system.rows()[r].node))] = static_cast<int>(r);
  const Vector<double> before = with_ghosts(path.displacement, state.displacement);
  collect(system, {&state.displacement, &before});
  share(system.level().communicator());
  path_.displacement.clear();
}

void CarriedState::collect(const ContactSystem& system,
                           const std::array<const Vector<double>*, fields>& displacement) {
  for_owned_cells(system, [&](const LogicalBox& box, int batch, int lane) {
    Cell& cell = cells_[meshing::cell_key(box)];
    for (int v = 0; v < vertices_per_hex; ++v)
      for (int f = 0; f < fields; ++f)
        for (int c = 0; c < 3; ++c)
          cell.corner[v][f][c] =
              displacement[f]->begin()[3 * system.level().batches()[batch].node[v][lane] + c];
    cell.history = system.bodies().history_of_cell(batch, lane);
    if (cell.history) yielded_.push_back(box);
  });
}

void CarriedState::share(MPI_Comm communicator) {
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1) return;
  std::vector<std::pair<meshing::CellKey, std::vector<double>>> own;
  for (const auto& [key, cell] : cells_) {
    auto& numbers = own.emplace_back(key, std::vector<double>()).second;
    for (const auto& corner : cell.corner)
      for (const auto& field : corner) numbers.insert(numbers.end(), field.begin(), field.end());
    if (cell.history)
      for (const auto& point : *cell.history) numbers.insert(numbers.end(), point.begin(), point.end());
  }
  for (const auto& part : dealii::Utilities::MPI::all_gather(communicator, own))
    for (const auto& [key, numbers] : part) {
      Cell& cell = cells_[key];
      auto next = numbers.begin();
      for (auto& corner : cell.corner)
        for (auto& field : corner)
          for (double& value : field) value = *next++;
      if (next == numbers.end()) continue;
      auto& history = cell.history.emplace();
      for (auto& point : history)
        for (double& value : point) value = *next++;
    }
  std::vector<std::vector<double>> boxes;
  for (const auto& box : yielded_)
    boxes.push_back({static_cast<double>(box.tree), box.corner[0], box.corner[1], box.corner[2], box.size});
  yielded_.clear();
  for (const auto& part : dealii::Utilities::MPI::all_gather(communicator, boxes))
    for (const auto& box : part)
      yielded_.push_back({static_cast<int>(box[0]), {box[1], box[2], box[3]}, box[4]});
}

std::shared_ptr<const meshing::KeptCells> CarriedState::yielded() const {
  return yielded_.empty() ? nullptr : std::make_shared<meshing::KeptCells>(yielded_);
}

const CarriedState::Cell* CarriedState::find(LogicalBox& box) const {
  for (LogicalBox whole = box;; whole = meshing::parent_of(whole)) {
    const auto found = cells_.find(meshing::cell_key(whole));
    if (found != cells_.end()) {
      box = whole;
      return &found->second;
    }
    if (whole.size >= 1) return nullptr;
  }
}

std::array<CarriedState::Corner, CarriedState::fields> CarriedState::at_corner(const LogicalBox& box,
                                                                               int vertex) const {
  LogicalBox whole = box;
  if (const Cell* cell = find(whole)) {
    const auto weights = meshing::corner_weights(whole, box.vertex(vertex));
    std::array<Corner, fields> value{};
    for (int v = 0; v < vertices_per_hex; ++v)
      for (int f = 0; f < fields; ++f)
        for (int c = 0; c < 3; ++c) value[f][c] += weights[v] * cell->corner[v][f][c];
    return value;
  }
  // Parts of it were all there was: the one in this corner has the node.
  constexpr double smallest = 1e-6;  // of a tree, below all meshes
  for (LogicalBox part = part_of(box, vertex); part.size > smallest; part = part_of(part, vertex)) {
    const auto found = cells_.find(meshing::cell_key(part));
    if (found != cells_.end()) return found->second.corner[vertex];
  }
  throw WorkError("a cell has no counterpart on the mesh before; this is an error of the program");
}

std::optional<PlasticBodies::CellHistory> CarriedState::history_of(const LogicalBox& box) const {
  LogicalBox whole = box;
  if (const Cell* cell = find(whole)) {
    if (!cell->history || whole.size == box.size) return cell->history;
    int octant = 0;
    const meshing::Point3 centre = box.centre();
    for (int d = 0; d < 3; ++d)
      if (centre[d] > whole.corner[d] + 0.5 * whole.size) octant |= 1 << d;
    PlasticBodies::CellHistory taken;
    taken.fill((*cell->history)[octant]);
    return taken;
  }
  // Each point of integration stands for an octant, whose parts it averages.
  std::optional<PlasticBodies::CellHistory> taken;
  for (int octant = 0; octant < 8; ++octant) {
    const auto part = history_of(part_of(box, octant));
    if (!part) continue;
    if (!taken) taken.emplace();
    for (const auto& point : *part)
      for (int n = 0; n < PlasticBodies::numbers_of_point; ++n)
        (*taken)[octant][n] += point[n] / points_per_hex;
  }
  return taken;
}

std::vector<int> CarriedState::rows_in(const ContactSystem& system) const {
  std::vector<int> rows;
  const InterfaceNodes nodes(system.level());
  for (const auto& row : system.rows()) {
    const auto found = row_at_.find(place_of(nodes.site(row.node)));
    rows.push_back(found == row_at_.end() ? -1 : found->second);
  }
  return rows;
}

CarriedState::Taken CarriedState::taken_by(ContactSystem& system, const ContactState& untouched) const {
  Taken taken{untouched, path_};
  ContactState& state = taken.state;
  static_cast<InterfaceState&>(state) = interface_;
  const std::vector<int> rows = rows_in(system);
  const std::vector<double> zeros(rows.size(), 0.0);
  state.multiplier = moved(interface_.multiplier, rows, 1, zeros);
  state.bonded = moved(interface_.bonded, rows, 1, untouched.bonded);
  state.friction_history =
      moved(interface_.friction_history, rows,
            interface_.friction_history.size() / std::max<std::size_t>(1, interface_.multiplier.size()),
            untouched.friction_history);
  taken.path.multiplier = moved(path_.multiplier, rows, 1, zeros);
  for (int c = 0; c < 2; ++c) {
    state.shear[c] = moved(interface_.shear[c], rows, 1, zeros);
    taken.path.shear[c] = moved(path_.shear[c], rows, 1, zeros);
  }
  state.displacement.zero_out_ghost_values();
  Vector<double> before = state.displacement;
  const std::array<Vector<double>*, fields> displacement{&state.displacement, &before};
  const int owned = static_cast<int>(before.locally_owned_size());
  for_owned_cells(system, [&](const LogicalBox& box, int batch, int lane) {
    for (int v = 0; v < vertices_per_hex; ++v) {
      const int dof = 3 * system.level().batches()[batch].node[v][lane];
      if (dof >= owned) continue;
      const auto values = at_corner(box, v);
      for (int f = 0; f < fields; ++f)
        for (int c = 0; c < 3; ++c) displacement[f]->begin()[dof + c] = values[f][c];
    }
    if (const auto history = history_of(box)) system.bodies().take_history_of_cell(batch, lane, *history);
  });
  system.bodies().take_approach_error(approach_error_);
  state.displacement.update_ghost_values();
  if (!path_.multiplier.empty()) taken.path.displacement.assign(before.begin(), before.begin() + owned);
  return taken;
}

}  // namespace asperity::fem
