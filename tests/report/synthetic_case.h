// Folders as `asperity solve` and `asperity study` write them, with a Hertzian contact made up from its
// formulas: enough to see that a report finds, reads and draws everything.
#pragma once

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

#include "core/atomic_file.h"
#include "core/hertz.h"
#include "results/history.h"

namespace asperity::test {

struct SyntheticCase {
  double load = 1e-3;     ///< [N]
  double softness = 1;    ///< contact as of this multiple of the radius
  double imprint = 1e-9;  ///< left after unloading [m]
  double spacing = 1e-8;  ///< of the mesh at the interface [m]
  std::string topography = "smooth";
  std::string yield_stress = "3 GPa";
  std::string title = "Synthetic";
  bool fields = true;
  bool finished = true;
};

namespace synthetic {

constexpr int load_steps = 8;
inline const std::string resolved_roughness =
    R"({"shortest_wave": 4e-08, "cells_over_shortest_wave": 4.0, "slope_variance_in_shorter_waves": 0.031,
    "rms_slope": 0.08, "missed_by_facets": {"rms_height": 0.04, "slope_variance": 0.052},
        "repeats_every": null})";
constexpr double radius = 8.5e-6;

inline Hertz contact(const SyntheticCase& made) {
  return {reduced_modulus({71e9, 0.17}, {179e9, 0.25}), radius * made.softness};
}

inline History history(const SyntheticCase& made) {
  const Hertz hertz = contact(made);
  History history;
  const auto add = [&](double force, double approach) {
    for (const auto& column : history_columns())
      if (column.always) (history.*column.values).push_back(0);
    history.step.back() = static_cast<double>(history.size());
    history.time.back() = history.step.back();
    history.normal_force.back() = force;
    history.normal_displacement.back() = approach;
    history.contact_area.back() = force > 0 ? 0.8 * hertz.contact_area(force) : 0;
    history.contact_radius.back() = force > 0 ? hertz.contact_radius(force) : 0;
    history.max_pressure.back() = force > 0 ? hertz.peak_pressure(force) : 0;
    history.plastic_volume.back() = made.imprint > 0 ? 1e-24 : 0;
  };
  for (int i = 1; i <= load_steps; ++i)
    add(made.load * i / load_steps, hertz.approach(made.load * i / load_steps));
  if (!made.finished) return history;
  const double top = hertz.approach(made.load);
  for (int i = load_steps - 1; i >= 0; --i)
    add(made.load * i / load_steps,
        made.imprint + (top - made.imprint) * std::pow(double(i) / load_steps, 2.0 / 3.0));
  return history;
}

inline void write_interface(const SyntheticCase& made, const std::filesystem::path& file) {
  const Hertz hertz = contact(made);
  const double a = hertz.contact_radius(made.load), p0 = hertz.peak_pressure(made.load), half = 2 * a;
  const int n = 60;
  std::ostringstream points, quads, offsets, pressure, gap, status, upper, lower;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = -half + 2 * half * i / n, y = -half + 2 * half * j / n, r2 = (x * x + y * y) / (a * a);
      const double wave = 1e-9 * std::sin(40 * x / half) * std::cos(30 * y / half);
      points << x << ' ' << y << ' ' << (x * x + y * y) / (2 * hertz.radius) << '\n';
      const bool closed = r2 < 1 && wave > -0.2e-9;
      pressure << (closed ? p0 * std::sqrt(1 - r2) : 0) << '\n';
      gap << (closed ? 0 : 1e-9 * std::max(0.0, r2 - 1)) << '\n';
      status << (closed ? 1 : 0) << '\n';
      upper << wave << '\n';
      lower << -wave << '\n';
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int corner = j * (n + 1) + i;
      quads << corner << ' ' << corner + 1 << ' ' << corner + n + 2 << ' ' << corner + n + 1 << '\n';
      offsets << 4 * (j * n + i + 1) << '\n';
    }
  const auto array = [](const std::string& name, const std::string& values, const std::string& more = "") {
    return "<DataArray type='Float64' Name='" + name + "' format='ascii' " + more + ">" + values +
           "</DataArray>";
  };
  std::ostringstream text;
  text << "<?xml version='1.0'?><VTKFile type='PolyData' version='0.1' "
          "byte_order='LittleEndian'><PolyData><Piece NumberOfPoints='"
       << (n + 1) * (n + 1) << "' NumberOfPolys='" << n * n << "'><PointData>"
       << array("pressure", pressure.str()) << array("gap", gap.str()) << array("status", status.str())
       << array("height_particle", upper.str()) << array("height_substrate", lower.str())
       << "</PointData><Points>" << array("Points", points.str(), "NumberOfComponents='3'")
       << "</Points><Polys>"
       << "<DataArray type='Int64' Name='connectivity' format='ascii'>" << quads.str() << "</DataArray>"
       << "<DataArray type='Int64' Name='offsets' format='ascii'>" << offsets.str()
       << "</DataArray></Polys></Piece></PolyData></VTKFile>";
  write_file_atomically(file, text.str());
}

/// Two blocks of hexahedra; von Mises stress as on Hertz's axis, fading with distance from it.
inline void write_bodies(const SyntheticCase& made, const std::filesystem::path& file) {
  const Hertz hertz = contact(made);
  const double a = hertz.contact_radius(made.load), p0 = hertz.peak_pressure(made.load), half = 3 * a;
  const int n = 30, layers = 20;
  std::ostringstream points, displacement, cells, offsets, types, mises, plastic, body, stress;
  int first = 0, count = 0;
  for (const int side : {+1, -1}) {
    for (int k = 0; k <= layers; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
          const double x = -half + 2 * half * i / n, y = -half + 2 * half * j / n;
          const double depth = half * std::pow(double(k) / layers, 1.5);
          const double shape = side > 0 ? (x * x + y * y) / (2 * hertz.radius) : 0;
          points << x << ' ' << y << ' ' << side * depth + shape << '\n';
          displacement << "0 0 " << (side > 0 ? -hertz.approach(made.load) / 2 : 0) << '\n';
        }
    for (int k = 0; k < layers; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const int corner = first + (k * (n + 1) + j) * (n + 1) + i, up = (n + 1) * (n + 1);
          for (const int v : {0, 1, n + 2, n + 1}) cells << corner + v << ' ';
          for (const int v : {0, 1, n + 2, n + 1}) cells << corner + up + v << ' ';
          offsets << 8 * ++count << ' ';
          types << "12 ";
          const double x = -half + 2 * half * (i + 0.5) / n, y = -half + 2 * half * (j + 0.5) / n;
          const double z = half * std::pow((k + 0.5) / layers, 1.5) / a, r2 = (x * x + y * y) / (a * a);
          const double value = p0 * hertz_axis_stress(z, 0.2).von_mises() * std::exp(-r2);
          mises << value << '\n';
          plastic << (made.imprint > 0 ? std::max(0.0, value / p0 - 0.5) * 0.02 : 0) << '\n';
          stress << "0 0 " << -value << " 0 0 0\n";
          body << (side > 0 ? 0 : 1) << '\n';
        }
    first += (layers + 1) * (n + 1) * (n + 1);
  }
  const auto array = [](const std::string& type, const std::string& name, const std::string& values,
                        int components = 1) {
    return "<DataArray type='" + type + "' Name='" + name + "' NumberOfComponents='" +
           std::to_string(components) + "' format='ascii'>" + values + "</DataArray>";
  };
  std::ostringstream text;
  text << "<?xml version='1.0'?><VTKFile type='UnstructuredGrid' version='0.1' "
          "byte_order='LittleEndian'><UnstructuredGrid>"
       << "<Piece NumberOfPoints='" << first << "' NumberOfCells='" << count << "'><PointData>"
       << array("Float64", "displacement", displacement.str(), 3) << "</PointData><CellData>"
       << array("Float64", "von_mises", mises.str())
       << array("Float64", "equivalent_plastic_strain", plastic.str())
       << array("Float64", "stress", stress.str(), 6) << array("Float64", "body", body.str())
       << "</CellData><Points>" << array("Float64", "Points", points.str(), 3) << "</Points><Cells>"
       << array("Int64", "connectivity", cells.str()) << array("Int64", "offsets", offsets.str())
       << array("UInt8", "types", types.str()) << "</Cells></Piece></UnstructuredGrid></VTKFile>";
  write_file_atomically(file, text.str());
}

inline void write_pvd(const std::filesystem::path& folder, const std::string& name,
                      const std::string& suffix) {
  const std::string file = name + "/step_0008." + suffix;
  write_file_atomically(
      folder / (name + ".pvd"),
      "<?xml version='1.0'?><VTKFile type='Collection' version='0.1'><Collection><DataSet timestep=\"8\" "
      "file=\"" +
          file + "\"/></Collection></VTKFile>");
}

}  // namespace synthetic

/// Writes a solved case into `folder`.
inline void write_synthetic_case(const SyntheticCase& made, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  std::ostringstream prm;
  prm << "set Title = " << made.title
      << "\nsubsection Particle\n set Radius = 8.5 um\n set Young modulus = 71 GPa\n"
      << " set Poisson ratio = 0.17\n set Yield stress = " << made.yield_stress
      << "\nend\nsubsection Substrate\n"
      << " set Young modulus = 179 GPa\n set Poisson ratio = 0.25\n set Topography = " << made.topography
      << "\nend\nsubsection Experiment\n set Normal load = " << made.load << "\nend\n";
  write_file_atomically(folder / "case.prm", prm.str());
  write_file_atomically(folder / "history.csv", format_history(synthetic::history(made)));
  if (made.finished)
    write_file_atomically(folder / "result.json",
                          R"({"format": "asperity-result/1", "experiment": "normal",
    "mesh": {"cells": 36000, "dofs": 119000, "interface_spacing": )" +
                              std::to_string(made.spacing * 1e9) +
                              R"(e-9, "roughness": {"particle": null, "substrate": )" +
                              (made.topography == "smooth" ? "null" : synthetic::resolved_roughness) + R"(}},
    "effective": {"normal_stiffness": {"value": 52231.0, "unit": "N/m", "sd": 120.0}},
    "balance": {"force": 2.1e-7, "moment": 3e-7, "energy": 0.0042},
    "cost": {"wall_time": 83.2, "peak_memory": 1.9e9, "ranks": 1},
    "versions": {"asperity": "0.1.0", "deal.II": "9.4.1"}})");
  if (!made.fields) return;
  fs::create_directories(folder / "fields");
  fs::create_directories(folder / "interface");
  synthetic::write_interface(made, folder / "interface" / "step_0008.vtp");
  synthetic::write_bodies(made, folder / "fields" / "step_0008.vtu");
  synthetic::write_pvd(folder, "interface", "vtp");
  synthetic::write_pvd(folder, "fields", "vtu");
}

}  // namespace asperity::test
