// The coupling of two non-matching interfaces: what it must reproduce for forces, moments and a uniform
// pressure.
#include "fem/mortar/mortar.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;
using asperity::test::Largest;
using asperity::test::Verified;

Verified of_mortar(const std::string& quantity, const std::string& source) {
  return {"Element and coupling", "mortar: " + quantity, source};
}

/// A lattice of rectangles with nodes numbered from `first`; `grading` makes spacings uneven.
struct Lattice {
  std::vector<PlaneFace> faces;
  std::vector<std::array<double, 2>> points;
  int first;

  Lattice(int nx, int ny, double x0, double x1, double y0, double y1, double grading, int first_node)
      : first(first_node) {
    const auto at = [&](int i, int n, double low, double high) {
      const double t = static_cast<double>(i) / n;
      return low + (high - low) * (t + grading * std::sin(2 * M_PI * t) / (2 * M_PI));
    };
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) points.push_back({at(i, nx, x0, x1), at(j, ny, y0, y1)});
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const int a = j * (nx + 1) + i, d = a + nx + 2;
        faces.push_back({points[a][0],
                         points[d][0],
                         points[a][1],
                         points[d][1],
                         {first + a, first + a + 1, first + d - 1, first + d}});
      }
  }
};

struct Pair {
  Lattice particle{9, 7, -0.5e-6, 0.5e-6, -0.4e-6, 0.4e-6, 0.0, 0};
  Lattice substrate{13, 10, -0.83e-6, 0.71e-6, -0.62e-6, 0.66e-6, 0.4, 1000};
  std::vector<GapRow> rows = couple_interfaces(quads(particle.faces), substrate.faces);

  std::array<double, 2> at(int node) const {
    return node < 1000 ? particle.points[node] : substrate.points[node - 1000];
  }
  template <typename Height>
  double gap(const GapRow& row, const Height& height) const {
    double sum = 0;
    for (const auto& [node, weight] : row.entries) sum += weight * height(at(node)[0], at(node)[1]);
    return sum;
  }
};

TEST(Mortar_analytic, areas_of_nodes_add_up_to_the_contact_region) {
  const Pair pair;
  double area = 0;
  for (const auto& row : pair.rows) area += row.area;
  EXPECT_EQ(pair.rows.size(), pair.particle.points.size());
  EXPECT_NEAR(area, 1e-6 * 0.8e-6, 1e-12 * 0.8e-12);
}

TEST(Mortar_analytic, two_equal_planes_at_any_height_and_tilt_have_no_gap) {
  const Pair pair;
  Largest flat, tilted;
  for (const auto& row : pair.rows) {
    flat.count(pair.gap(row, [](double, double) { return 1.0; }));
    tilted.count(pair.gap(row, [](double x, double y) { return 3 * x - 2 * y; }) / 1e-6);
  }
  EXPECT_TRUE(of_mortar("gap of two equal planes, of their height", "none").below(flat, 1e-12));
  EXPECT_TRUE(of_mortar("gap of two equal tilted planes, of a micrometre", "none").below(tilted, 1e-12));
}

/// The particle's lattice turned in the plane and foreshortened unevenly, as a rolled and spun surface is
/// seen.
TEST(Mortar_analytic, turned_and_distorted_faces_balance_forces_and_moments_and_reproduce_planes) {
  const Lattice particle(9, 7, -0.4e-6, 0.4e-6, -0.3e-6, 0.3e-6, 0.0, 0),
      substrate(13, 10, -0.83e-6, 0.71e-6, -0.62e-6, 0.66e-6, 0.4, 1000);
  const auto place = [&](int node) {
    if (node >= 1000) return substrate.points[node - 1000];
    const auto& p = particle.points[node];
    const double x = p[0] * (1 - 0.1 * p[1] / 1e-6), y = p[1] * (1 + 0.1 * p[0] / 1e-6), c = std::cos(0.3),
                 s = std::sin(0.3);
    return std::array<double, 2>{c * x - s * y, s * x + c * y};
  };
  std::vector<PlaneQuad> turned = quads(particle.faces);
  double area = 0;
  for (auto& quad : turned) {
    for (int v = 0; v < 4; ++v) quad.corner[v] = place(quad.node[v]);
    const auto cross = [&](int a, int b, int c) {
      return (quad.corner[b][0] - quad.corner[a][0]) * (quad.corner[c][1] - quad.corner[a][1]) -
             (quad.corner[b][1] - quad.corner[a][1]) * (quad.corner[c][0] - quad.corner[a][0]);
    };
    area += 0.5 * (cross(0, 1, 3) + cross(0, 3, 2));
  }
  double covered = 0, force = 0, moment_x = 0, moment_y = 0, size = 0;
  const auto rows = couple_interfaces(turned, substrate.faces);
  Largest planes;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    covered += rows[r].area;
    const double load = (1 + std::sin(12.9898 * r)) * rows[r].area;
    size += load;
    double plane = 0;
    for (const auto& [node, weight] : rows[r].entries) {
      const auto p = place(node);
      force += weight * load, moment_x += weight * load * p[1], moment_y += weight * load * p[0];
      plane += weight * (3 * p[0] - 2 * p[1]);
    }
    planes.count(plane / 1e-6);
  }
  const double moment = std::max(std::abs(moment_x), std::abs(moment_y));
  const std::string faces = "turned and distorted faces: ";
  EXPECT_TRUE(
      of_mortar(faces + "gap of two equal tilted planes, of a micrometre", "none").below(planes, 1e-12));
  EXPECT_TRUE(of_mortar(faces + "area", "that of the faces").below(covered / area - 1, 1e-12));
  EXPECT_TRUE(of_mortar(faces + "forces of both sides", "balance").below(force / size, 1e-12));
  EXPECT_TRUE(of_mortar(faces + "moments of both sides, arms of a micrometre", "balance")
                  .below(moment / size / 1e-6, 1e-12));
}

TEST(Mortar_analytic, forces_and_moments_on_both_sides_cancel_for_any_pressure) {
  const Pair pair;
  double force = 0, moment_x = 0, moment_y = 0, size = 0;
  for (std::size_t r = 0; r < pair.rows.size(); ++r) {
    const double load = (1 + std::sin(12.9898 * r)) * pair.rows[r].area;
    size += load;
    for (const auto& [node, weight] : pair.rows[r].entries) {
      force += weight * load;
      moment_x += weight * load * pair.at(node)[1];
      moment_y += weight * load * pair.at(node)[0];
    }
  }
  const double moment = std::max(std::abs(moment_x), std::abs(moment_y));
  EXPECT_TRUE(of_mortar("forces of both sides under any pressure", "balance").below(force / size, 1e-12));
  EXPECT_TRUE(
      of_mortar("moments of both sides, arms of a micrometre", "balance").below(moment / size / 1e-6, 1e-12));
}

TEST(Mortar_analytic, uniform_pressure_loads_both_sides_with_its_consistent_nodal_forces) {
  // Lattices of one outline and different spacings, as in the patch test of two blocks.
  const Lattice top(9, 7, 0, 1e-6, 0, 1e-6, 0.0, 0), bottom(5, 6, 0, 1e-6, 0, 1e-6, 0.3, 1000);
  const auto rows = couple_interfaces(quads(top.faces), bottom.faces);
  std::vector<double> load(2000, 0.0), expected(2000, 0.0);
  for (const auto& row : rows)
    for (const auto& [node, weight] : row.entries) load[node] += weight * row.area;
  for (const auto* side : {&top, &bottom})
    for (const auto& f : side->faces)
      for (const int node : f.node)
        expected[node] += (node < 1000 ? 0.25 : -0.25) * (f.x1 - f.x0) * (f.y1 - f.y0);
  Largest error;
  for (int node = 0; node < 2000; ++node) error.count((load[node] - expected[node]) / 1e-12);
  EXPECT_TRUE(of_mortar("nodal forces of a uniform pressure on both sides, of a square micrometre's",
                        "consistent ones")
                  .below(error, 1e-12));
}

TEST(Mortar_analytic, gap_of_a_paraboloid_converges_with_the_square_of_the_spacing) {
  double before = 0;
  for (const int n : {8, 16, 32}) {
    const Lattice fine(n, n, -1e-6, 1e-6, -1e-6, 1e-6, 0.0, 0),
        flat(n / 8 * 11, n / 8 * 11, -1.3e-6, 1.3e-6, -1.3e-6, 1.3e-6, 0.0, 100000);
    double largest = 0;
    for (const auto& row : couple_interfaces(quads(fine.faces), flat.faces)) {
      double opposite = 0;
      for (const auto& [node, weight] : row.entries)
        if (node >= 100000) {
          const auto& p = flat.points[node - 100000];
          opposite -= weight * (p[0] * p[0] + p[1] * p[1]);
        }
      const auto& p = fine.points[row.node];
      largest = std::max(largest, std::abs(opposite - (p[0] * p[0] + p[1] * p[1])));
    }
    if (before > 0) {
      EXPECT_LT(largest, 0.35 * before);
    }
    before = largest;
  }
}

TEST(Mortar_behaviour, substrate_that_does_not_cover_the_contact_region_is_refused) {
  const Lattice particle(4, 4, 0, 1, 0, 1, 0, 0), small(4, 4, 0, 0.9, 0, 1, 0, 100);
  EXPECT_THROW(couple_interfaces(quads(particle.faces), small.faces), asperity::WorkError);
}

}  // namespace
