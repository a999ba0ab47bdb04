#include "fem/output/vtk_writer.h"

#include <cstdint>
#include <iomanip>
#include <sstream>

#include "core/atomic_file.h"

namespace asperity::fem {
namespace {

/// Collects raw blocks and hands out their offsets.
class Appended {
 public:
  template <typename T>
  std::size_t add(const std::vector<T>& values) {
    const std::size_t offset = bytes_.size();
    const std::uint64_t size = values.size() * sizeof(T);
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size);
    return offset;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

void describe(std::ostringstream& xml, const std::vector<VtkArray>& arrays, const char* element,
              Appended& data) {
  xml << "<" << element << ">\n";
  for (const auto& array : arrays)
    xml << "<DataArray type=\"Float32\" Name=\"" << array.name << "\" NumberOfComponents=\""
        << array.components << "\" format=\"appended\" offset=\"" << data.add(array.values) << "\"/>\n";
  xml << "</" << element << ">\n";
}

/// Texts stand in VTK's files as the codes of their bytes, each with a 0 behind it.
void describe_texts(std::ostringstream& xml, const std::string& name, const std::vector<std::string>& texts) {
  xml << "<DataArray type=\"String\" Name=\"" << name << "\" NumberOfTuples=\"" << texts.size()
      << "\" format=\"ascii\">\n";
  for (const auto& text : texts) {
    for (const unsigned char byte : text) xml << static_cast<int>(byte) << ' ';
    xml << "0\n";
  }
  xml << "</DataArray>\n";
}

void describe_notes(std::ostringstream& xml, const VtkMesh& mesh) {
  xml << "<FieldData>\n";
  for (const auto& [name, number] : mesh.notes.numbers)
    xml << "<DataArray type=\"Float64\" Name=\"" << name << "\" NumberOfTuples=\"1\" format=\"ascii\">"
        << std::setprecision(6) << number << "</DataArray>\n";
  for (const auto& [name, text] : mesh.notes.texts) describe_texts(xml, name, {text});
  std::vector<std::string> units;
  for (const auto* arrays : {&mesh.point_data, &mesh.cell_data})
    for (const auto& array : *arrays)
      if (!array.unit.empty()) units.push_back(array.name + " [" + array.unit + "]");
  describe_texts(xml, "units", units);
  xml << "</FieldData>\n";
}

}  // namespace

void write_vtk(const std::filesystem::path& path, const VtkMesh& mesh) {
  const bool grid = mesh.points_per_cell == 8;
  const char* type = grid ? "UnstructuredGrid" : "PolyData";
  const std::size_t cells = mesh.connectivity.size() / mesh.points_per_cell;
  std::vector<std::int32_t> offsets(cells);
  for (std::size_t c = 0; c < cells; ++c)
    offsets[c] = static_cast<std::int32_t>((c + 1) * mesh.points_per_cell);
  Appended data;
  std::ostringstream xml;
  xml << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
      << "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" << type << ">\n";
  describe_notes(xml, mesh);
  xml << "<Piece NumberOfPoints=\"" << mesh.points.size() / 3 << "\" "
      << (grid ? "NumberOfCells" : "NumberOfPolys") << "=\"" << cells << "\">\n";
  describe(xml, mesh.point_data, "PointData", data);
  describe(xml, mesh.cell_data, "CellData", data);
  xml << "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\""
      << data.add(mesh.points) << "\"/>\n</Points>\n<" << (grid ? "Cells" : "Polys")
      << ">\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"appended\" offset=\""
      << data.add(mesh.connectivity)
      << "\"/>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"appended\" offset=\"" << data.add(offsets)
      << "\"/>\n";
  if (grid)
    xml << "<DataArray type=\"UInt8\" Name=\"types\" format=\"appended\" offset=\""
        << data.add(std::vector<std::uint8_t>(cells, 12)) << "\"/>\n";
  xml << "</" << (grid ? "Cells" : "Polys") << ">\n</Piece>\n</" << type
      << ">\n<AppendedData encoding=\"raw\">\n_";
  write_file_atomically(path, xml.str() + data.bytes() + "\n</AppendedData>\n</VTKFile>\n");
}

void write_pvd(const std::filesystem::path& path,
               const std::vector<std::pair<double, std::vector<std::string>>>& files) {
  std::ostringstream xml;
  xml << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto& [time, parts] : files)
    for (std::size_t p = 0; p < parts.size(); ++p)
      xml << "<DataSet timestep=\"" << time << "\" part=\"" << p << "\" file=\"" << parts[p] << "\"/>\n";
  xml << "</Collection>\n</VTKFile>\n";
  write_file_atomically(path, xml.str());
}

}  // namespace asperity::fem
