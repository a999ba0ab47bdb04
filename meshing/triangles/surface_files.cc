#include "meshing/triangles/surface_files.h"

#include <string>

#include "core/atomic_file.h"
#include "meshing/triangles/binary_text.h"
#include "meshing/triangles/vectors.h"

namespace asperity::meshing {

void write_stl(const TriangleSurface& surface, const std::filesystem::path& path, LengthUnit unit) {
  constexpr std::size_t header_bytes = 80, bytes_per_triangle = 50;
  const double scale = per_metre(unit);
  std::string content = std::string("binary STL by asperity, coordinates in ") + symbol(unit);
  content.resize(header_bytes, ' ');
  content.reserve(header_bytes + 4 + bytes_per_triangle * surface.triangles.size());
  append_bytes(content, static_cast<std::uint32_t>(surface.triangles.size()));
  for (const auto& triangle : surface.triangles) {
    std::array<Point, 3> corner;
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis) corner[i][axis] = surface.points[triangle[i]][axis] * scale;
    const Vector twice_area = cross(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
    const double length = norm(twice_area);
    for (const double component : twice_area)
      append_bytes(content, static_cast<float>(length > 0 ? component / length : 0));
    for (const auto& point : corner)
      for (const double coordinate : point) append_bytes(content, static_cast<float>(coordinate));
    append_bytes(content, std::uint16_t{0});
  }
  write_file_atomically(path, content);
}

void write_ply(const TriangleSurface& surface, const std::filesystem::path& path, LengthUnit unit) {
  const double scale = per_metre(unit);
  std::string content =
      std::string("ply\nformat binary_little_endian 1.0\ncomment by asperity, coordinates in ") +
      symbol(unit) + "\nelement vertex " + std::to_string(surface.points.size()) +
      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
      std::to_string(surface.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& point : surface.points)
    for (const double coordinate : point) append_bytes(content, coordinate * scale);
  for (const auto& triangle : surface.triangles) {
    append_bytes(content, std::uint8_t{3});
    for (const auto index : triangle) append_bytes(content, static_cast<std::int32_t>(index));
  }
  write_file_atomically(path, content);
}

void write_off(const TriangleSurface& surface, const std::filesystem::path& path, LengthUnit unit) {
  const double scale = per_metre(unit);
  std::string content = std::string("OFF\n# by asperity, coordinates in ") + symbol(unit) + "\n" +
                        std::to_string(surface.points.size()) + " " +
                        std::to_string(surface.triangles.size()) + " 0\n";
  for (const auto& point : surface.points)
    for (int axis = 0; axis < 3; ++axis) {
      append_number(content, point[axis] * scale);
      content += axis < 2 ? ' ' : '\n';
    }
  for (const auto& [a, b, c] : surface.triangles)
    content += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  write_file_atomically(path, content);
}

}  // namespace asperity::meshing
