#include "meshing/body_map.h"

#include <cmath>

namespace asperity::meshing {
namespace {

Point3 blend(const Point3& a, const Point3& b, double t) {
  return {(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
}

/// Level at which 2^level cells over `width` are at least as wide as `spacing`; the stretch makes up the
/// rest. Where these are too few to reach over the uniform part, or the last one is more than `widest` times
/// as wide as these, one level more, with cells that are narrower than asked. Hanging nodes lie in the middle
/// of wide faces, where the nodes of a grading do not: on the cap scaled Jacobians fall below 0.2 at a
/// widening of 9.5, in the block at 10.2.
int level_for(double width, double spacing, double uniform_half_width) {
  constexpr double widest = 8;
  const int level = std::max(2, static_cast<int>(std::floor(std::log2(width / spacing * (1 + 1e-9)))));
  const double slope = spacing * std::pow(2.0, level - 1);
  const bool reaches = uniform_half_width <= Stretch::largest_uniform_part * slope;
  return reaches && Stretch(width / 2, slope, uniform_half_width).widening() <= widest ? level : level + 1;
}

/// Whether the first axis of a side's tree goes up, rather than its second.
bool up_first(int quarter) { return quarter == 0 || quarter == 3; }

}  // namespace

int BodyMap::equator_face(int tree) {
  if (tree == core) return 5;
  return tree >= side_first && tree < core ? (up_first(tree - side_first) ? 1 : 3) : -1;
}

BodyMap::BodyMap(const BodySizes& sizes) : sizes_(sizes) {
  const double cap_half = cap_fraction * sizes.radius;
  const double cap_thickness = (1 - core_height_fraction) * sizes.radius;
  const double uniform_particle = 1.5 * sizes.region_particle + sizes.reach_particle;
  level_particle_ = level_for(2 * cap_half, sizes.spacing_particle, uniform_particle);
  const double cells_particle = std::pow(2.0, level_particle_);
  cap_lateral_ = Stretch(cap_half, sizes.spacing_particle * cells_particle / 2, uniform_particle);
  cap_depth_ = Stretch(cap_thickness, sizes.spacing_particle * cells_particle, sizes.region_particle);

  const double half = sizes.block_half_width;
  const double uniform_substrate = 1.5 * sizes.region_substrate + sizes.reach_substrate;
  level_substrate_ = level_for(2 * half, sizes.spacing_substrate, uniform_substrate);
  const double cells_substrate = std::pow(2.0, level_substrate_);
  block_lateral_ = Stretch(half, sizes.spacing_substrate * cells_substrate / 2, uniform_substrate);
  block_depth_ = Stretch(2 * half, sizes.spacing_substrate * cells_substrate, sizes.region_substrate);
}

Point3 BodyMap::cap_surface(double x, double y) const {
  const double r2 = x * x + y * y, R = sizes_.radius;
  return {x, y, r2 / (R + std::sqrt(R * R - r2))};
}

double BodyMap::depth(int tree, const Point3& logical) const {
  return tree == block ? block_depth_(1 - logical[2]) : cap_depth_(logical[2]);
}

std::array<double, 2> BodyMap::aside(int tree, const Point3& logical) const {
  const Stretch& lateral = tree == block ? block_lateral_ : cap_lateral_;
  return {lateral(2 * logical[0] - 1), lateral(2 * logical[1] - 1)};
}

Point3 BodyMap::in_side_tree(int quarter, const Point3& logical) const {
  // Built for the side towards +x, then turned by quarter * 90 degrees about z. Axes of the tree: along
  // (towards +x or +y when turned), up and inwards, in the order that makes them right-handed.
  const bool first = up_first(quarter);
  const double along = logical[first ? 1 : 0], up = logical[first ? 0 : 1];
  const double R = sizes_.radius, tangential = (first ? 1 : -1) * cap_lateral_(2 * along - 1);
  const double fraction = tangential / cap_lateral_.length();
  const double depth_fraction = cap_depth_(logical[2]) / cap_depth_.length();

  const Point3 edge = cap_surface(cap_lateral_.length(), tangential);
  const double phi = std::atan(1.0) * fraction;
  const Point3 equator{R * std::cos(phi), R * std::sin(phi), R};
  Point3 from_centre = blend(edge, equator, up);
  from_centre[2] -= R;
  const double norm = std::sqrt(from_centre[0] * from_centre[0] + from_centre[1] * from_centre[1] +
                                from_centre[2] * from_centre[2]);
  const Point3 outer{from_centre[0] * R / norm, from_centre[1] * R / norm, R + from_centre[2] * R / norm};
  const double c = core_fraction * R, height = core_height_fraction * R;
  const Point3 inner{c, c * fraction, R - height * (1 - up)};

  const Point3 p = blend(outer, inner, depth_fraction);
  switch (quarter) {
    case 0:
      return p;
    case 1:
      return {-p[1], p[0], p[2]};
    case 2:
      return {-p[0], -p[1], p[2]};
    default:
      return {p[1], -p[0], p[2]};
  }
}

Point3 BodyMap::position(int tree, const Point3& logical) const {
  const double R = sizes_.radius;
  if (tree >= upper_first) {
    const Point3 p = position(tree - upper_first, {logical[1], logical[0], logical[2]});
    return {p[0], p[1], 2 * R - p[2]};
  }
  if (tree == block)
    return {block_lateral_(2 * logical[0] - 1) + sizes_.offset_substrate_x,
            block_lateral_(2 * logical[1] - 1) + sizes_.offset_substrate_y, -block_depth_(1 - logical[2])};
  if (tree >= side_first && tree < core) return in_side_tree(tree - side_first, logical);

  const double x = cap_lateral_(2 * logical[0] - 1), y = cap_lateral_(2 * logical[1] - 1);
  const double c = core_fraction * R / cap_lateral_.length(), height = core_height_fraction * R;
  if (tree == core) return {c * x, c * y, R - height * (1 - logical[2])};
  return blend(cap_surface(x, y), {c * x, c * y, R - height}, cap_depth_(logical[2]) / cap_depth_.length());
}

}  // namespace asperity::meshing
