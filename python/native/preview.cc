// The normal contact of a case by half-spaces.
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "app/case_file.h"
#include "fem/interface/surface_attraction.h"
#include "half_space/case_contact.h"
#include "python/native/native.h"

namespace asperity::python {
namespace {

using half_space::CasePreview;

CasePreview preview(const std::string& file, const std::vector<std::string>& changes, double hardness) {
  const Settings settings = read_settings(file, changes);
  const CaseInput input = case_from_settings(settings, file);
  CasePreview found;
  naming_lines_of_scans(settings, input, [&] {
    found = half_space::preview_of_case(input, hardness, fem::surface_attraction(input.interface));
  });
  return found;
}

/// What is told of the pressures of one solution, of cells in rows from the bottom up.
py::array pressure_of(const half_space::CaseContact& contact, const py::object& owner) {
  return view_of(contact.solution.pressure, {contact.grid.ny, contact.grid.nx}, owner);
}

}  // namespace

void add_preview(py::module_& module) {
  py::class_<CasePreview>(module, "Preview", "The normal contact of a case by elastic half-spaces.")
      .def_property_readonly(
          "force", [](const CasePreview& p) { return p.fine.force(); }, "Normal force [N].")
      .def_property_readonly(
          "approach", [](const CasePreview& p) { return p.fine.approach() - p.fine.first_touch; },
          "Approach from first touch [m].")
      .def_property_readonly(
          "approach_of_mean_surfaces", [](const CasePreview& p) { return p.fine.approach(); },
          "Approach of the mean surfaces [m].")
      .def_property_readonly(
          "approach_error", [](const CasePreview& p) { return p.error_of_approach(); },
          "What half as many cells along a side are off [m].")
      .def_property_readonly(
          "stiffness", [](const CasePreview& p) { return p.fine.stiffness; }, "Normal stiffness [N/m].")
      .def_property_readonly(
          "stiffness_error", [](const CasePreview& p) { return p.error_of_stiffness(); }, "Relative.")
      .def_property_readonly(
          "area", [](const CasePreview& p) { return p.fine.shape.area; }, "Real contact area [m^2].")
      .def_property_readonly(
          "area_error", [](const CasePreview& p) { return p.error_of_area(); }, "Relative.")
      .def_property_readonly(
          "largest_pressure", [](const CasePreview& p) { return p.fine.largest_pressure(); }, "[Pa].")
      .def_property_readonly(
          "largest_pressure_error", [](const CasePreview& p) { return p.error_of_largest_pressure(); },
          "Relative.")
      .def_property_readonly(
          "lateral_stiffness", [](const CasePreview& p) { return p.fine.lateral_stiffness; },
          "Of what touches, stuck together [N/m]; 0: bodies with films.")
      .def_property_readonly(
          "torsion_stiffness", [](const CasePreview& p) { return p.fine.torsion_stiffness; },
          "About the axis of the sphere [N m/rad]; 0: bodies with films.")
      .def_property_readonly(
          "attraction", [](const CasePreview& p) { return p.fine.attracting; },
          "Of the surfaces, which the contact carries beside the force [N].")
      .def_property_readonly(
          "pull_off", [](const CasePreview& p) { return p.fine.pull_off ? p.fine.pull_off->force : 0.0; },
          "Largest tension on separation [N]; 0 without adhesion.")
      .def_property_readonly(
          "pull_off_error", [](const CasePreview& p) { return p.error_of_pull_off(); }, "Relative.")
      .def_property_readonly(
          "spots", [](const CasePreview& p) { return p.fine.shape.spots; }, "Contacts apart from each other.")
      .def_property_readonly(
          "spacing", [](const CasePreview& p) { return p.fine.grid.dx; }, "Side of a cell [m].")
      .def_property_readonly(
          "pressure",
          [](const py::object& self) { return pressure_of(self.cast<const CasePreview&>().fine, self); },
          "Pressure of each cell [Pa], rows from the bottom up; a read-only view.");
  module.def("preview", &preview, py::arg("case"), py::arg("changes"), py::arg("hardness"),
             py::call_guard<py::gil_scoped_release>());
}

}  // namespace asperity::python
