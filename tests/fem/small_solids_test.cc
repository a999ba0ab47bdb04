// The hexahedron with the material law and the mortar coupling, assembled on small meshes of any shape:
// element and contact patch tests, Hill's thick-walled sphere.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/csv.h"
#include "fem/mortar/mortar.h"
#include "tests/fem/support/elastic_materials.h"
#include "tests/fem/support/small_solid.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;
using asperity::test::borosilicate;
using asperity::test::Largest;
using asperity::test::Point;
using asperity::test::silicon;
using asperity::test::SmallSolid;
using asperity::test::Verified;

Verified of_solids(const std::string& quantity, const std::string& source) {
  return {"Element and coupling", quantity, source};
}

/// A box of nx x ny x nz cells; `shake` moves inner nodes by that fraction of a cell, the same way every
/// time.
void add_box(SmallSolid& solid, const Point& low, const Point& high, const std::array<int, 3>& n,
             const J2Material& m, double shake) {
  std::vector<int> node;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        const int at[3] = {i, j, k};
        const bool inside = i > 0 && i < n[0] && j > 0 && j < n[1] && k > 0 && k < n[2];
        Point p;
        for (int c = 0; c < 3; ++c) {
          const double width = (high[c] - low[c]) / n[c];
          p[c] = low[c] + width * at[c] +
                 (inside ? shake * width * std::sin(17.0 * i + 31.0 * j + 47.0 * k + 5.0 * c) : 0.0);
        }
        node.push_back(static_cast<int>(solid.nodes.size()));
        solid.nodes.push_back(p);
      }
  const auto index = [&](int i, int j, int k) { return node[(k * (n[1] + 1) + j) * (n[0] + 1) + i]; };
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, 8> vertices;
        for (int v = 0; v < 8; ++v) vertices[v] = index(i + (v & 1), j + ((v >> 1) & 1), k + (v >> 2));
        solid.add_cell(vertices, m);
      }
}

SmallSolid distorted_cube() {
  SmallSolid solid;
  add_box(solid, {0, 0, 0}, {1, 1, 1}, {4, 3, 5}, borosilicate, 0.25);
  solid.finish();
  return solid;
}

TEST(Hexahedron_analytic, rigid_motion_gives_no_force) {
  const SmallSolid solid = distorted_cube();
  Largest force;
  for (int mode = 0; mode < 6; ++mode) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(solid.size());
    for (std::size_t i = 0; i < solid.nodes.size(); ++i) {
      const auto& x = solid.nodes[i];
      const int a = mode % 3, b = (a + 1) % 3, c = (a + 2) % 3;
      if (mode < 3)
        u[3 * i + a] = 1e-3;
      else
        u[3 * i + b] = -1e-3 * x[c], u[3 * i + c] = 1e-3 * x[b];
    }
    const double stiffness = 2 * borosilicate.shear_modulus;
    force.count(solid.internal_force(u, nullptr).lpNorm<Eigen::Infinity>() / (stiffness * 1e-3));
  }
  EXPECT_TRUE(
      of_solids("distorted mesh moved rigidly: force", "none").below(force, 1e-12, "of the stiffness"));
}

TEST(Hexahedron_analytic, linear_displacement_gives_its_exact_stress_and_no_inner_force_on_a_distorted_mesh) {
  SmallSolid solid = distorted_cube();
  const double gradient[3][3] = {{1e-3, 2e-4, -3e-4}, {5e-4, -7e-4, 4e-4}, {-2e-4, 6e-4, 9e-4}};
  const double lambda = borosilicate.bulk_modulus - 2.0 / 3 * borosilicate.shear_modulus,
               trace = gradient[0][0] + gradient[1][1] + gradient[2][2];
  constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
  Eigen::VectorXd exact(solid.size());
  for (std::size_t i = 0; i < solid.nodes.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      exact[3 * i + c] = 0;
      for (int d = 0; d < 3; ++d) exact[3 * i + c] += gradient[c][d] * solid.nodes[i][d];
    }
  // Prescribed on the boundary only; the inside must find the same field.
  Eigen::VectorXd u = exact;
  for (std::size_t i = 0; i < solid.nodes.size(); ++i) {
    const auto& x = solid.nodes[i];
    const bool boundary =
        *std::min_element(x.begin(), x.end()) < 1e-9 || *std::max_element(x.begin(), x.end()) > 1 - 1e-9;
    for (int c = 0; c < 3; ++c) {
      solid.fixed[3 * i + c] = boundary;
      if (!boundary) u[3 * i + c] = 0;
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd residual = -solid.internal_force(u, &entries);
  for (int i = 0; i < solid.size(); ++i)
    if (solid.fixed[i]) residual[i] = 0;
  u += solid.solve_linear(entries, residual);
  EXPECT_LT((u - exact).lpNorm<Eigen::Infinity>(), 1e-15);
  Largest stress;
  for (int cell = 0; cell < static_cast<int>(solid.cells.size()); ++cell)
    for (const auto& s : solid.stresses(cell, u))
      for (int c = 0; c < 6; ++c) {
        const auto [a, b] = pairs[c];
        const double expected =
            borosilicate.shear_modulus * (gradient[a][b] + gradient[b][a]) + (a == b ? lambda * trace : 0);
        stress.count((s[c] - expected) / (borosilicate.shear_modulus * 1e-3));
      }
  EXPECT_TRUE(of_solids("distorted mesh, linear displacement: stress", "Hooke's law").below(stress, 1e-10));
}

/// Two stacked blocks of 1 um, frictionless contact between non-matching distorted meshes, uniform pressure
/// on top.
struct PatchResult {
  double pressure_error = 0, stress_error = 0, top_displacement = 0;
};

PatchResult contact_patch(double load, bool confined) {
  constexpr double side = 1e-6;
  SmallSolid solid;
  add_box(solid, {0, 0, side}, {side, side, 2 * side}, {4, 3, 4}, borosilicate, 0.2);
  const int upper_nodes = static_cast<int>(solid.nodes.size());
  add_box(solid, {0, 0, 0}, {side, side, side}, {3, 5, 3}, silicon, 0.2);
  solid.finish();
  std::array<std::vector<PlaneFace>, 2> faces;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(solid.size());
  for (const auto& cell : solid.cells) {
    const int body = cell[0] < upper_nodes ? 0 : 1, at = body == 0 ? 0 : 4;
    const auto& low = solid.nodes[cell[at]];
    const auto& high = solid.nodes[cell[at + 3]];
    if (std::abs(low[2] - side) < 1e-12 && std::abs(high[2] - side) < 1e-12)
      faces[body].push_back(
          {low[0], high[0], low[1], high[1], {cell[at], cell[at + 1], cell[at + 2], cell[at + 3]}});
    const auto& a = solid.nodes[cell[4]];
    const auto& d = solid.nodes[cell[7]];
    if (a[2] > 2 * side - 1e-12)
      for (int v = 4; v < 8; ++v) force[3 * cell[v] + 2] -= 0.25 * load * (d[0] - a[0]) * (d[1] - a[1]);
  }
  for (int i = 0; i < static_cast<int>(solid.nodes.size()); ++i) {
    const auto& x = solid.nodes[i];
    for (int c = 0; c < 2; ++c) solid.fixed[3 * i + c] = x[c] < 1e-12 || (confined && x[c] > side - 1e-12);
    solid.fixed[3 * i + 2] = x[2] < 1e-12;
  }
  const auto rows = couple_interfaces(quads(faces[0]), faces[1]);
  // Augmented Lagrangian as in the contact solver: p = max(0, lambda - eps g).
  const double eps = 10 * 50e9 / (side / 4);
  std::vector<double> lambda(rows.size(), 0.0), pressure(rows.size(), 0.0);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(solid.size());
  for (int i = 0; i < upper_nodes; ++i) u[3 * i + 2] = -0.01e-9;  // so that there is contact to begin with
  for (int update = 0; update < 40; ++update) {
    for (int newton = 0; newton < 10; ++newton) {
      std::vector<Eigen::Triplet<double>> entries;
      Eigen::VectorXd residual = force - solid.internal_force(u, &entries);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        double gap = 0;
        for (const auto& [node, weight] : rows[r].entries) gap += weight * u[3 * node + 2];
        pressure[r] = std::max(0.0, lambda[r] - eps * gap);
        if (pressure[r] == 0) continue;
        for (const auto& [node, weight] : rows[r].entries) {
          residual[3 * node + 2] += weight * pressure[r] * rows[r].area;
          for (const auto& [other, factor] : rows[r].entries)
            entries.emplace_back(3 * node + 2, 3 * other + 2, eps * rows[r].area * weight * factor);
        }
      }
      for (int i = 0; i < solid.size(); ++i)
        if (solid.fixed[i]) residual[i] = 0;
      if (residual.norm() < 1e-12 * force.norm()) break;
      u += solid.solve_linear(entries, residual);
    }
    lambda = pressure;
  }
  PatchResult result;
  for (const double p : pressure)
    result.pressure_error = std::max(result.pressure_error, std::abs(p / load - 1));
  for (int cell = 0; cell < static_cast<int>(solid.cells.size()); ++cell)
    for (const auto& s : solid.stresses(cell, u))
      result.stress_error = std::max(result.stress_error, std::abs(s[2] / load + 1));
  double top = 0;
  int count = 0;
  for (int i = 0; i < upper_nodes; ++i)
    if (solid.nodes[i][2] > 2 * side - 1e-12) top -= u[3 * i + 2], ++count;
  result.top_displacement = top / count;
  return result;
}

/// Shortening of a block of unit height and unit pressure: free sides 1/E, confined sides 1/(K + 4G/3).
double shortening(const J2Material& m, bool confined) {
  const double youngs = 9 * m.bulk_modulus * m.shear_modulus / (3 * m.bulk_modulus + m.shear_modulus);
  return 1 / (confined ? m.bulk_modulus + 4.0 / 3 * m.shear_modulus : youngs);
}

TEST(ContactPatch_analytic, uniform_pressure_passes_through_non_matching_distorted_meshes) {
  for (const bool confined : {false, true}) {
    const double load = 0.1e9;
    const PatchResult r = contact_patch(load, confined);
    const double expected =
        load * 1e-6 * (shortening(borosilicate, confined) + shortening(silicon, confined));
    const auto verified = [&](const std::string& what) {
      return of_solids("contact patch, two blocks, distorted meshes that do not match, sides " +
                           std::string(confined ? "held" : "free") + ": " + what,
                       "uniform stress");
    };
    EXPECT_TRUE(verified("pressure").below(r.pressure_error, 1e-6));
    EXPECT_TRUE(verified("stress everywhere").below(r.stress_error, 1e-6));
    EXPECT_TRUE(verified("top displacement").below(r.top_displacement / expected - 1, 1e-6));
  }
}

TEST(ContactPatch_other_code, top_displacement_agrees_with_the_stored_value) {
  const auto path = asperity::test::reference_table("08_fe_verification.csv");
  const auto table = asperity::read_csv(path);
  int found = 0;
  Largest error;
  for (const auto& row : table.rows) {
    const std::string& id = row[table.column("id")];
    if (id != "F-patch-free-0.1" && id != "F-patch-conf-0.1") continue;
    const double nm = std::stod(row[table.column("value")]);
    error.count(contact_patch(0.1e9, id == "F-patch-conf-0.1").top_displacement * 1e9 / nm - 1);
    ++found;
  }
  EXPECT_TRUE(
      of_solids("contact patch, sides free and held: top displacement", "another finite-element program")
          .below(error, 1e-6));
  EXPECT_EQ(found, 2);
}

/// An octant of the shell 1 <= r <= 2: three patches of a cube's surface, projected.
struct Shell {
  SmallSolid solid;
  Eigen::VectorXd unit_load;
  int inner_node = 0, outer_node = 0;
  static constexpr double a = 1, b = 2;

  Shell(int lateral, int radial, const J2Material& m) {
    std::vector<std::array<int, 4>> inner_faces;
    for (int patch = 0; patch < 3; ++patch) {
      std::vector<int> node((lateral + 1) * (lateral + 1) * (radial + 1));
      const auto index = [&](int i, int j, int k) -> int& {
        return node[(k * (lateral + 1) + j) * (lateral + 1) + i];
      };
      for (int k = 0; k <= radial; ++k)
        for (int j = 0; j <= lateral; ++j)
          for (int i = 0; i <= lateral; ++i) {
            const double s = std::tan(M_PI / 4 * i / lateral), t = std::tan(M_PI / 4 * j / lateral);
            const double r =
                a * std::pow(b / a, static_cast<double>(k) / radial) / std::sqrt(1 + s * s + t * t);
            Point p;
            p[patch] = r * s, p[(patch + 1) % 3] = r * t, p[(patch + 2) % 3] = r;
            index(i, j, k) = solid.node_at(p, 1e-7);
          }
      for (int k = 0; k < radial; ++k)
        for (int j = 0; j < lateral; ++j)
          for (int i = 0; i < lateral; ++i) {
            std::array<int, 8> vertices;
            for (int v = 0; v < 8; ++v) vertices[v] = index(i + (v & 1), j + ((v >> 1) & 1), k + (v >> 2));
            solid.add_cell(vertices, m);
            if (k == 0) inner_faces.push_back({vertices[0], vertices[1], vertices[2], vertices[3]});
          }
    }
    solid.finish();
    for (std::size_t i = 0; i < solid.nodes.size(); ++i)
      for (int c = 0; c < 3; ++c) solid.fixed[3 * i + c] = std::abs(solid.nodes[i][c]) < 1e-9;
    unit_load = Eigen::VectorXd::Zero(solid.size());
    for (const auto& f : inner_faces)
      for (int qy = 0; qy < 2; ++qy)
        for (int qx = 0; qx < 2; ++qx) {
          const double x = qx ? gauss_near : gauss_far, y = qy ? gauss_near : gauss_far;
          const double shape[4] = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
          const double dx[4] = {-(1 - y), 1 - y, -y, y}, dy[4] = {-(1 - x), -x, 1 - x, x};
          Eigen::Vector3d tx = Eigen::Vector3d::Zero(), ty = tx;
          for (int v = 0; v < 4; ++v) {
            const Eigen::Map<const Eigen::Vector3d> p(solid.nodes[f[v]].data());
            tx += dx[v] * p, ty += dy[v] * p;
          }
          const Eigen::Vector3d normal = tx.cross(ty);  // outwards, in the direction the pressure pushes
          for (int v = 0; v < 4; ++v) unit_load.segment<3>(3 * f[v]) += 0.25 * shape[v] * normal;
        }
    inner_node = solid.node_at({0, 0, a}, 1e-7);
    outer_node = solid.node_at({0, 0, b}, 1e-7);
  }
};

/// Elastic-perfectly plastic sphere under inner pressure with plastic radius c: Hill (1950), The Mathematical
/// Theory of Plasticity, ch. V.2. Pressure in units of Y, displacements in units of Y a / E.
struct Hill {
  double c;
  static constexpr double nu = 0.3, a = Shell::a, b = Shell::b;
  double pressure() const { return 2 * std::log(c / a) + 2.0 / 3 * (1 - std::pow(c / b, 3)); }
  double inner_displacement() const {
    return (1 - nu) * c * c * c / (a * a) -
           2.0 / 3 * (1 - 2 * nu) * a * (1 + 3 * std::log(c / a) - std::pow(c / b, 3));
  }
  double outer_displacement() const { return (1 - nu) * c * c * c / (b * b); }
};

struct ShellDisplacements {
  double inner, outer;  ///< radial, in units of Y a / E
};

/// The shell pressed step by step to each plastic radius.
std::vector<ShellDisplacements> press_shell(const std::vector<double>& plastic_radii, int lateral,
                                            int radial) {
  constexpr double youngs = 200e9, yield = 0.2e9;
  J2Material m = J2Material::elastic(youngs, Hill::nu);
  m.yield_stress = yield;
  Shell shell(lateral, radial, m);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(shell.solid.size());
  std::vector<ShellDisplacements> result;
  for (const double c : plastic_radii) {
    EXPECT_GE(shell.solid.solve(u, Hill{c}.pressure() * yield * shell.unit_load), 0)
        << "no equilibrium at c/a = " << c;
    shell.solid.accept(u);
    result.push_back(
        {u[3 * shell.inner_node + 2] * youngs / yield, u[3 * shell.outer_node + 2] * youngs / yield});
  }
  return result;
}

double largest_error(const std::vector<double>& radii, int lateral) {
  const auto found = press_shell(radii, lateral, 2 * lateral);
  double largest = 0;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Hill exact{radii[i]};
    const double inner = found[i].inner / exact.inner_displacement() - 1,
                 outer = found[i].outer / exact.outer_displacement() - 1;
    std::printf("%2d cells  c/a %.2f  u(a) %+.3f %%  u(b) %+.3f %%\n", lateral, radii[i], 100 * inner,
                100 * outer);
    largest = std::max({largest, std::abs(inner), std::abs(outer)});
  }
  return largest;
}

/// On `lateral` cells along an edge of each of the three patches and twice as many through the wall.
void expect_hill(const std::vector<double>& radii, int lateral) {
  const double coarse = largest_error(radii, lateral / 2), fine = largest_error(radii, lateral);
  char place[96];
  std::snprintf(place, sizeof place,
                "thick-walled sphere, c/a 1 to %g, %d cells along an edge: ", radii.back(), lateral);
  const auto verified = [&](const std::string& what) { return of_solids(place + what, "Hill (1950)"); };
  EXPECT_TRUE(verified("displacements inside and outside").below(100 * fine, 1, "%"));
  EXPECT_TRUE(verified("their error over that of half the cells").below(fine / coarse, 0.4));
}

TEST(HillSphere_analytic, displacements_of_a_half_yielded_sphere_are_within_one_percent_and_converge) {
  expect_hill({1.0, 1.1, 1.25, 1.4, 1.5}, 6);
}

TEST(HillSphereNightly_analytic, displacements_near_collapse_are_within_one_percent_and_converge) {
  expect_hill({1.0, 1.1, 1.25, 1.4, 1.5, 1.6, 1.7, 1.75}, 12);
}

TEST(HillSphere_other_code, formulas_agree_with_the_stored_table) {
  const auto path = asperity::test::reference_table("08_fe_table_hill_sphere.csv");
  const auto table = asperity::read_csv(path);
  const auto radii = table.numbers("c/a"), pressure = table.numbers("p/Y"),
             inner = table.numbers("u(a)E/(Y*a)"), outer = table.numbers("u(b)E/(Y*a)");
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Hill exact{radii[i]};
    EXPECT_NEAR(exact.pressure(), pressure[i], 1e-6);
    EXPECT_NEAR(exact.inner_displacement(), inner[i], 1e-6);
    EXPECT_NEAR(exact.outer_displacement(), outer[i], 1e-6);
  }
}

}  // namespace
