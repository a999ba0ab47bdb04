#include "meshing/triangles/tetrahedra.h"

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <unordered_map>

#include "core/error.h"
#include "meshing/triangles/cgal_failure.h"
#include "meshing/triangles/cgal_mesh.h"
#include "meshing/triangles/quality.h"
#include "meshing/triangles/surface_check.h"
#include "meshing/triangles/vectors.h"

namespace asperity::meshing {

namespace {

using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, CgalMesh>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Sequential_tag>::type;
using Complex =
    CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

double coarse_size(const TriangleSurface& surface, const TetrahedraOptions& options) {
  if (options.coarse_size > 0) return options.coarse_size;
  const auto box = bounding_box(surface);
  double smallest_extent = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    smallest_extent = std::min(smallest_extent, box.upper[axis] - box.lower[axis]);
  constexpr double cells_across = 12;  // leaves a sphere's chords within 1 % of its volume
  return std::max(options.fine_size, smallest_extent / cells_across);
}

/// Lowest and highest z of the surface within fine_radius of the contact [m].
std::pair<double, double> fine_heights(const TriangleSurface& surface, const TetrahedraOptions& options) {
  double lowest = options.contact[2], highest = options.contact[2];
  for (const auto& point : surface.points)
    if (norm(minus(point, options.contact)) <= options.fine_radius) {
      lowest = std::min(lowest, point[2]);
      highest = std::max(highest, point[2]);
    }
  return {lowest, highest};
}

/// The size wanted at a point, times a factor; a sizing field in CGAL's sense, in nm.
struct SizeField {
  using FT = double;
  using Point_3 = Kernel::Point_3;
  using Index = Domain::Index;

  Kernel::Point_3 contact;
  double lowest, highest, fine_radius, fine_size, coarse_size, growth, factor;

  SizeField(const TriangleSurface& surface, const TetrahedraOptions& options, double factor)
      : contact(to_nm(options.contact)),
        fine_radius(options.fine_radius * metre_in_nm),
        fine_size(options.fine_size * metre_in_nm),
        coarse_size(meshing::coarse_size(surface, options) * metre_in_nm),
        growth(options.growth),
        factor(factor) {
    std::tie(lowest, highest) = fine_heights(surface, options);
    lowest *= metre_in_nm;
    highest *= metre_in_nm;
  }

  double operator()(const Point_3& point, int /*dimension*/, const Index& /*where*/) const {
    const double aside =
        std::max(0., std::hypot(point.x() - contact.x(), point.y() - contact.y()) - fine_radius);
    const double above_or_below = std::max({0., point.z() - highest, lowest - point.z()});
    return factor * std::min(coarse_size, fine_size + growth * std::hypot(aside, above_or_below));
  }
};

void check_options(const TetrahedraOptions& options) {
  const auto need = [](bool holds, const std::string& condition, double value) {
    if (!holds)
      throw InputError("a tetrahedral mesh needs " + condition + ", but " + std::to_string(value) +
                       " was given");
  };
  constexpr double um = 1e-6;
  need(options.fine_size > 0, "fine_size > 0 um", options.fine_size / um);
  need(options.coarse_size == 0 || options.coarse_size >= options.fine_size, "coarse_size >= fine_size in um",
       options.coarse_size / um);
  need(options.fine_radius >= 0, "fine_radius >= 0 um", options.fine_radius / um);
  need(options.growth >= 0, "growth >= 0", options.growth);
  need(options.distance_per_size > 0, "distance_per_size > 0", options.distance_per_size);
  // Beyond these bounds Delaunay refinement may not end.
  need(options.facet_angle >= 0 && options.facet_angle <= M_PI / 6, "facet_angle from 0 to pi/6 rad",
       options.facet_angle);
  need(options.radius_edge_ratio >= 2, "radius_edge_ratio >= 2", options.radius_edge_ratio);
}

TetrahedralMesh plain_mesh(const Complex& complex) {
  TetrahedralMesh mesh;
  std::unordered_map<Triangulation::Vertex_handle, std::uint32_t> index_of;
  const auto index = [&](Triangulation::Vertex_handle vertex) {
    const auto [place, is_new] = index_of.emplace(vertex, static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new)
      mesh.points.push_back(
          from_nm(Kernel::Point_3(vertex->point().x(), vertex->point().y(), vertex->point().z())));
    return place->second;
  };
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
    mesh.tetrahedra.push_back(
        {index(cell->vertex(0)), index(cell->vertex(1)), index(cell->vertex(2)), index(cell->vertex(3))});
  std::map<Domain::Surface_patch_index, int> number_of_patch;
  for (auto facet = complex.facets_in_complex_begin(); facet != complex.facets_in_complex_end(); ++facet) {
    number_of_patch.emplace(complex.surface_patch_index(*facet), 0);
    Triangulation::Facet side = *facet;  // a cell and the vertex opposite
    if (!complex.is_in_complex(side.first)) side = complex.triangulation().mirror_facet(*facet);
    // The triple turns counter-clockwise seen from the opposite vertex, which is inside.
    const auto corner = [&](int i) {
      return index(side.first->vertex(Triangulation::vertex_triple_index(side.second, i)));
    };
    mesh.boundary.push_back({corner(0), corner(2), corner(1)});
  }
  int count = 0;
  for (auto& [patch, number] : number_of_patch) number = ++count;
  for (auto facet = complex.facets_in_complex_begin(); facet != complex.facets_in_complex_end(); ++facet)
    mesh.patch.push_back(number_of_patch.at(complex.surface_patch_index(*facet)));
  return mesh;
}

TetrahedralMesh filled_from_seed(const TriangleSurface& surface, const TetrahedraOptions& options,
                                 unsigned seed) {
  CGAL::Random random(seed);  // a fixed one: the same input gives the same mesh
  CGAL::get_default_random() = CGAL::Random(seed);
  Domain domain(cgal_mesh(surface), &random);
  constexpr double degrees = 180 / M_PI;
  domain.detect_features(options.feature_angle * degrees);

  namespace with = CGAL::parameters;
  const SizeField size(surface, options, 1), distance(surface, options, options.distance_per_size);
  const Criteria criteria(with::edge_size = size, with::facet_angle = options.facet_angle * degrees,
                          with::facet_size = size, with::facet_distance = distance,
                          with::cell_radius_edge_ratio = options.radius_edge_ratio, with::cell_size = size);
  // Perturbation alone removes the slivers; exudation breaks ties by memory address, so its meshes vary.
  return plain_mesh(
      CGAL::make_mesh_3<Complex>(domain, criteria, with::manifold(), with::perturb(), with::no_exude()));
}

/// Perturbation takes a move back where it did not help. Where points lie on one sphere, as those of smooth
/// symmetric bodies may, other tetrahedra can come back than were there, and CGAL gives up
/// (restore_from_cells_backup; issue 8051 of CGAL is of this kind). Refined from other first points, the mesh
/// is another and the tie is gone.
TetrahedralMesh filled(const TriangleSurface& surface, const TetrahedraOptions& options) {
  constexpr unsigned last_seed = 7;
  for (unsigned seed = 0; seed < last_seed; ++seed) {
    try {
      return filled_from_seed(surface, options, seed);
    } catch (const CGAL::Failure_exception&) {
    }
  }
  return filled_from_seed(surface, options, last_seed);
}

}  // namespace

TriangleSurface TetrahedralMesh::surface() const { return {points, boundary}; }

std::array<Point, 4> TetrahedralMesh::corners(std::size_t tetrahedron) const {
  const auto& index = tetrahedra[tetrahedron];
  return {points[index[0]], points[index[1]], points[index[2]], points[index[3]]};
}

TetrahedralMesh tetrahedra(const TriangleSurface& surface, const TetrahedraOptions& options) {
  check_options(options);
  const auto check = check_surface(surface);
  require_body(check, "the body to be filled with tetrahedra");

  auto mesh = without_raw_failures("fill a body with tetrahedra", "use another interface spacing",
                                   [&] { return filled(surface, options); });
  const double error = quality(mesh).volume / check.volume - 1;
  if (!(std::abs(error) <= options.volume_tolerance))
    throw WorkError("the tetrahedra's volume differs from the surface's by " + std::to_string(100 * error) +
                    " %; use a smaller distance_per_size or coarse_size");
  return mesh;
}

TetrahedraQuality quality(const TetrahedralMesh& mesh) {
  TetrahedraQuality result;
  result.smallest_dihedral_angle = M_PI;
  result.smallest_radius_ratio = result.smallest_scaled_jacobian = 1;
  for (std::size_t tetrahedron = 0; tetrahedron < mesh.tetrahedra.size(); ++tetrahedron) {
    const auto points = mesh.corners(tetrahedron);
    result.volume += volume(points);
    result.smallest_dihedral_angle =
        std::min(result.smallest_dihedral_angle, smallest_dihedral_angle(points));
    result.smallest_scaled_jacobian = std::min(result.smallest_scaled_jacobian, scaled_jacobian(points));
    const double ratio = radius_ratio(points);
    result.smallest_radius_ratio = std::min(result.smallest_radius_ratio, ratio);
    result.mean_radius_ratio += ratio / static_cast<double>(mesh.tetrahedra.size());
  }
  return result;
}

}  // namespace asperity::meshing
