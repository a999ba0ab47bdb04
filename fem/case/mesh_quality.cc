#include "fem/case/mesh_quality.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "fem/cells/vtk_order.h"
#include "fem/mortar/interface_operator.h"
#include "meshing/triangles/quality.h"

namespace asperity::fem {
namespace {

/// Places per cell width at which the topography is compared with the facets.
constexpr int samples_per_cell = 4;

/// Mean and mean square of weighted heights.
struct Moments {
  double weight = 0, sum = 0, square = 0;
  void add(double height, double area) {
    weight += area;
    sum += area * height;
    square += area * height * height;
  }
  double rms() const { return weight > 0 ? std::sqrt(square / weight) : 0; }
  /// About the mean.
  double sq() const {
    return weight > 0 ? std::sqrt(std::max(0.0, square / weight - sum * sum / weight / weight)) : 0;
  }
};

/// Calls `visit(slope of the topography, slope of the facet)` for both components at the four Gauss points of
/// a bilinear facet with corner `low`, of this width and these corner heights.
template <typename Visit>
void for_slopes(const meshing::HeightFunction& topography, const std::array<double, 2>& low,
                const std::array<double, 2>& width, const std::array<double, 4>& height, const Visit& visit) {
  constexpr double difference_step =
      1.0 / 64;  // of the cell: central differences that see every wave a mesh is refused for
  const double first = 0.5 - 0.5 / std::sqrt(3.0), second = 1 - first;
  for (const double s : {first, second})
    for (const double t : {first, second}) {
      const double x = low[0] + s * width[0], y = low[1] + t * width[1], ex = difference_step * width[0],
                   ey = difference_step * width[1];
      visit((topography(x + ex, y) - topography(x - ex, y)) / (2 * ex),
            ((1 - t) * (height[1] - height[0]) + t * (height[3] - height[2])) / width[0]);
      visit((topography(x, y + ey) - topography(x, y - ey)) / (2 * ey),
            ((1 - s) * (height[2] - height[0]) + s * (height[3] - height[1])) / width[1]);
    }
}

/// Along x in the body's frame [m].
double middle_of_fine_part(const meshing::ContactMeshOptions& options, int body) {
  const meshing::FinePart part = options.fine_part(static_cast<meshing::Body>(body));
  return 0.5 * (part.low + part.high) + (body == 0 ? 0 : options.sizes.offset_substrate_x);
}

RoughnessFidelity fidelity(const MeshLevel& level, const Vector<double>& positions,
                           const meshing::ContactMeshOptions& options, int body) {
  RoughnessFidelity result;
  const auto& topography = body == 0 ? options.particle_height : options.substrate_height;
  if (!topography) return result;
  const double region = body == 0 ? options.sizes.region_particle : options.sizes.region_substrate;
  const int tree = body == 0 ? meshing::cap : meshing::block;
  const double out_of_material = body == 0 ? -1 : 1;  // sign of z
  const meshing::BodyMap smooth(options.sizes);
  const InterfaceNodes nodes(level);
  const auto z = nodes.gather(positions.begin(), 2);
  const double unit = std::pow(2.0, -lattice_bits), offset_x = middle_of_fine_part(options, body),
               offset_y = body == 0 ? 0 : options.sizes.offset_substrate_y;

  Moments nodal, deviation, sampled, between, slope, missed_slope;
  for (const auto& face : level.interface_faces()) {
    if (face.body != body) continue;
    std::array<meshing::Point3, 4> corner;
    std::array<double, 4> height;
    double reach = 0;
    for (int v = 0; v < 4; ++v) {
      corner[v] = smooth.position(
          tree, {(face.i + (v & 1) * face.size) * unit, (face.j + (v >> 1) * face.size) * unit,
                 meshing::BodyMap::surface_coordinate(tree)});
      height[v] = out_of_material * (z[nodes.index(face.node[v])] - corner[v][2]);
      reach = std::max({reach, std::abs(corner[v][0] - offset_x), std::abs(corner[v][1] - offset_y)});
    }
    if (reach > region * (1 + 1e-9)) continue;
    const double width_x = corner[3][0] - corner[0][0], width_y = corner[3][1] - corner[0][1],
                 area = width_x * width_y;
    for (int v = 0; v < 4; ++v) {
      nodal.add(height[v], area / 4);
      deviation.add(height[v] - topography(corner[v][0], corner[v][1]), area / 4);
    }
    for (int b = 0; b < samples_per_cell; ++b)
      for (int a = 0; a < samples_per_cell; ++a) {
        const double s = (a + 0.5) / samples_per_cell, t = (b + 0.5) / samples_per_cell;
        const double h = topography(corner[0][0] + s * width_x, corner[0][1] + t * width_y);
        const double facet =
            (1 - t) * ((1 - s) * height[0] + s * height[1]) + t * ((1 - s) * height[2] + s * height[3]);
        sampled.add(h, area);
        between.add(facet - h, area);
      }
    const std::array<double, 2> low{corner[0][0], corner[0][1]}, width{width_x, width_y};
    for_slopes(topography, low, width, height, [&](double of_topography, double of_facet) {
      slope.add(of_topography, area);
      missed_slope.add(of_topography - of_facet, area);
    });
  }
  result.sq_topography = sampled.sq();
  result.sq_nodes = nodal.sq();
  result.sq_deviation = deviation.rms();
  result.sq_between = between.rms();
  // Moments are of single components, of which there are two.
  result.rms_slope = std::sqrt(2.0) * slope.rms();
  result.missed_slope = std::sqrt(2.0) * missed_slope.rms();
  return result;
}

}  // namespace

std::vector<double> scaled_jacobians(const MeshLevel& level, const Vector<double>& positions) {
  std::vector<double> result;
  result.reserve(level.batches().size() * lanes);
  const double* x = positions.begin();
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l) {
      std::array<meshing::Point, 8> corners;
      for (int v = 0; v < 8; ++v)
        for (int c = 0; c < 3; ++c) corners[v][c] = x[3 * batch.node[vtk_order[v]][l] + c];
      result.push_back(meshing::scaled_jacobian(corners));
    }
  return result;
}

namespace {

/// Of particle and substrate, the same on every rank.
std::array<double, 2> smallest_scaled_jacobians(const MeshLevel& level, const Vector<double>& positions) {
  std::array<double, 2> smallest{1, 1};
  const auto jacobians = scaled_jacobians(level, positions);
  std::size_t cell = 0;
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l, ++cell)
      smallest[batch.body[l]] = std::min(smallest[batch.body[l]], jacobians[cell]);
  for (double& value : smallest) value = dealii::Utilities::MPI::min(value, level.communicator());
  return smallest;
}

}  // namespace

HexMeshQuality hex_mesh_quality(const MeshLevel& level, const Vector<double>& positions,
                                const meshing::ContactMeshOptions& options) {
  HexMeshQuality quality;
  quality.smallest_scaled_jacobian = smallest_scaled_jacobians(level, positions);
  const auto& found = quality.smallest_scaled_jacobian;
  if (std::min(found[0], found[1]) <= smallest_allowed_scaled_jacobian) {
    meshing::ContactMeshOptions smooth = options;
    smooth.particle_height = smooth.substrate_height = {};
    quality.without_roughness =
        smallest_scaled_jacobians(level, level.node_positions(meshing::RoughGeometry(smooth)));
  }
  for (int body = 0; body < 2; ++body) quality.roughness[body] = fidelity(level, positions, options, body);
  return quality;
}

std::string missed_roughness_text(const RoughnessFidelity& roughness, const std::string& body) {
  if (roughness.missed_slope_share() < worth_saying_of_slopes) return "";
  return body + ": facets miss " + printed("%.0f %%", 100 * roughness.missed_slope_share()) +
         " of the slope variance and " + printed("%.0f %%", 100 * roughness.missed_height_share()) +
         " of Sq: pressures read too small (result.json says by how much)";
}

void require_quality(const HexMeshQuality& quality, const meshing::ContactMeshOptions& options,
                     const std::string& file) {
  for (int body = 0; body < 2; ++body) {
    const std::string name = body == 0 ? "Particle" : "Substrate";
    const double spacing = body == 0 ? options.sizes.spacing_particle : options.sizes.spacing_substrate;
    const double jacobian = quality.smallest_scaled_jacobian[body];
    const RoughnessFidelity& roughness = quality.roughness[body];
    if (!roughness.smooth()) {
      if (roughness.missed_slope_share() > allowed_missed_slopes ||
          roughness.missed_height_share() > allowed_missed_height)
        throw InputError(file + ": " + name + "/Topography: between nodes every " +
                         format_quantity(spacing, Dimension::length) + " the mesh misses " +
                         printed("%.0f %%", 100 * roughness.missed_slope_share()) +
                         " of the topography's slope variance and " +
                         printed("%.0f %%", 100 * roughness.missed_height_share()) + " of its Sq (at most " +
                         printed("%g %%", 100 * allowed_missed_slopes) +
                         " of either is allowed); set Mesh/Interface spacing to a quarter of the "
                         "topography's shortest wave or less, or leave "
                         "out shorter waves with cutoff= in Topography");
      const double ratio_error = std::abs(roughness.sq_ratio() - 1),
                   node_error = roughness.sq_deviation / roughness.sq_topography;
      if (std::max(ratio_error, node_error) > allowed_roughness_error)
        throw InputError(file + ": " + name + "/Topography: the mesh with nodes every " +
                         format_quantity(spacing, Dimension::length) + " has an Sq of " +
                         format_quantity(roughness.sq_nodes, Dimension::length, 4) +
                         " where the topography has " +
                         format_quantity(roughness.sq_topography, Dimension::length, 4) + " (at most " +
                         printed("%g %%", 100 * allowed_roughness_error) +
                         " apart is allowed); set Mesh/Interface spacing to a quarter of the topography's "
                         "shortest wave or less");
    }
    if (jacobian > smallest_allowed_scaled_jacobian) continue;
    const std::string found = " the hexahedra to a scaled Jacobian of " + printed("%.3f", jacobian) +
                              " (more than " + printed("%g", smallest_allowed_scaled_jacobian) +
                              " is needed); ";
    if (roughness.smooth() || quality.without_roughness[body] <= smallest_allowed_scaled_jacobian)
      throw InputError(file + ": " + name +
                       ": the transition from fine cells at the contact to the body's border distorts" +
                       found + "use a shorter Experiment/Distance or another Mesh/Interface spacing");
    throw InputError(
        file + ": " + name + "/Topography: the roughness distorts" + found +
        "its slopes are too steep for a mesh, use a larger cutoff or a smaller rms, or filter the scan");
  }
}

}  // namespace asperity::fem
