// What the parts of the Python module share.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace asperity::python {

namespace py = pybind11;

/// A JSON document as dictionaries, lists and numbers of Python.
inline py::object to_python(const nlohmann::ordered_json& json) {
  return py::module_::import("json").attr("loads")(json.dump());
}

/// Numbers that `owner` holds, without a copy and read-only; the array keeps the owner alive.
inline py::array view_of(const std::vector<double>& values, std::vector<py::ssize_t> shape,
                         const py::object& owner) {
  py::array array(py::dtype::of<double>(), std::move(shape), {}, values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

void add_surfaces(py::module_& module);
void add_preview(py::module_& module);
void add_results(py::module_& module);
void add_diagnosis(py::module_& module);

}  // namespace asperity::python
