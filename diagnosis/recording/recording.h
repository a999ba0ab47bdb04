// What an instrument measured: the folder format "asperity-recording/1" (recording.json and its CSV tables)
// in SI units.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion.h"
#include "core/quantity.h"

namespace asperity {

/// Throws InputError with the nearest name.
Motion mode_of(const std::string& name);
/// Of recordings: all but programs.
std::vector<Motion> all_modes();

/// One of the two (three) bodies in contact. Unknown values are NaN.
struct RecordedBody {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::string material;
  double youngs_modulus = unknown;  ///< E [Pa]
  double poissons_ratio = unknown;  ///< nu [-]
  double radius = unknown;          ///< R [m], of the particle
  double rms_roughness = 0;         ///< [m]
  double yield_stress = unknown;    ///< Y [Pa]
};

/// A number of the simulation that is given, or fitted before any physics is added.
struct SimulationParameter {
  double value = 0;
  bool calibrate = false;
};

/// The reduced laws the recording is compared with, and what is free in them.
struct SimulationChoice {
  std::string normal = "hertz";
  std::string sliding = "mindlin_coulomb";
  std::string rolling = "constant";
  std::string torsion = "none";  ///< "none" or "constant"
  std::map<std::string, SimulationParameter>
      parameters;  ///< sliding_friction, rolling_friction, torsion_friction
  /// A case of finite elements in place of these laws: its file, or a folder of solved cases, as seen from
  /// the recording's folder; empty: none.
  std::string case_file, study;
  std::map<std::string, std::string> case_entries;  ///< "Section/Entry" -> value that replaces the case's

  bool by_finite_elements() const { return !case_file.empty() || !study.empty(); }
};

/// A time-ordered signal, or a list of independent measurements, a row each.
enum class TableKind { trace, series };

/// Where the forces of a rolling or rail series act.
enum class ForcePlace { indenter, substrate };

/// One table of measured channels.
struct RecordingTable {
  std::string file;  ///< CSV file within the folder
  TableKind kind = TableKind::trace;
  std::vector<std::string> control;  ///< channels that drive the simulation, the driven motion first
  std::string response;              ///< channel that is compared
  ForcePlace at = ForcePlace::indenter;
  std::map<std::string, std::vector<double>>
      columns;                       ///< channel (or channel_sd, run, cycle, time) -> SI values, NaN: missing
  std::vector<std::string> segment;  ///< of each row; empty if there is no such column

  std::size_t rows() const { return columns.empty() ? segment.size() : columns.begin()->second.size(); }
  bool has(const std::string& channel) const { return columns.count(channel) > 0; }
  /// Throws InputError naming the file and the missing column.
  const std::vector<double>& column(const std::string& channel) const;
};

struct Recording {
  std::filesystem::path folder;  ///< where it was read; empty for one made in memory
  std::string title;
  Motion mode = Motion::normal;
  RecordedBody particle, substrate;
  std::optional<RecordedBody> indenter;       ///< rolling and rail
  double rail_angle = RecordedBody::unknown;  ///< of inclination [rad]
  bool simulation_is_given = false;
  SimulationChoice simulation;
  std::map<std::string, double> noise;  ///< standard deviation of one sample by channel [SI]
  std::vector<RecordingTable> tables;
  std::vector<std::string> remarks;  ///< what was changed in reading, in sentences
};

/// Dimension of a channel ("normal_force", "lateral_force_sd", "run"); throws InputError with the nearest
/// name.
Dimension dimension_of_channel(const std::string& channel);
/// "N", "m", ... of a channel.
std::string unit_of_channel(const std::string& channel);
std::vector<std::string> known_channels();
/// Whether a column holds standard deviations of another: "lateral_force_sd".
bool is_deviation(const std::string& channel);

/// Reads a folder, or its recording.json. Throws InputError: one sentence with file, line and remedy.
Recording read_recording(const std::filesystem::path& folder);
/// Everything read_recording() asks of a recording made in memory.
/// Throws InputError, one sentence with remedy.
void check_recording(const Recording& recording);
/// Writes recording.json and one CSV for each table, in SI units; creates the folder.
void write_recording(const Recording& recording, const std::filesystem::path& folder);

}  // namespace asperity
