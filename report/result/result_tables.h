// Tables of a solved case: what was computed, how far to trust it, what it cost, what went in.
#pragma once

#include <string>

#include "dem_compare/compare/comparison.h"
#include "results/solved_case.h"

namespace asperity::report {

/// "effective" of result.json with standard deviations.
std::string effective_table(const SolvedCase& solved);
/// Forces, moments, energy: relative errors and what they mean.
std::string balance_table(const SolvedCase& solved);
/// How far the mesh resolves the roughness of "particle" or "substrate", in one sentence; empty where that is
/// not known or it is smooth.
std::string resolved_roughness_sentence(const SolvedCase& solved, const std::string& body);
/// Mesh, cost, versions and whatever else result.json says, as name and value.
std::string remaining_tables(const SolvedCase& solved);
/// Entries of the case file, and `inputs` of result.json.
std::string inputs_table(const SolvedCase& solved);
/// Ratios to Hertz at each load.
std::string ratio_table(const GroupComparison& group);
/// true_radius: of the particle [m].
std::string fit_table(const NormalNumbers& numbers, double true_radius);

/// Largest relative balance error in the words of a verdict, or that none was given.
std::string balance_sentence(const SolvedCase& solved);

}  // namespace asperity::report
