// Diagnoses by reduced laws, in this process.
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>

#include "diagnosis/diagnose.h"
#include "python/native/native.h"

namespace asperity::python {
namespace {

using Progress = std::function<void(const std::string&)>;

/// Tells Python of each step; Ctrl-C ends the work there.
Progress with_interrupts(const std::optional<Progress>& progress) {
  return [&progress](const std::string& step) {
    const py::gil_scoped_acquire python;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress) (*progress)(step);
  };
}

py::list tables_of(const Recording& recording, const Diagnosis& diagnosis) {
  py::list tables;
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    const RecordingTable& table = recording.tables[t];
    const auto array = [](const std::vector<double>& values) {
      return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
    };
    py::dict columns;
    for (const auto& [channel, values] : table.columns) columns[py::str(channel)] = array(values);
    columns["simulated_before"] = array(diagnosis.simulated.at(t).before);
    columns["simulated_after"] = array(diagnosis.simulated.at(t).after);
    py::dict entry;
    entry["file"] = table.file;
    entry["response"] = table.response;
    entry["columns"] = columns;
    tables.append(entry);
  }
  return tables;
}

py::tuple diagnosed(const std::string& folder, const std::optional<Progress>& progress) {
  Recording recording;
  Diagnosis diagnosis;
  {
    const py::gil_scoped_release others;
    recording = read_recording(folder);
    DiagnoseOptions options;
    options.progress = with_interrupts(progress);
    diagnosis = diagnose(recording, options);
  }
  return py::make_tuple(to_python(nlohmann::ordered_json::parse(diagnosis_json(diagnosis))),
                        tables_of(recording, diagnosis));
}

}  // namespace

void add_diagnosis(py::module_& module) {
  module.def("diagnose", &diagnosed, py::arg("recording"), py::arg("progress"));
}

}  // namespace asperity::python
