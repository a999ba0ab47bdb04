#include "meshing/triangles/tetrahedra_files.h"

#include <algorithm>
#include <string>

#include "core/atomic_file.h"
#include "core/base64.h"
#include "meshing/triangles/binary_text.h"
#include "meshing/triangles/quality.h"

namespace asperity::meshing {

namespace {

/// One <DataArray>: the array's length in bytes, then the array, together in base64.
std::string data_array(const std::string& attributes, const std::string& bytes) {
  std::string block;
  append_bytes(block, static_cast<std::uint64_t>(bytes.size()));
  return "<DataArray " + attributes + " format=\"binary\">\n" + base64(block + bytes) + "\n</DataArray>\n";
}

}  // namespace

void write_vtu(const TetrahedralMesh& mesh, const std::filesystem::path& path, LengthUnit unit) {
  constexpr std::uint8_t vtk_tetra = 10;
  std::string coordinates, connectivity, offsets, types, ratios;
  for (const auto& point : mesh.points)
    for (const double coordinate : point) append_bytes(coordinates, coordinate * per_metre(unit));
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    for (const auto index : mesh.tetrahedra[i]) append_bytes(connectivity, static_cast<std::int64_t>(index));
    append_bytes(offsets, static_cast<std::int64_t>(4 * (i + 1)));
    append_bytes(types, vtk_tetra);
    append_bytes(ratios, radius_ratio(mesh.corners(i)));
  }
  const std::string content =
      std::string("<?xml version=\"1.0\"?>\n<!-- by asperity, coordinates in ") + symbol(unit) +
      " -->\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
      std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" + std::to_string(mesh.tetrahedra.size()) +
      "\">\n<Points>\n" +
      data_array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", coordinates) +
      "</Points>\n<Cells>\n" + data_array("type=\"Int64\" Name=\"connectivity\"", connectivity) +
      data_array("type=\"Int64\" Name=\"offsets\"", offsets) +
      data_array("type=\"UInt8\" Name=\"types\"", types) + "</Cells>\n<CellData Scalars=\"radius_ratio\">\n" +
      data_array("type=\"Float64\" Name=\"radius_ratio\"", ratios) +
      "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  write_file_atomically(path, content);
}

void write_msh(const TetrahedralMesh& mesh, const std::filesystem::path& path, LengthUnit unit) {
  constexpr int msh_triangle = 2, msh_tetrahedron = 4, body = 1;
  const int patches = mesh.patch.empty() ? 0 : *std::max_element(mesh.patch.begin(), mesh.patch.end());
  std::string content = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nby asperity, coordinates in " +
                        std::string(symbol(unit)) + "\n$EndComments\n$PhysicalNames\n" +
                        std::to_string(patches + 1) + "\n";
  for (int patch = 1; patch <= patches; ++patch)
    content += "2 " + std::to_string(patch) + " \"patch_" + std::to_string(patch) + "\"\n";
  content += "3 " + std::to_string(body) + " \"body\"\n$EndPhysicalNames\n$Nodes\n" +
             std::to_string(mesh.points.size()) + "\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    content += std::to_string(i + 1);
    for (const double coordinate : mesh.points[i]) {
      content += ' ';
      append_number(content, coordinate * per_metre(unit));
    }
    content += '\n';
  }
  content += "$EndNodes\n$Elements\n" + std::to_string(mesh.boundary.size() + mesh.tetrahedra.size()) + "\n";
  std::size_t number = 0;
  const auto add = [&](int type, int group,
                       const auto& indices) {  // two tags: physical and elementary entity
    content += std::to_string(++number) + " " + std::to_string(type) + " 2 " + std::to_string(group) + " " +
               std::to_string(group);
    for (const auto index : indices) content += " " + std::to_string(index + 1);
    content += '\n';
  };
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) add(msh_triangle, mesh.patch[i], mesh.boundary[i]);
  for (const auto& tetrahedron : mesh.tetrahedra) add(msh_tetrahedron, body, tetrahedron);
  content += "$EndElements\n";
  write_file_atomically(path, content);
}

}  // namespace asperity::meshing
