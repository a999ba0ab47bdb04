// What an engine wrote while it ran, trace.csv, in SI units: the same columns from every engine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Columns of equal length; those that an experiment does not have are zero.
struct EngineTrace {
  std::vector<double> leg;    ///< number of the leg in the plan, from 0
  std::vector<double> time;   ///< [s]
  std::vector<double> drive;  ///< prescribed displacement [m] or angle [rad]
  std::vector<double>
      response;  ///< force of the drive on the sphere along the motion [N]; twisting: torque [N m]
  std::vector<double> particle;       ///< displacement of the sphere [m]
  std::vector<double> rotation_rate;  ///< of the sphere about the rolling axis [rad/s]
  std::vector<double> normal_force;   ///< at the substrate, of a rail at one slope [N]
  std::vector<double> approach;       ///< at the substrate [m]

  std::size_t size() const { return leg.size(); }
};

/// First line of trace.csv, without line end.
const std::string& trace_header();

/// Throws InputError naming file and what is wrong.
EngineTrace read_trace(const std::filesystem::path& file);

}  // namespace asperity
