#include "fem/mesh_case.h"

#include <cmath>
#include <sstream>

#include "core/error.h"
#include "core/output_folder.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "fem/case/case_setup.h"
#include "fem/case/derived_spacing.h"
#include "fem/case/mesh_quality.h"
#include "fem/case/solve_cost.h"
#include "fem/cells/vtk_order.h"
#include "fem/levels/boundary_surface.h"
#include "fem/output/vtk_writer.h"
#include "meshing/triangles/export.h"

namespace asperity {
namespace {

using namespace fem;
namespace fs = std::filesystem;
using Say = std::function<void(const std::string&)>;

const char* const body_name[2] = {"particle", "substrate"};

std::string length(double metres, int digits = 3) {
  return format_quantity(metres, Dimension::length, digits);
}

/// One call for each line of a text.
void say_lines(const Say& say, const std::string& lines) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) say(line);
}

double smooth_volume(const meshing::BodySizes& sizes, int body) {
  return body == 0 ? (sizes.full_sphere ? 4.0 : 2.0) / 3 * M_PI * std::pow(sizes.radius, 3)
                   : std::pow(2 * sizes.block_half_width, 3);
}

void say_counts(const Say& say, const meshing::ContactMeshOptions& options, const MeshLevel& level,
                const meshing::BodyMap& map) {
  const auto& sizes = options.sizes;
  std::array<long, 2> cells{}, faces{};
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l) ++cells[batch.body[l]];
  for (const auto& face : level.interface_faces()) ++faces[face.body];
  for (int body = 0; body < 2; ++body)
    say(std::string(body_name[body]) + ": " + std::to_string(cells[body]) + " hexahedra, " +
        std::to_string(faces[body]) + " faces on its interface, nodes every " +
        length(body == 0 ? sizes.spacing_particle : sizes.spacing_substrate) + " within ±" +
        length(body == 0 ? sizes.region_particle : sizes.region_substrate) + " of the axis, " +
        std::to_string(map.finest_level(static_cast<meshing::Body>(body))) + " levels of refinement");
  say("both: " + std::to_string(level.size()) + " unknowns; to solve them takes about " +
      printed("%.2g GiB", estimated_memory(static_cast<double>(level.size())) / (1 << 30)) + " of memory");
}

void say_quality(const Say& say, const HexMeshQuality& quality) {
  for (int body = 0; body < 2; ++body) {
    const std::string name = body_name[body];
    say(name + ": smallest scaled Jacobian " + printed("%.3f", quality.smallest_scaled_jacobian[body]));
    const RoughnessFidelity& roughness = quality.roughness[body];
    if (roughness.smooth()) continue;
    say(name + ": Sq of the nodes " + length(roughness.sq_nodes, 4) + ", of the topography there " +
        length(roughness.sq_topography, 4) + printed(" (%+.2f %%)", 100 * (roughness.sq_ratio() - 1)) +
        "; facets depart from it by " + length(roughness.sq_between) +
        printed(" rms (%.2g %%)", 100 * roughness.missed_height_share()) +
        printed(" and miss %.2g %% of its slope variance", 100 * roughness.missed_slope_share()));
  }
}

void write_hexahedra(const fs::path& path, const MeshLevel& level, const Vector<double>& positions) {
  VtkMesh mesh;
  mesh.points.assign(positions.begin(), positions.begin() + level.partitioner()->locally_owned_size());
  VtkArray body{"body", 1, {}}, jacobian{"scaled_jacobian", 1, {}};
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l) {
      for (const int v : vtk_order) mesh.connectivity.push_back(batch.node[v][l]);
      body.values.push_back(batch.body[l]);
    }
  const auto jacobians = scaled_jacobians(level, positions);
  jacobian.values.assign(jacobians.begin(), jacobians.end());
  mesh.cell_data = {body, jacobian};
  write_vtk(path, mesh);
}

/// Tetrahedra as fine as the interface in the potential contact zone.
meshing::TetrahedraOptions tetrahedra_options(const meshing::BodySizes& sizes, int body) {
  meshing::TetrahedraOptions options;
  options.fine_radius = body == 0 ? sizes.region_particle : sizes.region_substrate;
  options.fine_size = body == 0 ? sizes.spacing_particle : sizes.spacing_substrate;
  return options;
}

}  // namespace

void mesh_case(const CaseInput& input, const fs::path& output, const Say& say) {
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    throw InputError("meshes are written by one process; start asperity mesh without mpirun");
  const CaseSetup setup = set_up(with_derived_path_length(input));
  const meshing::ContactMeshOptions& options = setup.system.mesh;
  const meshing::RoughGeometry geometry(options);
  const auto forest = meshing::make_forest(MPI_COMM_WORLD, options);
  const MeshLevel level(*forest, setup.system.control);
  const Vector<double> positions = level.node_positions(geometry);

  say_counts(say, options, level, geometry.map());
  const HexMeshQuality quality = hex_mesh_quality(level, positions, options);
  for (const std::string& text : resolution_texts(setup)) say(text);
  say_quality(say, quality);
  require_quality(quality, options, input.file);

  make_folder(output);
  write_hexahedra(output / "hexahedra.vtu", level, positions);
  for (int body = 0; body < 2; ++body) {
    const std::string name = body_name[body];
    const auto surface = boundary_surface(level, positions, static_cast<meshing::Body>(body));
    const auto check = meshing::check_surface(surface);
    say_lines(say, meshing::summary(name, surface, check));
    say(name +
        printed(" surface: its volume is %.2f %%", 100 * check.volume / smooth_volume(options.sizes, body)) +
        " of the smooth " +
        (body == 1                   ? "block's"
         : options.sizes.full_sphere ? "sphere's"
                                     : "hemisphere's"));
    meshing::require_body(check, "the " + name);
    for (const char* extension : {".stl", ".ply", ".off"})
      meshing::write_surface(surface, output / (name + extension));

    const auto tetrahedra = meshing::tetrahedra(surface, tetrahedra_options(options.sizes, body));
    say_lines(say, meshing::summary(name, tetrahedra, meshing::quality(tetrahedra), check.volume));
    meshing::write_tetrahedra(tetrahedra, output / (name + "_tetrahedra.vtu"), meshing::LengthUnit::metre);
    meshing::write_tetrahedra(tetrahedra, output / (name + "_tetrahedra.msh"));
  }
  say("written to " + output.string() +
      ": hexahedra.vtu, *_tetrahedra.vtu (coordinates in m), and in um *_tetrahedra.msh and the "
      "surfaces as .stl, .ply, .off");
}

}  // namespace asperity
