// What a solved case says of itself: result.json ("asperity-result/1", docs/result.md), with a type for each
// of its parts. SI units.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// A number of `effective`; NaN where the file does not state it.
struct EffectiveNumber {
  double value = std::numeric_limits<double>::quiet_NaN(), sd = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
};

/// What the mesh resolves of a body's roughness; NaN where the file does not state it.
struct ResolvedRoughness {
  double shortest_wave, cells_over_shortest_wave;  ///< [m], [-]
  double slope_variance_in_shorter_waves;          ///< share of the scan's
  double missed_slope_variance;                    ///< by the facets, share of the meshed surface's
  double repeats_every;                            ///< [m]
};

/// What a column or field that a file of its own has added is.
struct Addition {
  std::string name, meaning;
  std::string unit, place;  ///< of a field; place: contact or bodies
  double components;        ///< of a field [-]; NaN for a column

  /// "slip [m]", of a field.
  std::string label() const { return unit.empty() ? name : name + " [" + unit + "]"; }
};

struct CaseResult {
  static constexpr const char* format = "asperity-result/1";

  std::string title, experiment;
  std::string version, commit;  ///< of asperity
  bool complete = true;
  std::vector<std::pair<std::string, EffectiveNumber>> effective;  ///< in the order of the file
  std::vector<std::pair<std::string, double>> balance;  ///< relative errors of force, moment, energy
  /// Entries that decide the answer, "Section/Entry" and text; empty for a result of an earlier version.
  std::map<std::string, std::string> physical_entries;
  std::vector<Addition> added_columns, added_fields;          ///< of history.csv; of fields/, interface/
  std::array<double, 2> rms_in_region;                        ///< particle, substrate [m]
  std::array<std::optional<ResolvedRoughness>, 2> roughness;  ///< particle, substrate
  double cells, unknowns, interface_spacing;                  ///< of the mesh; spacing [m]
  bool reaches_rim = false;         ///< contact has come to the edge of the potential contact zone
  double wall_time, peak_memory;    ///< [s], [byte]
  nlohmann::ordered_json document;  ///< the whole file, for tables that show all of it

  /// Whether the file states the number of this name among the effective ones.
  bool has(const std::string& effective_name) const;
  /// NaN where the file does not state it.
  EffectiveNumber effective_number(const std::string& name) const;
  double balance_of(const std::string& name) const;
};

/// Empty where there is no such file, or it says that it is not complete. Throws InputError naming the file
/// and the part that is of another kind than it should be, or another format.
std::optional<CaseResult> read_case_result(const std::filesystem::path& file);

/// From the text of such a file, which messages call `file`.
/// Throws InputError naming the file and what it lacks.
CaseResult case_result_of(const nlohmann::ordered_json& document, const std::string& file);

/// A number, or the `value` of an object; NaN for anything else.
double number_of(const nlohmann::ordered_json& value);

}  // namespace asperity
