#include "fem/mesh_case.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::generated;
using test::sphere_on_silicon;

TEST(MeshCase_behaviour, writes_hexahedra_surfaces_and_tetrahedra_and_says_what_they_are_worth) {
  const test::TemporaryFolder folder;
  std::string said;
  mesh_case(sphere_on_silicon(generated(1.5, 80, 1), "smooth", 20e-9, 250e-9), folder.path / "meshes",
            [&](const std::string& line) { said += line + "\n"; });
  for (const char* file : {"hexahedra.vtu", "particle.stl", "particle.ply", "particle.off", "substrate.stl",
                           "substrate.ply", "substrate.off", "particle_tetrahedra.vtu",
                           "particle_tetrahedra.msh", "substrate_tetrahedra.vtu", "substrate_tetrahedra.msh"})
    EXPECT_TRUE(std::filesystem::exists(folder.path / "meshes" / file)) << file;
  for (const char* words : {"particle: smallest scaled Jacobian 0.", "substrate: smallest scaled Jacobian 0.",
                            "particle: Sq of the nodes", "nodes every 20 nm within ±250 nm",
                            "unknowns; to solve them takes about", "free of self-intersections"})
    EXPECT_NE(said.find(words), std::string::npos) << words << " is missing in\n" << said;

  // The file holds the cells that were counted.
  const auto count_before = [&](const std::string& name) {
    const auto at = said.find(name + ": ") + name.size() + 2;
    return std::stol(said.substr(at));
  };
  const long cells = count_before("particle") + count_before("substrate");
  EXPECT_GT(cells, 1000);
  const std::string vtu = read_file(folder.path / "meshes/hexahedra.vtu");
  EXPECT_NE(vtu.find("NumberOfCells=\"" + std::to_string(cells) + "\""), std::string::npos);
}

TEST(MeshCase_behaviour, roughness_too_steep_for_hexahedra_is_refused_with_a_remedy_and_leaves_no_files) {
  const test::TemporaryFolder folder;
  const auto steep = sphere_on_silicon("smooth", generated(60, 20, 1), 5e-9, 250e-9);
  const auto message = test::message_of<InputError>(
      [&] { mesh_case(steep, folder.path / "meshes", [](const std::string&) {}); });
  EXPECT_NE(message.find("test.prm: Substrate/Topography"), std::string::npos) << message;
  EXPECT_NE(message.find("scaled Jacobian"), std::string::npos) << message;
  EXPECT_NE(message.find("larger cutoff"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(folder.path / "meshes"));
}

/// A smooth sphere that adheres and rolls.
CaseInput rolling(double spacing, double distance) {
  CaseInput input = sphere_on_silicon("smooth", "smooth", spacing, 0);
  input.experiment.type = Motion::rolling;
  input.experiment.normal_load = 300e-6;
  input.experiment.distance = distance;
  input.interface.work_of_adhesion = 77e-3;
  input.interface.work_of_separation = 154e-3;
  input.interface.adhesion_law = "exponential";
  input.interface.parameters["Adhesion range"] = 1e-9;
  return input;
}

void expect_meshes(const CaseInput& input) {
  const test::TemporaryFolder folder;
  try {
    mesh_case(input, folder.path / "meshes", [](const std::string&) {});
    EXPECT_TRUE(std::filesystem::exists(folder.path / "meshes/substrate_tetrahedra.msh"));
  } catch (const std::exception& error) {
    ADD_FAILURE() << "spacing " << input.mesh.interface_spacing << " m, distance "
                  << input.experiment.distance << " m: " << error.what();
  }
}

TEST(MeshCase_behaviour, points_of_a_smooth_body_that_lie_on_one_sphere_do_not_stop_CGAL) {
  expect_meshes(rolling(34e-9, 450e-9));
}

TEST(MeshSweepNightly_regression, no_spacing_and_distance_is_refused) {
  for (int s = 0; s < 20; ++s)
    for (int d = 0; d < 10; ++d) expect_meshes(rolling((25 + 1.7 * s) * 1e-9, (0.15 + 0.31 * d) * 1e-6));
}

}  // namespace
}  // namespace asperity
