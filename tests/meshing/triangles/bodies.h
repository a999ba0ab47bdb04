// Bodies made of a mapped block of hexahedra, for the tests of meshing/triangles.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing::testing {

struct QuadSurface {
  std::vector<Point> points;  // of the whole block, inner ones too
  std::vector<QuadIndices> quads;
};

/// Boundary of a block of nx x ny x nz cells on [-1,1] x [-1,1] x [0,1], outward, its points moved by `map`.
inline QuadSurface mapped_block(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz,
                                const std::function<Point(const Point&)>& map) {
  QuadSurface block;
  const std::array<std::uint32_t, 3> cells{nx, ny, nz};
  const auto index = [&](const std::array<std::uint32_t, 3>& node) {
    return (node[2] * (ny + 1) + node[1]) * (nx + 1) + node[0];
  };
  for (std::uint32_t iz = 0; iz <= nz; ++iz)
    for (std::uint32_t iy = 0; iy <= ny; ++iy)
      for (std::uint32_t ix = 0; ix <= nx; ++ix)
        block.points.push_back(map({-1 + 2. * ix / nx, -1 + 2. * iy / ny, double(iz) / nz}));
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const int first = (axis + 1) % 3, second = (axis + 2) % 3;
      for (std::uint32_t i = 0; i < cells[first]; ++i)
        for (std::uint32_t j = 0; j < cells[second]; ++j) {
          const auto corner = [&](std::uint32_t di, std::uint32_t dj) {
            std::array<std::uint32_t, 3> node{};
            node[axis] = upper ? cells[axis] : 0;
            node[first] = i + di;
            node[second] = j + dj;
            return index(node);
          };
          if (upper)
            block.quads.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
          else
            block.quads.push_back({corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)});
        }
    }
  return block;
}

/// Height of a rough surface at (x, y) [m]: some waves that are not aligned with the mesh.
inline double waves(double x, double y, double amplitude, double wavelength) {
  const double k = 2 * M_PI / wavelength;
  return amplitude *
         (std::sin(k * (0.9 * x + 0.3 * y) + 0.4) + 0.7 * std::sin(k * (-0.5 * x + 1.3 * y) + 1.9) +
          0.5 * std::sin(k * (1.7 * x + 1.1 * y) + 3.1)) /
         1.4;
}

/// Half a ball of radius R below its flat face at z = R, with its pole at the origin; `roughness(x, y)` is
/// added along the outward normal. `pole_grading` > 1 draws nodes towards the pole.
inline QuadSurface hemisphere(std::uint32_t cells, double radius,
                              const std::function<double(double, double)>& roughness = nullptr,
                              double pole_grading = 1) {
  return mapped_block(cells, cells, std::max(1u, cells / 2), [=](const Point& p) {
    const auto graded = [&](double t) { return std::copysign(std::pow(std::abs(t), pole_grading), t); };
    const double u = -graded(p[0]), v = graded(p[1]), w = p[2];
    // Cube to ball: max-norm 1 goes to radius 1, w = 0 stays in the plane.
    const Point unit{u * std::sqrt(1 - v * v / 2 - w * w / 2 + v * v * w * w / 3),
                     v * std::sqrt(1 - w * w / 2 - u * u / 2 + w * w * u * u / 3),
                     -w * std::sqrt(1 - u * u / 2 - v * v / 2 + u * u * v * v / 3)};
    const double rough =
        roughness ? roughness(radius * unit[0], radius * unit[1]) * std::max(0., -unit[2]) : 0;
    const double reach = std::max({std::abs(u), std::abs(v), w});  // roughness fades into the body
    const double length = radius + rough * reach * reach;
    return Point{length * unit[0], length * unit[1], radius + length * unit[2]};
  });
}

inline TriangleSurface box(double lx, double ly, double lz, std::uint32_t cells = 1) {
  const auto block = mapped_block(cells, cells, cells, [=](const Point& p) {
    return Point{lx * p[0] / 2, ly * p[1] / 2, lz * p[2]};
  });
  return triangles_of_quads(block.points, block.quads);
}

}  // namespace asperity::meshing::testing
