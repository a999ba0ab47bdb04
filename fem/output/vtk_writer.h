// VTK XML files with raw binary data that ParaView opens: an unstructured grid (.vtu) or polygons (.vtp) and
// a series (.pvd).
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace asperity::fem {

/// One array of point or cell data.
struct VtkArray {
  std::string name;
  int components = 1;
  std::vector<float> values;
  std::string unit = {};  ///< empty: a number; "units" of the field data lists them
};

/// What a file says of its data as a whole, in the field data.
struct VtkNotes {
  std::vector<std::pair<std::string, double>> numbers;
  std::vector<std::pair<std::string, std::string>> texts;
};

/// Points [m] and hexahedra (VTK order) or quadrilaterals.
struct VtkMesh {
  std::vector<double> points;     ///< x y z of each
  std::vector<int> connectivity;  ///< 8 or 4 per cell
  int points_per_cell = 8;
  std::vector<VtkArray> point_data, cell_data;
  VtkNotes notes;
};

/// Writes a .vtu (8 points per cell) or .vtp (4), in one step.
void write_vtk(const std::filesystem::path& path, const VtkMesh& mesh);
/// A time series of files beside it; the same step may have several parts (one per rank).
void write_pvd(const std::filesystem::path& path,
               const std::vector<std::pair<double, std::vector<std::string>>>& files);

}  // namespace asperity::fem
