#include "meshing/triangles/export.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "core/atomic_file.h"
#include "core/error.h"
#include "meshing/triangles/quality.h"
#include "tests/meshing/triangles/bodies.h"

namespace asperity::meshing {

namespace {

class Export_behaviour : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("asperity_export_" + std::to_string(::getpid()));
};

TetrahedralMesh small_mesh() {
  TetrahedraOptions options;
  options.fine_size = 0.2e-6;
  return tetrahedra(testing::box(1e-6, 1e-6, 1e-6, 2), options);
}

std::string decode_base64(const std::string& text) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char letter : text) {
    const int value = letter >= 'A' && letter <= 'Z'   ? letter - 'A'
                      : letter >= 'a' && letter <= 'z' ? letter - 'a' + 26
                      : letter >= '0' && letter <= '9' ? letter - '0' + 52
                      : letter == '+'                  ? 62
                      : letter == '/'                  ? 63
                                                       : -1;
    if (value < 0) continue;
    group = group << 6 | static_cast<std::uint32_t>(value);
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes += static_cast<char>(group >> bits & 255u);
    }
  }
  return bytes;
}

/// Values of a named DataArray of a VTU.
template <class Number>
std::vector<Number> vtu_array(const std::string& content, const std::string& name) {
  const auto start = content.find('\n', content.find("Name=\"" + name + "\"")) + 1;
  const std::string bytes = decode_base64(content.substr(start, content.find('\n', start) - start));
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  EXPECT_EQ(bytes.size(), sizeof size + size) << name;
  std::vector<Number> values(size / sizeof(Number));
  std::memcpy(values.data(), bytes.data() + sizeof size, size);
  return values;
}

}  // namespace

TEST_F(Export_behaviour, vtu_holds_the_mesh_in_the_unit_it_names) {
  const auto mesh = small_mesh();
  write_tetrahedra(mesh, file("body.vtu"), LengthUnit::nanometre);
  const std::string content = read_file(file("body.vtu"));
  EXPECT_NE(content.find("coordinates in nm"), std::string::npos);
  const auto coordinates = vtu_array<double>(content, "Points");
  const auto connectivity = vtu_array<std::int64_t>(content, "connectivity");
  const auto offsets = vtu_array<std::int64_t>(content, "offsets");
  const auto types = vtu_array<std::uint8_t>(content, "types");
  const auto ratios = vtu_array<double>(content, "radius_ratio");
  ASSERT_EQ(coordinates.size(), 3 * mesh.points.size());
  ASSERT_EQ(connectivity.size(), 4 * mesh.tetrahedra.size());
  ASSERT_EQ(ratios.size(), mesh.tetrahedra.size());
  EXPECT_EQ(offsets.back(), static_cast<std::int64_t>(connectivity.size()));
  EXPECT_EQ(types, std::vector<std::uint8_t>(mesh.tetrahedra.size(), 10));
  double volume_in_nm3 = 0;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    std::array<Point, 4> corners;
    for (int corner = 0; corner < 4; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        corners[corner][axis] = coordinates[3 * connectivity[4 * i + corner] + axis];
    volume_in_nm3 += volume(corners);
    EXPECT_NEAR(radius_ratio(corners), ratios[i], 1e-9);
  }
  EXPECT_NEAR(volume_in_nm3, 1e9, 1e9 * 1e-6);
}

TEST_F(Export_behaviour, msh_holds_the_mesh_and_its_named_patches) {
  const auto mesh = small_mesh();
  write_tetrahedra(mesh, file("body.msh"));
  std::istringstream content(read_file(file("body.msh")));
  std::string line;
  std::vector<Point> points;
  std::size_t names = 0, triangles = 0;
  double volume_in_um3 = 0;
  while (std::getline(content, line)) {
    std::size_t count = 0;
    if (line == "$PhysicalNames") {
      content >> names;
    } else if (line == "$Nodes") {
      content >> count;
      points.resize(count);
      std::size_t number = 0;
      for (auto& [x, y, z] : points) content >> number >> x >> y >> z;
      EXPECT_EQ(number, count);
    } else if (line == "$Elements") {
      content >> count;
      EXPECT_EQ(count, mesh.boundary.size() + mesh.tetrahedra.size());
      for (std::size_t i = 0; i < count; ++i) {
        int number = 0, type = 0, tags = 0, physical = 0, elementary = 0;
        content >> number >> type >> tags >> physical >> elementary;
        ASSERT_TRUE(type == 2 || type == 4);
        std::array<std::size_t, 4> node{};
        for (int corner = 0; corner < (type == 2 ? 3 : 4); ++corner) content >> node[corner];
        if (type == 2) {
          EXPECT_EQ(physical, mesh.patch[triangles++]);
        } else {
          volume_in_um3 += volume({points.at(node[0] - 1), points.at(node[1] - 1), points.at(node[2] - 1),
                                   points.at(node[3] - 1)});
        }
      }
    }
  }
  EXPECT_EQ(names, 7u) << "six faces and the body";
  EXPECT_EQ(points.size(), mesh.points.size());
  EXPECT_EQ(triangles, mesh.boundary.size());
  EXPECT_NEAR(volume_in_um3, 1, 1e-6);
}

TEST_F(Export_behaviour, format_follows_the_extension) {
  const auto surface = testing::box(1e-6, 1e-6, 1e-6);
  for (const std::string name : {"body.stl", "body.ply", "body.off"}) {
    write_surface(surface, file(name));
    EXPECT_GT(std::filesystem::file_size(file(name)), 100u) << name;
  }
  EXPECT_EQ(read_file(file("body.ply")).substr(0, 3), "ply");
  EXPECT_EQ(read_file(file("body.off")).substr(0, 3), "OFF");
  EXPECT_THROW(write_surface(surface, file("body.obj")), InputError);
  EXPECT_THROW(write_tetrahedra(TetrahedralMesh{}, file("body.stl")), InputError);
}

TEST_F(Export_behaviour, summary_says_what_the_body_is_or_what_it_lacks) {
  auto surface = testing::box(1e-6, 2e-6, 3e-6);
  EXPECT_EQ(summary("substrate", surface, check_surface(surface)),
            "substrate surface: 12 triangles, 8 points, 1 piece, area 22 um^2, volume 6 um^3\n"
            "substrate surface: closed, manifold, outward, free of self-intersections\n");
  surface.triangles.pop_back();
  EXPECT_NE(summary("substrate", surface, check_surface(surface)).find("not a body: 3 open edges\n"),
            std::string::npos);
  const auto mesh = small_mesh();
  const auto text = summary("particle", mesh, quality(mesh), 1e-18);
  EXPECT_NE(text.find("particle tetrahedra: " + std::to_string(mesh.tetrahedra.size()) + " with"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("dihedral angle"), std::string::npos) << text;
}

}  // namespace asperity::meshing
