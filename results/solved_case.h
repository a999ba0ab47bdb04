// A folder that `asperity solve` wrote, as the comparison and the report read it: inputs, result.json,
// history.csv.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/hertz.h"
#include "core/motion.h"
#include "core/quantity.h"
#include "core/topography_spec.h"
#include "results/case_result.h"
#include "results/history.h"

namespace asperity {

/// Entries of a case as "Section/Entry" and their texts, "Particle/Radius" -> "8.5 um".
class CaseEntries {
 public:
  CaseEntries() = default;
  explicit CaseEntries(std::map<std::string, std::string> entries) : entries_(std::move(entries)) {}

  const std::map<std::string, std::string>& all() const { return entries_; }
  bool has(const std::string& path) const { return entries_.count(path) > 0; }
  /// As written; `otherwise` where it is not there.
  std::string text(const std::string& path, const std::string& otherwise = "") const;
  /// SI value; throws InputError naming an entry that is not there.
  double quantity(const std::string& path, Dimension dimension) const;
  double quantity(const std::string& path, Dimension dimension, double otherwise) const;
  /// Surface of a body, "Particle" or "Substrate"; smooth where nothing is said. Throws InputError naming an
  /// entry that is none.
  TopographySpec topography(const std::string& section) const;

 private:
  std::map<std::string, std::string> entries_;
};

/// In the folder of an elastic normal case with fields: the pressure of the same contact by half-spaces.
inline constexpr const char* half_space_map = "half_space.vtp";

struct SolvedCase {
  std::filesystem::path folder;
  CaseEntries entries;
  std::optional<CaseResult> result;  ///< empty as long as the case is not finished
  History history;

  /// The title that the case file gives, for headings.
  std::string title() const;
  bool finished() const { return result.has_value(); }
  /// Of asperity, which solved it; empty where that is not known.
  std::string version() const { return finished() ? result->version : ""; }
  bool lists_physical_entries() const { return finished() && !result->physical_entries.empty(); }
  /// What moved it. Throws InputError for a name that is none.
  Motion motion() const;
  /// Largest part of the energy that the computation cannot account for, as result.json states it; NaN if it
  /// does not.
  /// Relative to that energy [-].
  double open_energy() const;
  EffectiveNumber effective(const std::string& name) const {
    return finished() ? result->effective_number(name) : EffectiveNumber{};
  }
  ElasticBody particle() const { return body("Particle"); }
  ElasticBody substrate() const { return body("Substrate"); }
  /// Both bodies smooth and elastic.
  Hertz hertz() const;
  /// Attraction beyond the contact as one force, which the contact bears beside the load [N].
  double attraction_force() const;
  /// Load at which the first of the smooth bodies would yield; infinite if neither can.
  /// In [N].
  double first_yield_force() const;
  bool is_rough() const;
  bool can_yield() const;
  /// The shear modulus of a body relaxes with time.
  bool relaxes() const;
  /// Of the mesh as made [m]; NaN if it is not known.
  double interface_spacing() const;

 private:
  ElasticBody body(const std::string& section) const;
  double yield_stress(const std::string& section) const;
};

/// True if the folder holds a history.csv.
bool is_case_folder(const std::filesystem::path& folder);

/// Inputs come from the entries that result.json lists, else from case.prm and, where it lacks them, from the
/// numbers of `inputs` of result.json. A case that is not finished has a history as far as it came. Throws
/// InputError naming the file that is missing or wrong.
SolvedCase read_solved_case(const std::filesystem::path& folder);

}  // namespace asperity
