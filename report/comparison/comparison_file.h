// What compare writes: tables and verdicts as Markdown for people, as JSON and CSV for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "dem_compare/compare/comparison.h"
#include "dem_compare/compare/side_by_side.h"

namespace asperity::report {

/// Loads at which the curves are compared, one row per group and load: each number with its standard
/// deviation over realisations and its mesh error in columns of their own.
std::string comparison_csv(const Comparison& comparison);
nlohmann::ordered_json comparison_json(const Comparison& comparison);
std::string comparison_markdown(const Comparison& comparison);

/// Of its rows, in the order in which they come.
std::vector<std::string> contacts_of(const SideBySide& comparison);
/// The four columns, one row per contact, quantity and load.
std::string side_by_side_csv(const SideBySide& comparison);
nlohmann::ordered_json side_by_side_json(const SideBySide& comparison);
std::string side_by_side_markdown(const SideBySide& comparison);

}  // namespace asperity::report
