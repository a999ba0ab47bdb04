// How reliable a solved case is by its own energy balance: the work put in must be stored or dissipated.
#pragma once

#include <string>

#include "results/solved_case.h"

namespace asperity {

/// Open shares of the energy from which on a case is pointed at, and not used.
inline constexpr double flagged_open_energy = 0.01, refused_open_energy = 0.05;

/// A case whose result.json states no balance is neither.
bool is_energy_flagged(const SolvedCase& solved);
bool is_energy_refused(const SolvedCase& solved);

/// "2.3 % of its energy is not accounted for, more than 1 %: ..."; "" for a case that is not flagged.
std::string open_energy_words(const SolvedCase& solved);

/// Throws InputError for a case that is refused: folder, share and remedy.
void refuse_open_energy(const SolvedCase& solved);

}  // namespace asperity
