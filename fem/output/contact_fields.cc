#include "fem/output/contact_fields.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "fem/cells/vtk_order.h"
#include "fem/output/vtk_writer.h"

namespace asperity::fem {
namespace {

namespace fs = std::filesystem;

VtkMesh bodies(const ContactSystem& system, const ContactState& state) {
  const MeshLevel& level = system.level();
  VtkMesh mesh;
  const std::size_t nodes =
      (level.partitioner()->locally_owned_size() + level.partitioner()->n_ghost_indices()) / 3;
  Vector<double> shown = state.displacement;  // with the driven plane's common displacement on all its nodes
  shown.update_ghost_values();
  mesh.points.assign(system.positions().begin(), system.positions().begin() + 3 * nodes);
  VtkArray displacement{"displacement", 3, {}};
  displacement.values.assign(shown.begin(), shown.begin() + 3 * nodes);
  const auto states = system.bodies().cell_states(state.displacement);
  VtkArray stress{"stress", 6, {}}, mises{"von_mises", 1, {}}, plastic{"equivalent_plastic_strain", 1, {}},
      body{"body", 1, {}};
  std::size_t cell = 0;
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l, ++cell) {
      for (const int v : vtk_order) mesh.connectivity.push_back(batch.node[v][l]);
      for (const double s : states[cell].stress) stress.values.push_back(static_cast<float>(s));
      mises.values.push_back(static_cast<float>(states[cell].von_mises));
      plastic.values.push_back(static_cast<float>(states[cell].plastic_strain));
      body.values.push_back(batch.body[l]);
    }
  mesh.point_data = {displacement};
  mesh.cell_data = {stress, mises, plastic, body};
  return mesh;
}

VtkMesh contact_surface(const ContactSystem& system, const ContactSolver& solver, const ContactState& state) {
  VtkMesh mesh;
  mesh.points_per_cell = 4;
  const auto& rows = system.rows();
  for (const auto& quad : system.row_quads())
    mesh.connectivity.insert(mesh.connectivity.end(), {quad[0], quad[1], quad[3], quad[2]});
  const auto gaps = solver.gaps(state);
  const auto& options = system.options().mesh;
  VtkArray gap{"gap", 1, {}}, pressure{"pressure", 1, {}}, status{"status", 1, {}},
      upper{"height_particle", 1, {}}, lower{"height_substrate", 1, {}}, shear{"shear_traction", 3, {}};
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto& p = system.interface_points()[rows[r].node];
    const auto& under = system.row_points()[r];
    mesh.points.insert(mesh.points.end(), p.begin(), p.end());
    const bool closed = state.multiplier[r] > 0;
    gap.values.push_back(closed ? 0.0f : static_cast<float>(gaps[r]));
    pressure.values.push_back(static_cast<float>(state.multiplier[r]));
    status.values.push_back(closed ? 1.0f : 0.0f);
    upper.values.push_back(options.particle_height ? static_cast<float>(options.particle_height(p[0], p[1]))
                                                   : 0.0f);
    lower.values.push_back(options.substrate_height ? static_cast<float>(options.substrate_height(
                                                          under[0] + system.coupling().surface().x,
                                                          under[1] + system.coupling().surface().y))
                                                    : 0.0f);
    for (const auto& component : state.shear) shear.values.push_back(static_cast<float>(component[r]));
    shear.values.push_back(0.0f);
  }
  mesh.point_data = {gap, pressure, status, upper, lower, shear};
  const auto remembered = solver.friction() ? solver.friction()->history() : std::vector<std::string>{};
  for (std::size_t k = 0; k < remembered.size(); ++k) {
    mesh.point_data.push_back({remembered[k], 1, {}});
    for (std::size_t r = 0; r < rows.size(); ++r)
      mesh.point_data.back().values.push_back(static_cast<float>(solver.tractions().remembered(state, r, k)));
  }
  return mesh;
}

/// Lists what is in a sub-folder: name_NNNN[_rank].ext by step.
void write_series(const fs::path& folder, const std::string& sub) {
  std::map<int, std::vector<std::string>> by_step;
  for (const auto& entry : fs::directory_iterator(folder / sub)) {
    int step = 0;
    const std::string name = entry.path().filename().string(), extension = entry.path().extension().string();
    if ((extension == ".vtu" || extension == ".vtp") && std::sscanf(name.c_str(), "step_%d", &step) == 1)
      by_step[step].push_back(sub + "/" + name);
  }
  std::vector<std::pair<double, std::vector<std::string>>> files;
  for (auto& [step, names] : by_step) {
    std::sort(names.begin(), names.end());
    files.emplace_back(step, names);
  }
  write_pvd(folder / (sub + ".pvd"), files);
}

}  // namespace

void write_contact_fields(const fs::path& folder, int step, const ContactSystem& system,
                          const ContactSolver& solver, const ContactState& state) {
  const MPI_Comm communicator = system.level().communicator();
  const int rank = dealii::Utilities::MPI::this_mpi_process(communicator),
            ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  char name[32];
  std::snprintf(name, sizeof name, "step_%04d", step);
  const std::string part = ranks == 1 ? "" : "_rank_" + std::to_string(rank);
  if (rank == 0) {
    fs::create_directories(folder / "fields");
    fs::create_directories(folder / "interface");
  }
  MPI_Barrier(communicator);
  write_vtk(folder / "fields" / (name + part + ".vtu"), bodies(system, state));
  const VtkMesh surface = contact_surface(system, solver, state);  // collective
  if (rank == 0) write_vtk(folder / "interface" / (std::string(name) + ".vtp"), surface);
  MPI_Barrier(communicator);
  if (rank != 0) return;
  write_series(folder, "fields");
  write_series(folder, "interface");
}

}  // namespace asperity::fem
