#include "meshing/contact_mesh.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <cmath>

namespace asperity::meshing {
namespace {

/// Corner of a tree in a stand-in geometry for the coarse mesh: the smooth bodies themselves at unit radius.
BodySizes unit_sizes(bool full_sphere) {
  BodySizes sizes;
  sizes.full_sphere = full_sphere;
  sizes.radius = 1;
  sizes.block_half_width = 1;
  sizes.spacing_particle = 2 * BodyMap::cap_fraction / 4;
  sizes.spacing_substrate = 0.5;
  sizes.region_particle = sizes.region_substrate = 0.1;
  return sizes;
}

void make_coarse_mesh(Triangulation& forest, bool full_sphere) {
  const BodyMap map(unit_sizes(full_sphere));
  std::vector<dealii::Point<3>> vertices;
  std::vector<dealii::CellData<3>> cells(map.tree_count());
  for (int tree = 0; tree < map.tree_count(); ++tree) {
    for (int v = 0; v < 8; ++v) {
      Point3 p = map.position(tree, LogicalBox{tree, {0, 0, 0}, 1}.vertex(v));
      if (tree == block) p[2] -= 1;  // keep the bodies apart, whatever the tolerance for merging vertices
      const dealii::Point<3> point(p[0], p[1], p[2]);
      auto known = std::find_if(vertices.begin(), vertices.end(),
                                [&](const auto& q) { return q.distance(point) < 1e-6; });
      if (known == vertices.end()) known = vertices.insert(vertices.end(), point);
      cells[tree].vertices[v] = static_cast<unsigned>(known - vertices.begin());
    }
    cells[tree].material_id = static_cast<unsigned>(BodyMap::body_of(tree));
  }
  forest.create_triangulation(vertices, cells, dealii::SubCellData());
  for (const auto& cell : forest.active_cell_iterators()) {
    const int tree = logical_box(cell).tree;
    for (const unsigned f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary()) continue;
      unsigned id = free_boundary;
      if (tree == block)
        id = f == 5 ? interface_substrate : f == 4 ? fixed_boundary : free_boundary;
      else if (tree == cap)
        id = f == 4 ? interface_particle : free_boundary;
      else if (tree == upper_first + cap)
        id = f == 4 ? driven_boundary : free_boundary;  // glued over its upper cap
      else if (tree > upper_first)
        id = free_boundary;
      else
        id = static_cast<int>(f) == BodyMap::equator_face(tree) ? driven_boundary : free_boundary;
      cell->face(f)->set_boundary_id(id);
    }
  }
}

/// How far a cell is from the contact region: 0 where it touches the uniformly meshed rectangle. Aside by the
/// lattice of the surface, though the cap's lattice is narrower below: a cell is never farther than those
/// below it, which would hang their nodes on its wide faces.
double distance_to_region(const BodyMap& map, const LogicalBox& box, double region, const FinePart& part) {
  const std::array<double, 2> low = map.aside(box.tree, box.vertex(0)),
                              high = map.aside(box.tree, box.vertex(7));
  const double along = std::max(low[0] - region - part.high, part.low - region - high[0]),
               across = std::max(low[1], -high[1]) - region;
  const double depth = std::min(map.depth(box.tree, box.vertex(0)), map.depth(box.tree, box.vertex(7)));
  return std::max({0.0, along, across, depth});
}

bool too_coarse(const BodyMap& map, const LogicalBox& box, const ContactMeshOptions& options) {
  if (box.tree != cap && box.tree != block) return false;
  if (options.kept && options.kept->has_within(box)) return true;
  const Body body = BodyMap::body_of(box.tree);
  const double spacing =
      body == Body::particle ? map.sizes().spacing_particle : map.sizes().spacing_substrate;
  const double region = body == Body::particle ? map.sizes().region_particle : map.sizes().region_substrate;
  const double width = box.size * spacing * std::pow(2.0, map.finest_level(body));
  if (width < 1.5 * spacing) return false;
  const double distance = distance_to_region(map, box, region, options.fine_part(body));
  // The near field, where stresses peak below a smooth contact, keeps at least six cells over the region's
  // width.
  const double wide = 0.5 * distance * 4 / options.layers,
               allowed = distance < region ? std::min(wide, 0.35 * region) : wide;
  return width > std::max(spacing, allowed) * (1 + 1e-9);
}

/// Whether the cell and all that it is a part of are too coarse. A part is never nearer to the region than
/// the whole, but for rounding where cells begin just at the border: a part alone could be too coarse there,
/// and a forest differ from the next coarser one by two levels.
bool to_be_refined(const BodyMap& map, LogicalBox box, const ContactMeshOptions& options) {
  for (;; box = parent_of(box)) {
    if (!too_coarse(map, box, options)) return false;
    if (box.size >= 1) return true;
  }
}

}  // namespace

LogicalBox logical_box(const dealii::Triangulation<3>& forest, const dealii::CellId& id) {
  // p4est orders its trees itself; the index of the coarse cell is the order they were made in.
  const dealii::CellId coarse(id.get_coarse_cell_id(), std::vector<std::uint8_t>());
  LogicalBox box{forest.create_cell_iterator(coarse)->index(), {0, 0, 0}, 1.0};
  for (const auto child : id.get_child_indices()) {
    box.size *= 0.5;
    for (int d = 0; d < 3; ++d) box.corner[d] += ((child >> d) & 1) * box.size;
  }
  return box;
}

FinePart ContactMeshOptions::fine_part(Body body) const {
  const double reach = body == Body::particle ? sizes.reach_particle : sizes.reach_substrate;
  const FinePart& part = fine[static_cast<std::size_t>(body)];
  return {std::max(-reach, part.low), std::min(reach, part.high)};
}

RoughGeometry::RoughGeometry(const ContactMeshOptions& options)
    : map_(options.sizes),
      particle_height_(options.particle_height),
      substrate_height_(options.substrate_height) {
  // A height h that fades over a depth D strains the cells by h / D: D = 8 h keeps them within 1/8 of their
  // shape.
  fade_particle_ = std::max(8 * options.largest_height_particle, 4 * options.sizes.spacing_particle);
  fade_substrate_ = std::max(8 * options.largest_height_substrate, 4 * options.sizes.spacing_substrate);
}

double RoughGeometry::film_share(const LogicalBox& box, double thickness) const {
  if (box.tree != cap && box.tree != block) return 0;
  const double one = map_.depth(box.tree, box.vertex(0)), other = map_.depth(box.tree, box.vertex(7));
  const double top = std::min(one, other), bottom = std::max(one, other);
  return std::clamp((thickness - top) / (bottom - top), 0.0, 1.0);
}

double RoughGeometry::faded_height(Body body, double x, double y, double depth) const {
  const auto& height = body == Body::particle ? particle_height_ : substrate_height_;
  if (!height || depth >= fade_depth(body)) return 0;
  const auto& sizes = map_.sizes();
  const bool particle = body == Body::particle;
  const double region = particle ? sizes.region_particle : sizes.region_substrate;
  const double along = std::abs(particle ? x : x - sizes.offset_substrate_x) -
                       (particle ? sizes.reach_particle : sizes.reach_substrate);
  const double across = std::abs(particle ? y : y - sizes.offset_substrate_y);
  // Beyond the region, where no contact comes and cells are wider than the asperities, the roughness ends
  // smoothly.
  const double beyond = std::clamp((std::max(along, across) - 1.05 * region) / (0.25 * region), 0.0, 1.0);
  if (beyond >= 1) return 0;
  return height(x, y) * (1 - depth / fade_depth(body)) * (1 - beyond) * (1 - beyond) * (1 + 2 * beyond);
}

Point3 RoughGeometry::position(int tree, const Point3& logical) const {
  Point3 p = map_.position(tree, logical);
  if (tree == cap) p[2] -= faded_height(Body::particle, p[0], p[1], map_.depth(tree, logical));
  if (tree == block) p[2] += faded_height(Body::substrate, p[0], p[1], map_.depth(tree, logical));
  return p;
}

std::unique_ptr<Triangulation> make_forest(MPI_Comm communicator, const ContactMeshOptions& options,
                                           int coarsenings) {
  auto forest = std::make_unique<Triangulation>(communicator);
  make_coarse_mesh(*forest, options.sizes.full_sphere);
  const BodyMap map(options.sizes);
  const auto level_cap = [&](int tree) {
    return std::max(1, map.finest_level(BodyMap::body_of(tree)) - coarsenings);
  };
  const int deepest = std::max(level_cap(cap), level_cap(block));
  const int everywhere = std::min({3, level_cap(cap), level_cap(block)});
  forest->refine_global(everywhere);
  for (int level = everywhere; level < deepest; ++level) {
    bool any = false;
    for (const auto& cell : forest->active_cell_iterators()) {
      if (!cell->is_locally_owned()) continue;
      const LogicalBox box = logical_box(cell);
      if (cell->level() >= level_cap(box.tree) || !to_be_refined(map, box, options)) continue;
      cell->set_refine_flag();
      any = true;
    }
    if (!dealii::Utilities::MPI::max(any ? 1 : 0, communicator)) break;
    forest->execute_coarsening_and_refinement();
  }
  return forest;
}

}  // namespace asperity::meshing
