#include "core/error.h"
#include "core/thread_limit.h"
#include "python/native/native.h"

PYBIND11_MODULE(_native, module) {
  namespace py = pybind11;
  asperity::limit_threads_by_environment();
  module.doc() = "The parts of asperity that run within Python's own process.";
  py::register_exception<asperity::InputError>(module, "InputError", PyExc_ValueError).attr("__doc__") =
      "What was asked for is refused; the message names the remedy.";
  py::register_exception<asperity::WorkError>(module, "WorkError", PyExc_RuntimeError).attr("__doc__") =
      "The work failed; what was done before is kept.";
  asperity::python::add_surfaces(module);
  asperity::python::add_preview(module);
  asperity::python::add_results(module);
  asperity::python::add_diagnosis(module);
}
