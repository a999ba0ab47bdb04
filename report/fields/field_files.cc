#include "report/fields/field_files.h"

#include <vtkAppendPolyData.h>
#include <vtkCutter.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProbeFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <array>
#include <cmath>
#include <limits>
#include <regex>

#include "core/atomic_file.h"
#include "core/error.h"

namespace asperity::report {
namespace {

namespace fs = std::filesystem;

template <class DataSet>
vtkSmartPointer<DataSet> read_data(const fs::path& file) {
  vtkNew<vtkXMLGenericDataObjectReader> reader;
  reader->SetFileName(file.c_str());
  if (fs::exists(file)) reader->Update();
  auto* data = fs::exists(file) ? DataSet::SafeDownCast(reader->GetOutput()) : nullptr;
  if (!data || data->GetNumberOfCells() == 0)
    throw InputError(file.string() + ": cannot be read as VTK data; solve the case again to have its fields");
  return data;
}

vtkDataArray* point_array(vtkDataSet& data, const std::string& name, const fs::path& file) {
  vtkDataArray* array = data.GetPointData()->GetArray(name.c_str());
  if (!array) throw InputError(file.string() + ": has no point data '" + name + "'");
  return array;
}

/// Place of the particle's axis [m], which figures are drawn about; 0 where the file does not say it.
std::array<double, 2> axis_of(vtkDataSet& data) {
  const auto number = [&](const char* name) {
    vtkDataArray* array = data.GetFieldData()->GetArray(name);
    return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0;
  };
  return {number("axis x [m]"), number("axis y [m]")};
}

}  // namespace

std::map<int, StepFiles> field_files(const fs::path& pvd) {
  std::map<int, StepFiles> files;
  if (!fs::exists(pvd)) return files;
  const std::string text = read_file(pvd);
  static const std::regex entry("file\\s*=\\s*\"([^\"]+)\""), step_name("step_(\\d+)");
  for (std::sregex_iterator at(text.begin(), text.end(), entry), end; at != end; ++at) {
    const std::string name = (*at)[1];
    std::smatch step;
    const fs::path path = pvd.parent_path() / name;
    if (std::regex_search(name, step, step_name) && fs::exists(path))
      files[std::stoi(step[1])].push_back(path);
  }
  return files;
}

Map interface_map(const fs::path& file, const std::string& array, double half_width, int pixels) {
  const auto surface = read_data<vtkPolyData>(file);
  point_array(*surface, array, file);
  const auto axis = axis_of(*surface);
  vtkNew<vtkPoints> flat;  // heights and curvature do not matter for a view from above
  flat->SetDataTypeToDouble();
  flat->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    double x[3];
    surface->GetPoint(i, x);
    flat->SetPoint(i, x[0] - axis[0], x[1] - axis[1], 0);
  }
  surface->SetPoints(flat);

  vtkNew<vtkImageData> grid;
  const double spacing = 2 * half_width / pixels;
  grid->SetDimensions(pixels, pixels, 1);
  grid->SetSpacing(spacing, spacing, 1);
  grid->SetOrigin(-half_width + spacing / 2, -half_width + spacing / 2, 0);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(grid);
  probe->SetSourceData(surface);
  probe->Update();
  vtkDataArray* values = point_array(*probe->GetOutput(), array, file);
  vtkDataArray* valid = point_array(*probe->GetOutput(), probe->GetValidPointMaskArrayName(), file);
  Map map{pixels, pixels, -half_width, half_width, -half_width, half_width, {}};
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    map.values.push_back(valid->GetComponent(i, 0) > 0 ? values->GetComponent(i, 0)
                                                       : std::numeric_limits<double>::quiet_NaN());
  return map;
}

InterfaceExtent interface_extent(const fs::path& file) {
  const auto surface = read_data<vtkPolyData>(file);
  vtkDataArray* pressure = point_array(*surface, "pressure", file);
  const auto axis = axis_of(*surface);
  InterfaceExtent extent;
  double largest = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    double x[3];
    surface->GetPoint(i, x);
    x[0] -= axis[0], x[1] -= axis[1];
    const double reach = std::max(std::abs(x[0]), std::abs(x[1]));
    extent.surface = std::max(extent.surface, reach);
    const double p = pressure->GetComponent(i, 0);
    if (p > 0) extent.contact = std::max(extent.contact, reach);
    if (p > largest) {
      largest = p;
      extent.peak_x = x[0];
      extent.peak_y = x[1];
    }
  }
  return extent;
}

namespace {

vtkSmartPointer<vtkPolyData> section_of_part(const fs::path& file, double y) {
  const auto bodies = read_data<vtkUnstructuredGrid>(file);
  // Files of earlier versions have no rigid motion; their particle was pressed and no more.
  const bool moves = bodies->GetPointData()->HasArray("motion");
  vtkDataArray* displacement = point_array(*bodies, moves ? "motion" : "displacement", file);
  const auto axis = axis_of(*bodies);
  vtkNew<vtkPoints> displaced;
  displaced->SetDataTypeToDouble();  // gaps of a nanometre beside bodies of many micrometres
  displaced->SetNumberOfPoints(bodies->GetNumberOfPoints());
  for (vtkIdType i = 0; i < bodies->GetNumberOfPoints(); ++i) {
    double x[3];
    bodies->GetPoint(i, x);
    for (int c = 0; c < 3; ++c) x[c] += displacement->GetComponent(i, c) - (c < 2 ? axis[c] : 0.0);
    displaced->SetPoint(i, x);
  }
  bodies->SetPoints(displaced);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, y, 0);
  plane->SetNormal(0, 1, 0);
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(bodies);
  cutter->SetCutFunction(plane);
  cutter->GenerateTrianglesOff();
  cutter->Update();
  return cutter->GetOutput();
}

}  // namespace

vtkSmartPointer<vtkPolyData> vertical_section(const StepFiles& files, double y) {
  vtkNew<vtkAppendPolyData> all;
  for (const auto& file : files) all->AddInputData(section_of_part(file, y));
  all->Update();
  return all->GetOutput();
}

}  // namespace asperity::report
