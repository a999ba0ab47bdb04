// Solved cases of one or more folders (cases or studies), sorted into groups of realisations of the same
// rough contact.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dem_compare/cases/normal_numbers.h"
#include "results/contact_key.h"
#include "results/solved_case.h"

namespace asperity {

/// One direction of a study's matrix: "Normal load" with "100 uN", "1 mN".
struct CollectionAxis {
  std::string name;
  std::vector<std::string> labels;
};

/// Cases of the same contact and experiment (contact_key.h) on the same mesh: they differ by the seeds of
/// their surfaces alone.
struct CaseGroup {
  std::string label;                ///< "1 mN, untreated 0.3 nm"
  std::vector<std::string> values;  ///< one of each axis; empty outside of a study
  std::vector<SolvedCase> cases;
  std::vector<NormalNumbers> numbers;  ///< of each case

  const SolvedCase& first() const { return cases.front(); }
  /// What is the same in all groups that differ by mesh alone.
  ContactInputs physics() const { return case_inputs(first()); }
};

/// A case that has no complete result, or one that is not used.
struct MissingCase {
  std::string name, state, message;
};

struct CaseCollection {
  std::string title;
  std::vector<CollectionAxis> axes;  ///< of a study; empty where several folders were named
  std::vector<CaseGroup> groups;     ///< those with at least one solved case
  std::vector<MissingCase> missing;
  std::vector<std::string> remarks;  ///< sentences on cases whose numbers are in doubt, by folder
  std::size_t planned = 0;           ///< cases, solved or not

  std::size_t solved() const { return planned - missing.size(); }
};

/// Whether the folder is one that `asperity study` wrote.
bool is_study_folder(const std::filesystem::path& folder);

/// A case whose balance of energy is refused (energy_balance.h) counts among the missing. The order in which
/// folders are named changes nothing, and one that is named twice counts once. Throws InputError for a folder
/// that is neither a case nor a study.
enum class RefusedCases { left_out, shown };
CaseCollection collect_cases(const std::vector<std::filesystem::path>& folders,
                             RefusedCases refused = RefusedCases::left_out);

}  // namespace asperity
