// The type that flows from fem/ to dem_compare/: one row per accepted step, as in history.csv (SI units).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Columns of equal length.
struct ContactHistory {
  std::vector<double> step;
  std::vector<double> time;                  ///< [s]
  std::vector<double> normal_displacement;   ///< approach of points far from the contact [m]
  std::vector<double> normal_force;          ///< [N], pressing is positive
  std::vector<double> lateral_displacement;  ///< [m]
  std::vector<double> lateral_force;         ///< [N]
  std::vector<double> rolling_angle;         ///< [rad]
  std::vector<double> rolling_moment;        ///< [N m]
  std::vector<double> torsion_angle;         ///< [rad]
  std::vector<double> torsion_moment;        ///< [N m]
  std::vector<double> contact_radius;        ///< of the circle with the contact area [m]
  std::vector<double> contact_area;          ///< real area [m^2]
  std::vector<double> max_pressure;          ///< [Pa]
  std::vector<double> plastic_volume;        ///< [m^3]
  std::vector<double> dissipated_energy;     ///< [J]
  std::vector<double> pressure_radius;       ///< of the Hertzian pressure with the same second moment [m]; empty where it is not told

  /// Radius [m] of the contact as a whole, which spots of a rough one spread over: that of the pressure. Where that is not told the
  /// contact radius, which was it before results told both.
  const std::vector<double>& radius_of_whole() const { return pressure_radius.empty() ? contact_radius : pressure_radius; }
  std::size_t size() const { return normal_force.size(); }
};

/// A column of history.csv and the member that holds it.
struct HistoryColumn {
  const char* name;  ///< with its unit, "normal_force [N]"
  std::vector<double> ContactHistory::*values;
};
const std::vector<HistoryColumn>& history_columns();

/// Throws InputError naming file and column; cells that are not known are NaN. Further columns are passed over.
ContactHistory read_history(const std::filesystem::path& file);
/// Columns that are empty are written as zeros.
std::string format_history(const ContactHistory& history);

/// A stretch of steps in which the load grows, falls or stays; its turning points belong to both neighbours.
struct HistoryBranch {
  enum class Kind { loading, unloading, hold } kind = Kind::loading;
  std::size_t first = 0, last = 0;  ///< rows, inclusive
  std::size_t size() const { return last - first + 1; }
};
std::vector<HistoryBranch> history_branches(const ContactHistory& history);

}  // namespace asperity
