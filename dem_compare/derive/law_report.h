// What was found on one law, for people and for programs, and what the cases could not tell.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/motion.h"
#include "core/quantity.h"
#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/derive/resistance_law.h"

namespace asperity {

struct LawReport {
  Motion motion = Motion::normal;
  std::string title;
  std::vector<std::string> findings;
  std::vector<std::string> not_identifiable;  ///< each with the cases that would tell it
  nlohmann::ordered_json details;
  std::vector<ResistancePoint> points;  ///< of a resistance: what its law was fitted to
};

/// "mu = 0.230 +- 0.002, h = 12 +- 1 uN".
std::string to_text(const ResistanceLaw& law);
nlohmann::ordered_json to_json(const ResistanceLaw& law);

/// "1.21 +- 0.03 GPa"; the error is left out where it is not known.
/// Both in SI.
std::string with_error(double value, double sd, Dimension dimension);
/// The same for a unit that begins with N ("pN m"), or without prefix.
std::string with_error(double value, double sd, const std::string& unit);
std::string percent(double share);

/// "4 cases, 100 uN to 3 mN, 2 realisations, spacing 22 nm".
std::string extent_of(const std::vector<CaseNumber>& numbers);
/// Those that count, on_one_mesh.
std::vector<CaseNumber> counted_of(const std::vector<CaseNumber>& all);
/// The extent of those that count, and the mesh's error, which no standard deviation of the laws holds.
std::string source_of(const std::vector<CaseNumber>& all);

/// Scatter between realisations and error of the mesh in words, apart; adds to `not_identifiable` what would
/// show them.
void tell_scatter_and_mesh(const std::vector<CaseNumber>& all, const std::string& what, LawReport& report);

}  // namespace asperity
