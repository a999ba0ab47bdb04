// What the multigrid does in another way than the operator that it approximates: cells as parallelepipeds,
// siblings read at once, touched interface nodes alone, a part of a level alone.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "fem/cells/hex_kernel.h"
#include "fem/contact/contact_solver.h"
#include "fem/solver/smoothed_part.h"
#include "tests/fem/support/small_contact.h"

namespace {

using namespace asperity::fem;

template <typename Number>
Vector<Number> rough_field(const MeshLevel& level) {
  Vector<Number> x;
  level.initialise(x);
  for (unsigned i = 0; i < x.locally_owned_size(); ++i)
    x.local_element(i) = static_cast<Number>(std::sin(0.71 * i) + 0.3 * std::cos(0.013 * i));
  for (const int c : level.constrained()) x.local_element(c) = 0;
  return x;
}

TEST(Parallelepiped_analytic, forces_are_those_of_the_points_of_a_sheared_cell) {
  using V = Simd<double>;
  const double jacobian[3][3] = {{1.1, 0.2, -0.3}, {0.1, 0.8, 0.25}, {-0.15, 0.3, 1.3}};
  V position[3][8], u[3][8], forces[3][8];
  for (int v = 0; v < vertices_per_hex; ++v)
    for (int c = 0; c < 3; ++c)
      for (int l = 0; l < lanes; ++l) {
        position[c][v][l] = 0;
        for (int d = 0; d < 3; ++d) position[c][v][l] += (1 + 0.1 * l) * jacobian[c][d] * ((v >> d) & 1);
        u[c][v][l] = forces[c][v][l] = std::sin(1.0 + 3 * v + 1.7 * c + 0.9 * l);
      }
  constexpr double shear = 2.3, bulk = 3.1;
  HexStrain<V> strain;
  evaluate_geometry<double>(position, strain);
  Parallelepiped<V> cell;
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c)
      cell.gradient[d][c] =
          0.25 * square_root(V(shear * strain.cell_volume)) * strain.inverse_jacobian[0][3 * d + c];
  cell.bulk_ratio = V{} + bulk / shear;
  parallelepiped_forces<double>(cell, forces);
  evaluate_strain<double>(u, strain);
  std::array<SymmetricTensor<V>, points_per_hex> stress;
  for (int q = 0; q < points_per_hex; ++q)
    for (int c = 0; c < 6; ++c) stress[q][c] = 2 * shear * strain.deviator[q][c];
  integrate_stress<double>(strain, stress, V(bulk * strain.dilatation), u);
  double off = 0, largest = 0;
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < vertices_per_hex; ++v)
      for (int l = 0; l < lanes; ++l) {
        off = std::max(off, std::abs(forces[c][v][l] - u[c][v][l]));
        largest = std::max(largest, std::abs(u[c][v][l]));
      }
  EXPECT_LT(off / largest, 1e-13);
}

TEST(SiblingPatch_behaviour, values_of_two_patches_are_those_of_their_nodes_there_and_back) {
  PatchNodes a, b;
  for (int s = 0; s < 28; ++s) a[s] = (7 * std::min(s, 26)) % 60, b[s] = 60 - std::min(s, 26);
  std::vector<float> field(3 * 61 + 1), sum(field.size(), 0), expected(field.size(), 0);
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = static_cast<float>(std::sin(0.3 * i));
  Sixteen values[3][8];
  PatchGrid of_a[3], of_b[3];
  load_patch(a, field.data(), of_a);
  load_patch(b, field.data(), of_b);
  to_vertices(of_a, of_b, values);
  for (int c = 0; c < 3; ++c)
    for (int v = 0; v < vertices_per_hex; ++v)
      for (int l = 0; l < 16; ++l) {
        const int node = (l < 8 ? a : b)[patch_site(l % 8, v)];
        ASSERT_EQ(values[c][v][l], field[3 * node + c]);
        values[c][v][l] = static_cast<float>(l + 16 * v);  // sums are exact
        expected[3 * node + c] += values[c][v][l];
      }
  add_patch<0>(a, values, sum.data());
  add_patch<8>(b, values, sum.data());
  EXPECT_EQ(sum, expected);
}

TEST(ParallelepipedBatches_behaviour, energies_of_a_contact_mesh_are_nearly_those_of_its_cells) {
  ContactSystem system(MPI_COMM_WORLD, asperity::test::small_contact());
  const HexOperator<float> exact(system.level(), system.positions(), system.options().materials);
  HexOperator<float> near(system.level(), system.positions(), system.options().materials);
  near.take_cells_as_parallelepipeds();
  const auto x = rough_field<float>(system.level());
  Vector<float> y, z;
  system.level().initialise(y);
  system.level().initialise(z);
  exact.vmult(y, x);
  near.vmult(z, x);
  const double ratio = static_cast<double>(x * z) / static_cast<double>(x * y);
  EXPECT_NEAR(ratio, 1, 0.02);
  EXPECT_NE(ratio, 1);  // another way indeed
}

TEST(InterfaceOperator_analytic, few_active_rows_act_as_their_jumps_and_forces) {
  ContactSystem system(MPI_COMM_WORLD, asperity::test::small_contact());
  InterfaceOperator& interface = system.interface();
  interface.set_rotation(rotation({0, 0, 0.3, 0.02}));
  std::vector<RowStiffness> stiffness(interface.rows());
  for (int r = 0; r < interface.rows(); r += 7) stiffness[r].normal = 3.0 + r, stiffness[r].xx = 1.5;
  interface.set_stiffness(stiffness);
  const auto x = rough_field<double>(system.level());
  Vector<double> y, expected;
  system.level().initialise(y);
  system.level().initialise(expected);
  interface.apply(x.begin(), y.begin());
  for (const int component : {0, 2}) {
    std::vector<double> forces = interface.jumps(x.begin(), component);
    for (std::size_t r = 0; r < forces.size(); ++r)
      forces[r] *= component == 0 ? stiffness[r].xx : stiffness[r].normal;
    interface.add_forces(forces, expected.begin(), component);
  }
  const double size = expected.l2_norm();
  ASSERT_GT(size, 0);
  expected -= y;
  EXPECT_LT(expected.l2_norm() / size, 1e-13);
}

TEST(InterfaceOperator_analytic, many_tilted_rows_on_few_coarse_nodes_act_as_their_jumps_and_forces) {
  ContactSystemOptions options = asperity::test::small_contact();
  options.mesh.sizes.spacing_particle = options.mesh.sizes.spacing_substrate = 20e-9;
  ContactSystem system(MPI_COMM_WORLD, options);
  const auto forest = asperity::meshing::make_forest(MPI_COMM_WORLD, options.mesh, 6);
  const MeshLevel level(*forest, options.control);
  std::vector<GapRow> rows = system.rows();
  for (std::size_t r = 0; r < rows.size(); ++r) rows[r].slope = {0.3 * std::sin(0.1 * r), 0.2};
  InterfaceOperator interface(level, rows, system.interface().nodes());
  interface.set_rotation(rotation({0, 0, 0.3, 0.02}));
  std::vector<RowStiffness> stiffness(rows.size());
  std::size_t entries = 0;
  std::set<int> touched;
  for (int r = 0; r < interface.rows(); ++r) {
    stiffness[r].normal = 3.0 + r % 5, stiffness[r].xx = 1.5, stiffness[r].xy = -0.4, stiffness[r].yy = 0.9;
    interface.for_row(r, [&](int node, double) { ++entries, touched.insert(node); });
  }
  interface.set_stiffness(stiffness);
  ASSERT_LT(3 * touched.size() * touched.size(), 2 * entries);  // few indeed
  const auto x = rough_field<double>(level);
  const auto of_floats = rough_field<float>(level);
  Vector<double> expected;
  Vector<float> y;
  level.initialise(expected);
  level.initialise(y);
  interface.apply(of_floats.begin(), y.begin());
  std::array<std::vector<double>, 3> jump, force;
  for (int c = 0; c < 3; ++c) jump[c] = force[c] = interface.jumps(x.begin(), c);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto& k = stiffness[r];
    const auto& m = rows[r].slope;
    force[2][r] = k.normal * (jump[2][r] + m[0] * jump[0][r] + m[1] * jump[1][r]);
    force[0][r] = k.xx * jump[0][r] + k.xy * jump[1][r] + m[0] * force[2][r];
    force[1][r] = k.xy * jump[0][r] + k.yy * jump[1][r] + m[1] * force[2][r];
  }
  for (int c = 0; c < 3; ++c) interface.add_forces(force[c], expected.begin(), c);
  double off = 0;
  for (unsigned i = 0; i < y.locally_owned_size(); ++i)
    off = std::max(off, std::abs(static_cast<double>(y.local_element(i)) - expected.local_element(i)));
  ASSERT_GT(expected.linfty_norm(), 0);
  EXPECT_LT(off / expected.linfty_norm(), 1e-5);
}

TEST(ConstraintLines_other_code,
     hanging_nodes_and_planes_are_those_of_deal_ii_and_condensing_is_the_transpose) {
  ContactSystem system(MPI_COMM_WORLD, asperity::test::small_contact());
  const MeshLevel& level = system.level();
  auto free = rough_field<double>(level), whole = free, expected = free;
  level.distribute(whole.begin());
  level.constraints().distribute(expected);
  expected -= whole;
  EXPECT_LT(expected.linfty_norm(), 1e-14);
  EXPECT_GT(whole.l2_norm(), 1.05 * free.l2_norm());  // many hang
  // <C x, y> = <x, C^T y>
  Vector<double> forces;
  level.initialise(forces);
  for (unsigned i = 0; i < forces.locally_owned_size(); ++i) forces.local_element(i) = std::cos(1.3 * i);
  const double before = whole * forces;
  level.condense(forces.begin());
  EXPECT_NEAR(free * forces / before, 1, 1e-12);
  for (const int c : level.constrained()) ASSERT_EQ(forces.local_element(c), 0);
}

TEST(HexOperator_behaviour, diagonal_follows_the_interface_when_it_changes) {
  ContactSystem system(MPI_COMM_WORLD, asperity::test::small_contact());
  InterfaceOperator& interface = system.interface();
  HexOperator<double> kept(system.level(), system.positions(), system.options().materials);
  kept.set_interface(&interface);
  for (const double first : {5.0, 2e3}) {
    std::vector<RowStiffness> stiffness(interface.rows());
    for (int r = 0; r < interface.rows(); r += 3) stiffness[r].normal = first + r;
    interface.set_stiffness(stiffness);
    HexOperator<double> anew(system.level(), system.positions(), system.options().materials);
    anew.set_interface(&interface);
    Vector<double> difference = kept.diagonal();
    difference -= anew.diagonal();
    EXPECT_EQ(difference.linfty_norm(), 0);
  }
}

TEST(SmoothedPart_behaviour, residuals_of_what_is_smoothed_are_those_of_the_whole_level) {
  const ContactSystemOptions options = asperity::test::small_contact();
  ContactSystem system(MPI_COMM_WORLD, options);
  const MeshLevel& fine = system.level();
  const auto forest = asperity::meshing::make_forest(MPI_COMM_WORLD, options.mesh, 1);
  const MeshLevel coarse(*forest, options.control);
  const SmoothedPart part = smoothed_part(fine, LevelTransfer(fine, coarse));
  HexOperator<float> whole(fine, system.positions(), options.materials),
      smoothed(fine, system.positions(), options.materials);
  smoothed.set_part(part.batch);
  auto x = rough_field<float>(fine);
  Vector<float> all, some;
  fine.initialise(all);
  fine.initialise(some);
  const auto largest_difference = [&](bool of_smoothed_nodes_alone) {
    whole.vmult(all, x);
    smoothed.vmult(some, x);
    float largest = 0;
    for (unsigned i = 0; i < all.locally_owned_size(); ++i)
      if (!of_smoothed_nodes_alone || part.node[i / 3])
        largest = std::max(largest, std::abs(all.local_element(i) - some.local_element(i)));
    return largest / all.linfty_norm();
  };
  EXPECT_LT(largest_difference(true), 1e-5);  // smoothing after the coarse correction
  EXPECT_GT(largest_difference(false), 1e-2);
  int left_out = 0;
  for (unsigned i = 0; i < x.locally_owned_size(); ++i)
    if (!part.node[i / 3]) x.local_element(i) = 0, ++left_out;
  EXPECT_GT(left_out, 1000);
  EXPECT_LT(largest_difference(false), 1e-5);  // smoothing before it, from zero
}

}  // namespace
