#include "meshing/triangles/surface_files.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/meshing/triangles/bodies.h"

namespace asperity::meshing {

namespace {

TriangleSurface rough_hemisphere() {
  const auto block =
      testing::hemisphere(12, 8.5e-6, [](double x, double y) { return testing::waves(x, y, 50e-9, 3e-6); });
  return triangles_of_quads(block.points, block.quads);
}

/// A surface as CGAL's own readers see the file, in metres.
TriangleSurface read_by_cgal(const std::filesystem::path& path, double units_per_metre) {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  EXPECT_TRUE(CGAL::IO::read_polygon_soup(path.string(), points, triangles)) << path;
  TriangleSurface surface;
  for (const auto& point : points)
    surface.points.push_back(
        {point.x() / units_per_metre, point.y() / units_per_metre, point.z() / units_per_metre});
  for (const auto& triangle : triangles)
    surface.triangles.push_back({static_cast<std::uint32_t>(triangle.at(0)),
                                 static_cast<std::uint32_t>(triangle.at(1)),
                                 static_cast<std::uint32_t>(triangle.at(2))});
  return surface;
}

class SurfaceFiles_other_code : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("asperity_surface_files_" + std::to_string(::getpid()));
};

void expect_same(const TriangleSurface& read, const TriangleSurface& written, double tolerance) {
  ASSERT_EQ(read.triangles.size(), written.triangles.size());
  for (std::size_t i = 0; i < read.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(read.points[read.triangles[i][corner]][axis],
                    written.points[written.triangles[i][corner]][axis], tolerance);
}

}  // namespace

TEST_F(SurfaceFiles_other_code, ply_is_read_back_point_by_point) {
  const auto surface = rough_hemisphere();
  write_ply(surface, file("body.ply"), LengthUnit::nanometre);
  const auto read = read_by_cgal(file("body.ply"), 1e9);
  ASSERT_EQ(read.points.size(), surface.points.size());
  EXPECT_EQ(read.triangles, surface.triangles);
  expect_same(read, surface, 1e-20);
}

TEST_F(SurfaceFiles_other_code, off_is_read_back_point_by_point) {
  const auto surface = rough_hemisphere();
  write_off(surface, file("body.off"));
  const auto read = read_by_cgal(file("body.off"), 1e6);
  EXPECT_EQ(read.triangles, surface.triangles);
  expect_same(read, surface, 1e-20);
}

TEST_F(SurfaceFiles_other_code, stl_is_read_back_to_single_precision) {
  const auto surface = rough_hemisphere();
  write_stl(surface, file("body.stl"));
  EXPECT_EQ(std::filesystem::file_size(file("body.stl")), 84 + 50 * surface.triangles.size());
  const auto read = read_by_cgal(file("body.stl"), 1e6);
  EXPECT_EQ(read.points.size(), surface.points.size()) << "shared points stay equal in single precision";
  expect_same(read, surface, 8.5e-6 * std::pow(2., -24) * 1.01);
}

TEST_F(SurfaceFiles_other_code, headers_name_the_unit) {
  const auto surface = testing::box(1e-6, 1e-6, 1e-6);
  write_stl(surface, file("body.stl"));
  write_ply(surface, file("body.ply"), LengthUnit::nanometre);
  write_off(surface, file("body.off"), LengthUnit::metre);
  const auto head = [&](const std::string& name) { return read_file(file(name)).substr(0, 90); };
  EXPECT_NE(head("body.stl").find("coordinates in um "), std::string::npos);
  EXPECT_NE(head("body.ply").find("coordinates in nm\n"), std::string::npos);
  EXPECT_NE(head("body.off").find("coordinates in m\n"), std::string::npos);
  EXPECT_THROW(write_off(surface, file("no/such/folder.off")), WorkError);
}

}  // namespace asperity::meshing
