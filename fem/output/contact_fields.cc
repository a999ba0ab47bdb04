#include "fem/output/contact_fields.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "core/atomic_file.h"
#include "fem/cells/vtk_order.h"
#include "fem/output/field.h"
#include "fem/output/paraview_script.h"
#include "fem/output/vtk_writer.h"

namespace asperity::fem {
namespace {

namespace fs = std::filesystem;

/// Those of `fields` that belong there.
void add_fields(const std::vector<Field>& fields, FieldPlace place, const ShownState& shown,
                std::vector<VtkArray>& arrays) {
  for (const auto& field : fields) {
    if (field.place != place) continue;
    const auto values = field.values(shown);
    arrays.push_back({field.name, field.components, {values.begin(), values.end()}, field.unit});
  }
}

/// Plastic strain at nodes, the mean of the cells around each: for contours and smooth colours. Collective.
std::vector<float> plastic_strain_at_nodes(const ShownState& shown) {
  const MeshLevel& level = shown.system.level();
  Vector<double> sum;  // x: of strains, y: of cells
  level.initialise(sum);
  auto cell = shown.cells.begin();
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l, ++cell)
      for (const auto& node : batch.node) {
        double* of_node = sum.begin() + 3 * static_cast<std::ptrdiff_t>(node[l]);
        of_node[0] += cell->plastic_strain;
        of_node[1] += 1;
      }
  sum.compress(dealii::VectorOperation::add);
  sum.update_ghost_values();
  const std::size_t nodes =
      (level.partitioner()->locally_owned_size() + level.partitioner()->n_ghost_indices()) / 3;
  std::vector<float> strain;
  for (std::size_t n = 0; n < nodes; ++n)
    strain.push_back(static_cast<float>(sum.begin()[3 * n] / std::max(1.0, sum.begin()[3 * n + 1])));
  return strain;
}

/// Where nodes are seen from the substrate, less where they were in their body's frame: displacement, and
/// what the particle has moved and turned.
std::vector<float> motion_of_nodes(const ShownState& shown, const std::vector<double>& points,
                                   const std::vector<float>& displacement) {
  const RigidMotion& frames = shown.state.coupling.frames;
  const Rotation turn = rotation(frames);
  const double radius = shown.system.options().mesh.sizes.radius;
  std::vector<float> motion = displacement;
  for (const auto& batch : shown.system.level().batches())
    for (int l = 0; l < batch.count; ++l) {
      if (batch.body[l] != 0) continue;
      for (const auto& nodes : batch.node) {
        const std::size_t at = 3 * static_cast<std::size_t>(nodes[l]);
        const std::array<double, 3> shift{frames.x, frames.y, 0};
        const auto place = turned(turn,
                                  {points[at] + displacement[at], points[at + 1] + displacement[at + 1],
                                   points[at + 2] + displacement[at + 2]},
                                  radius);
        for (int c = 0; c < 3; ++c) motion[at + c] = static_cast<float>(place[c] + shift[c] - points[at + c]);
      }
    }
  return motion;
}

VtkMesh bodies(const ShownState& shown) {
  const MeshLevel& level = shown.system.level();
  const auto& positions = shown.system.positions();
  VtkMesh mesh;
  const std::size_t nodes =
      (level.partitioner()->locally_owned_size() + level.partitioner()->n_ghost_indices()) / 3;
  Vector<double> moved = shown.state.displacement;  // the driven plane's common displacement on all its nodes
  moved.update_ghost_values();
  mesh.points.assign(positions.begin(), positions.begin() + 3 * nodes);
  mesh.point_data.push_back({"displacement", 3, {moved.begin(), moved.begin() + 3 * nodes}, "m"});
  mesh.point_data.push_back(
      {"motion", 3, motion_of_nodes(shown, mesh.points, mesh.point_data[0].values), "m"});
  mesh.point_data.push_back({"plastic_strain_at_nodes", 1, plastic_strain_at_nodes(shown)});
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l)
      for (const int v : vtk_order) mesh.connectivity.push_back(batch.node[v][l]);
  for (const auto* fields : {&shipped_fields(), &added_fields()})
    add_fields(*fields, FieldPlace::bodies, shown, mesh.cell_data);
  return mesh;
}

VtkMesh contact_surface(const ShownState& shown) {
  const ContactSystem& system = shown.system;
  VtkMesh mesh;
  mesh.points_per_cell = 4;
  for (const auto& quad : system.row_quads())
    mesh.connectivity.insert(mesh.connectivity.end(), {quad[0], quad[1], quad[3], quad[2]});
  const RigidMotion shift = system.coupling().surface();
  for (const auto& place : system.row_points())
    mesh.points.insert(mesh.points.end(), {place[0] + shift.x, place[1] + shift.y, place[2]});
  add_fields(shipped_fields(), FieldPlace::contact, shown, mesh.point_data);
  const FrictionLaw* friction = shown.solver.friction();
  const auto remembered = friction ? friction->history() : std::vector<std::string>{};
  for (std::size_t k = 0; k < remembered.size(); ++k) {
    mesh.point_data.push_back({remembered[k], 1, {}});
    for (std::size_t r = 0; r < system.rows().size(); ++r)
      mesh.point_data.back().values.push_back(
          static_cast<float>(shown.solver.tractions().remembered(shown.state, r, k)));
  }
  add_fields(added_fields(), FieldPlace::contact, shown, mesh.point_data);
  return mesh;
}

/// Lists what is in a sub-folder: name_NNNN[_rank].ext by the time of its step.
void write_series(const fs::path& folder, const std::string& sub, const Frames& frames) {
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
    const auto index = static_cast<std::size_t>(step - 1);
    files.emplace_back(index < frames.time.size() ? frames.time[index] : step, names);
  }
  write_pvd(folder / (sub + ".pvd"), files);
}

VtkNotes notes_of(const FrameNotes& notes, const Frames& frames, const RigidMotion& motion) {
  const auto index = static_cast<std::size_t>(notes.step - 1);
  return {{{"TimeValue", frames.time[index]},
           {"step", notes.step},
           {"load [N]", notes.load},
           {"path length [m]", frames.path_length[index]},
           {"axis x [m]", motion.x},
           {"axis y [m]", motion.y}},
          {{"title", notes.title}, {"time", frames.time_text()}}};
}

}  // namespace

void write_contact_fields(const fs::path& folder, const FrameNotes& notes, const Frames& frames,
                          const ContactSystem& system, const ContactSolver& solver,
                          const ContactState& state) {
  const MPI_Comm communicator = system.level().communicator();
  const int rank = dealii::Utilities::MPI::this_mpi_process(communicator),
            ranks = dealii::Utilities::MPI::n_mpi_processes(communicator);
  char name[32];
  std::snprintf(name, sizeof name, "step_%04d", notes.step);
  const std::string part = ranks == 1 ? "" : "_rank_" + std::to_string(rank);
  if (rank == 0) {
    fs::create_directories(folder / "fields");
    fs::create_directories(folder / "interface");
  }
  MPI_Barrier(communicator);
  const ShownState shown{system, solver, state, solver.gaps(state),
                         system.bodies().cell_states(state.displacement)};
  VtkMesh volume = bodies(shown), surface = contact_surface(shown);  // collective
  volume.notes = surface.notes = notes_of(notes, frames, state.motion);
  write_vtk(folder / "fields" / (name + part + ".vtu"), volume);
  if (rank == 0) write_vtk(folder / "interface" / (std::string(name) + ".vtp"), surface);
  MPI_Barrier(communicator);
  if (rank != 0) return;
  write_series(folder, "fields", frames);
  write_series(folder, "interface", frames);
  write_file_atomically(folder / "show_in_paraview.py", paraview_script(folder));
}

}  // namespace asperity::fem
