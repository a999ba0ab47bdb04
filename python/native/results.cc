// Solved cases: entries, numbers, history.
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "core/error.h"
#include "python/native/native.h"
#include "results/solved_case.h"

namespace asperity::python {
namespace {

/// "normal_force" of "normal_force [N]".
std::string without_unit(const std::string& name) { return name.substr(0, name.find(" [")); }

/// Names of the columns that a history has.
std::vector<std::string> names_of(const History& history) {
  std::vector<std::string> names;
  for (const auto& column : history_columns())
    if (!(history.*column.values).empty()) names.push_back(column.name);
  for (const auto& added : history.added) names.push_back(added.name);
  return names;
}

const std::vector<double>& column_of(const History& history, const std::string& name) {
  for (const auto& column : history_columns())
    if ((name == column.name || name == without_unit(column.name)) && !(history.*column.values).empty())
      return history.*column.values;
  for (const auto& added : history.added)
    if (name == added.name || name == without_unit(added.name)) return added.values;
  throw py::key_error("the history has no column '" + name + "'; .names lists those it has");
}

py::object document_of(const SolvedCase& solved) {
  return solved.finished() ? to_python(solved.result->document) : py::none();
}

}  // namespace

void add_results(py::module_& module) {
  py::class_<SolvedCase>(module, "SolvedCase")
      .def_property_readonly("folder", [](const SolvedCase& s) { return s.folder.string(); })
      .def_property_readonly("title", &SolvedCase::title)
      .def_property_readonly("finished", &SolvedCase::finished)
      .def_property_readonly("entries", [](const SolvedCase& s) { return s.entries.all(); })
      .def_property_readonly("document", &document_of)
      .def_property_readonly("names", [](const SolvedCase& s) { return names_of(s.history); })
      .def("column", [](const py::object& self, const std::string& name) {
        const auto& values = column_of(self.cast<const SolvedCase&>().history, name);
        return view_of(values, {static_cast<py::ssize_t>(values.size())}, self);
      });
  module.def(
      "read_case", [](const std::string& folder) { return read_solved_case(folder); }, py::arg("folder"),
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace asperity::python
