// The fields a solve wrote: fields.pvd (bodies, VTU) and interface.pvd (contact surface, VTP), read with VTK.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/fields/map_figure.h"

namespace asperity::report {

/// The files of one step, one of each rank.
using StepFiles = std::vector<std::filesystem::path>;

/// What a .pvd lists, by the number in the names, step_NNNN. Files that are missing are left out; empty
/// without a .pvd.
std::map<int, StepFiles> field_files(const std::filesystem::path& pvd);

/// A point data array of the contact surface on a regular grid over the square |x|, |y| <= half_width [m]
/// about the particle's axis, as are all places here. Throws InputError if the file cannot be read or lacks
/// the array.
Map interface_map(const std::filesystem::path& file, const std::string& array, double half_width, int pixels);

/// Where the contact surface is and presses [m].
struct InterfaceExtent {
  double surface = 0, contact = 0;  ///< largest |x| or |y| of the surface, and of the part of it that presses
  double peak_x = 0, peak_y = 0;    ///< place of the largest pressure
};
InterfaceExtent interface_extent(const std::filesystem::path& file);

/// The bodies, displaced, cut by the plane y = `y`: polygons with their cell data.
/// y [m].
vtkSmartPointer<vtkPolyData> vertical_section(const StepFiles& files, double y);

}  // namespace asperity::report
