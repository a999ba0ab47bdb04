// The matrix-free operator of the contact system and its multigrid preconditioner.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "fem/contact/contact_solver.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;

ContactSystemOptions options_of_resolution(double cells_per_radius) {
  ContactSystemOptions o;
  constexpr double a = 230e-9;  // of silicon at 100 uN
  auto& s = o.mesh.sizes;
  s.radius = 8.5e-6, s.block_half_width = 6e-6;
  s.spacing_particle = s.spacing_substrate = a / cells_per_radius;
  s.offset_substrate_x = 0.3 * s.spacing_substrate;
  s.region_particle = 1.2 * a;
  s.region_substrate = 1.2 * a + 3 * s.spacing_substrate;
  o.materials = {J2Material::elastic(71e9, 0.17), J2Material::elastic(179e9, 0.25)};
  return o;
}

template <typename Number>
HexOperator<Number> closed_contact(ContactSystem& system, InterfaceOperator& interface) {
  HexOperator<Number> matrix(system.level(), system.positions(), system.options().materials);
  std::vector<RowStiffness> stiffness;
  for (const double area : system.areas()) stiffness.push_back(area * system.reduced_modulus() / 20e-9);
  interface.set_stiffness(stiffness);
  matrix.set_interface(&interface);
  return matrix;
}

template <typename Number>
Vector<Number> waves(const MeshLevel& level) {
  Vector<Number> x;
  level.initialise(x);
  for (unsigned i = 0; i < x.locally_owned_size(); ++i)
    x.local_element(i) = static_cast<Number>(std::sin(0.37 * i) + 0.2);
  for (const int c : level.constrained()) x.local_element(c) = 0;
  return x;
}

TEST(HexOperator_analytic, diagonal_is_that_of_the_operator) {
  ContactSystem system(MPI_COMM_WORLD, options_of_resolution(3));
  auto matrix = closed_contact<double>(system, system.interface());
  const auto diagonal = matrix.diagonal();
  std::vector<char> constrained(diagonal.locally_owned_size(), 0);
  for (const int c : system.level().constrained()) constrained[c] = 1;
  Vector<double> unit, column;
  system.level().initialise(unit);
  system.level().initialise(column);
  int checked = 0, off = 0;
  double factor = 1;
  for (unsigned i = 0; i < unit.locally_owned_size(); i += 29) {
    if (constrained[i]) continue;
    unit = 0.0;
    unit.local_element(i) = 1;
    matrix.vmult(column, unit);
    // Masters of hanging nodes leave out what couples two slaves of one cell: a few per cent of a smoother's
    // scale.
    const double ratio = diagonal.local_element(i) / column.local_element(i);
    ++checked;
    if (std::abs(ratio - 1) > 1e-9) ++off;
    ASSERT_GT(ratio, 0);
    factor = std::max({factor, ratio, 1 / ratio});
  }
  EXPECT_GT(checked, 100);
  const auto verified = [](const char* what) {
    return asperity::test::Verified{"Solver", what, "the operator's own column"};
  };
  EXPECT_TRUE(verified("diagonal: unknowns where it is not exact to 1e-9 (near hanging nodes)")
                  .below(100.0 * off / checked, 50, "%"));
  EXPECT_TRUE(verified("diagonal: largest factor by which it is off there").below(factor, 3));
}

TEST(HexOperator_analytic, is_symmetric_and_positive) {
  ContactSystem system(MPI_COMM_WORLD, options_of_resolution(3));
  auto matrix = closed_contact<double>(system, system.interface());
  auto x = waves<double>(system.level());
  Vector<double> y = x, ax, ay;
  for (unsigned i = 0; i < y.locally_owned_size(); ++i) y.local_element(i) *= std::cos(1.3 * i);
  system.level().initialise(ax);
  system.level().initialise(ay);
  matrix.vmult(ax, x);
  matrix.vmult(ay, y);
  for (const int c : system.level().constrained()) x.local_element(c) = y.local_element(c) = 0;
  const asperity::test::Verified symmetry{"Solver", "asymmetry of the operator", "none"};
  EXPECT_TRUE(symmetry.below((ax * y - ay * x) / (ax.l2_norm() * y.l2_norm()), 1e-12));
  EXPECT_GT(ax * x, 0);
}

TEST(HexOperator_analytic, single_precision_agrees_with_double) {
  ContactSystem system(MPI_COMM_WORLD, options_of_resolution(3));
  auto exact = closed_contact<double>(system, system.interface());
  auto single = closed_contact<float>(system, system.interface());
  const auto x = waves<double>(system.level());
  const auto x_single = waves<float>(system.level());
  Vector<double> y;
  Vector<float> y_single;
  system.level().initialise(y);
  system.level().initialise(y_single);
  exact.vmult(y, x);
  single.vmult(y_single, x_single);
  double difference = 0;
  for (unsigned i = 0; i < y.locally_owned_size(); ++i)
    difference = std::max(difference, std::abs(y.local_element(i) - y_single.local_element(i)));
  EXPECT_TRUE(
      (asperity::test::Verified{"Solver", "single against double precision", "double precision"}.below(
          difference / y.linfty_norm(), 1e-5)));
}

TEST(InterfaceOperator_analytic,
     uniform_pressure_on_the_curved_contact_transmits_its_whole_force_and_no_moment) {
  ContactSystem system(MPI_COMM_WORLD, options_of_resolution(4));
  std::vector<double> forces;
  double total = 0;
  for (const double area : system.areas()) forces.push_back(1e9 * area), total += forces.back();
  Vector<double> f;
  system.level().initialise(f);
  system.interface().add_forces(forces, f.begin());
  double upper = 0, lower = 0, moment = 0;
  for (unsigned i = 2; i < f.locally_owned_size(); i += 3) {
    (f.local_element(i) > 0 ? upper : lower) += f.local_element(i);
    moment += f.local_element(i) * system.positions().local_element(i - 2);
  }
  const auto verified = [](const char* what) {
    return asperity::test::Verified{"Element and coupling", what, "balance"};
  };
  EXPECT_TRUE(
      verified("uniform pressure on the curved contact, meshes that do not match: force of both sides")
          .below((upper + lower) / total, 1e-12));
  EXPECT_TRUE(
      verified("the same: moment, arm of the contact's radius").below(moment / total / 230e-9, 1e-12));
}

/// Conjugate gradient iterations that reduce a residual by 1e-8 with half of the contact closed.
std::pair<long, int> iterations(double cells_per_radius, const std::string& backend = "matrix-free") {
  auto chosen = options_of_resolution(cells_per_radius);
  chosen.backend = backend;
  ContactSystem system(MPI_COMM_WORLD, chosen);
  std::vector<RowStiffness> stiffness;
  const double eps = 2 * system.reduced_modulus() / system.options().mesh.sizes.spacing_particle;
  for (std::size_t r = 0; r < system.rows().size(); ++r) {
    const auto& p = system.interface_points()[system.rows()[r].node];
    stiffness.push_back(std::hypot(p[0], p[1]) < 230e-9 ? eps * system.areas()[r] : 0.0);
  }
  system.linear().update(stiffness, nullptr, 0.0);
  Vector<double> x, load;
  system.level().initialise(x);
  system.level().initialise(load);
  load.local_element(system.level().local_driven_dof()) = -1;
  const int count = system.linear().solve(x, load, 1e-8);
  std::printf("%s, unknowns %ld: %d iterations\n", backend.c_str(), static_cast<long>(system.level().size()),
              count);
  return {static_cast<long>(system.level().size()), count};
}

/// By half at most, from the coarse to the fine mesh.
testing::AssertionResult grow_little(const std::string& backend, const std::pair<long, int>& coarse,
                                     const std::pair<long, int>& fine) {
  const std::string what = "CG iterations for 1e-8, " + backend + ", " + std::to_string(fine.first) +
                           " unknowns: over those of " + std::to_string(coarse.first);
  return asperity::test::Verified{"Solver", what, "none"}.below(
      static_cast<double>(fine.second) / coarse.second, 1.5);
}

TEST(Multigrid_behaviour, iterations_hardly_grow_with_the_mesh) {
  const auto coarse = iterations(5), fine = iterations(10);
  EXPECT_TRUE(grow_little("matrix-free", coarse, fine));
  EXPECT_TRUE((asperity::test::Verified{
      "Solver", "CG iterations for 1e-8, matrix-free, half of the contact closed", "none"}
                   .below(fine.second, 39)));
}

TEST(Multigrid_behaviour, algebraic_iterations_hardly_grow_with_the_mesh) {
  const auto coarse = iterations(4, "assembled"), fine = iterations(8, "assembled");
  EXPECT_TRUE(grow_little("algebraic multigrid", coarse, fine));
  EXPECT_TRUE((asperity::test::Verified{
      "Solver", "CG iterations for 1e-8, algebraic multigrid, half of the contact closed", "none"}
                   .below(fine.second, 99)));
}

TEST(MultigridNightly_behaviour, iterations_grow_by_less_than_half_from_1e5_to_1e6_unknowns) {
  const auto coarse = iterations(12), middle = iterations(28), fine = iterations(60);
  EXPECT_TRUE(grow_little("matrix-free", coarse, middle));
  EXPECT_TRUE(grow_little("matrix-free", coarse, fine));
}

}  // namespace
