// Topographies: reading, generating, measuring, as arrays of heights.
#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "core/error.h"
#include "python/native/native.h"
#include "surfaces/generate.h"
#include "surfaces/read_topography.h"
#include "surfaces/surface_of_entry.h"
#include "surfaces/surface_report.h"

namespace asperity::python {
namespace {

using Heights = py::array_t<double, py::array::c_style | py::array::forcecast>;

Topography from_heights(const Heights& heights, double width, std::optional<double> height, bool periodic) {
  if (heights.ndim() != 2)
    throw InputError("heights are a table of rows and columns; this array has " +
                     std::to_string(heights.ndim()) + " dimensions");
  Topography map;
  map.ny = static_cast<int>(heights.shape(0));
  map.nx = static_cast<int>(heights.shape(1));
  if (map.nx < 2 || map.ny < 2) throw InputError("a surface needs two rows and columns of heights");
  map.lx = width;
  map.ly = height.value_or(width * map.ny / map.nx);
  if (!(map.lx > 0) || !(map.ly > 0)) throw InputError("the size of a surface must be above 0 m");
  map.heights.assign(heights.data(), heights.data() + heights.size());
  map.missing.assign(map.heights.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    if (!std::isfinite(map.heights[i])) map.missing[i] = 1, map.heights[i] = std::nan(""), any = true;
  if (!any) map.missing.clear();
  map.periodic = periodic;
  map.source = "an array";
  return map;
}

Topography read(const std::string& path, std::optional<double> width, std::optional<double> height,
                const std::optional<std::string>& channel, const std::optional<std::string>& height_unit) {
  ReadOptions options;
  options.size_x_m = width;
  options.size_y_m = height;
  options.channel = channel;
  options.height_unit = height_unit;
  return read_topography(path, options);
}

Topography generated(double rms, double size, int pixels, double hurst, std::optional<double> rolloff,
                     std::optional<double> cutoff, std::uint64_t seed) {
  if (pixels < 2) throw InputError("a surface needs two pixels along a side");
  if (!(size > 0)) throw InputError("the size of a surface must be above 0 m");
  GenerateOptions options;
  options.nx = options.ny = pixels;
  options.lx = options.ly = size;
  options.seed = seed;
  options.rms = rms;
  Topography map = generate_periodic(
      spectrum_on_pixels(rms, hurst, rolloff.value_or(0), cutoff.value_or(0), size / pixels), options);
  map.source = "generated, seed " + std::to_string(seed);
  return map;
}

}  // namespace

void add_surfaces(py::module_& module) {
  py::class_<Topography>(module, "Surface", "Heights on a regular grid of pixels [m]; NaN where missing.")
      .def(py::init(&from_heights), py::arg("heights"), py::arg("width"), py::arg("height") = py::none(),
           py::arg("periodic") = false,
           "Heights [m] as rows from the bottom up, width and height of the map [m].")
      .def_property_readonly(
          "heights",
          [](const py::object& self) {
            const auto& map = self.cast<const Topography&>();
            return view_of(map.heights, {map.ny, map.nx}, self);
          },
          "Heights [m], shape (rows, columns), rows from the bottom up; a read-only view.")
      .def_property_readonly(
          "size",
          [](const Topography& map) {
            return std::pair{map.lx, map.ly};
          },
          "Width and height [m].")
      .def_property_readonly(
          "spacing",
          [](const Topography& map) {
            return std::pair{map.dx(), map.dy()};
          },
          "Distance of neighbouring pixels along x and y [m].")
      .def_readonly("periodic", &Topography::periodic, "Whether it continues beyond its edge.")
      .def_readonly("channel", &Topography::channel, "Name of the channel read.")
      .def_readonly("source", &Topography::source, "File or generator, with what was assumed.")
      .def("__repr__", [](const Topography& map) { return "<asperity.Surface: " + describe(map) + ">"; });
  module.def("read_surface", &read, py::arg("path"), py::arg("width"), py::arg("height"), py::arg("channel"),
             py::arg("height_unit"), py::call_guard<py::gil_scoped_release>());
  module.def("generate_surface", &generated, py::arg("rms"), py::arg("size"), py::arg("pixels"),
             py::arg("hurst"), py::arg("rolloff"), py::arg("cutoff"), py::arg("seed"),
             py::call_guard<py::gil_scoped_release>());
  module.def(
      "surface_of_entry", [](const std::string& entry) { return topography_for(TopographySpec(entry)); },
      py::arg("entry"), py::call_guard<py::gil_scoped_release>());
  module.def(
      "write_surface", [](const std::string& path, const Topography& map) { write_gsf(path, map); },
      py::arg("path"), py::arg("surface"));
  module.def("measure_surface", [](const Topography& map, const std::string& level) {
    nlohmann::ordered_json json;
    {
      const py::gil_scoped_release others;
      json = to_json(measure_surface(map, parse_level(level)));
    }
    return to_python(json);
  });
}

}  // namespace asperity::python
