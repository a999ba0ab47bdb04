// Mutant schemata (Untch, Offutt & Harrold 1993): every mutant is in one program, (asperity_mutant(n) ?
// mutated : original), and the environment variable ASPERITY_MUTANT chooses one for a run. Included into
// every file of the mutated copy; no part of asperity.
#pragma once

/// -1: not read from the environment yet; 0: none.
extern int asperity_active_mutant;
/// Reads the environment; with ASPERITY_MUTANT_TRACE=FILE it also notes which test reaches which mutant.
bool asperity_mutant_slowly(int number);

inline bool asperity_mutant(int number) {
  return asperity_active_mutant < 0 ? asperity_mutant_slowly(number) : number == asperity_active_mutant;
}
