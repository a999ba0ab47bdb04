// Which recordings the proof is made of: every effect alone at three levels of noise, pairs, nulls, effects
// outside of the catalogue, decoys, and settings in which effects are not distinguishable.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/conceal/concealed_recording.h"

namespace asperity {

/// One recording of the matrix.
struct ChallengeItem {
  std::string name;    ///< of its folder
  std::string family;  ///< "single", "finite_elements", "pair", "null", "out_of_catalogue", "decoy",
                       ///< "indistinguishable"
  ConcealOptions options;
  std::vector<std::filesystem::path> cases;  ///< of family "finite_elements": what was solved
};

/// Conceals what an item asks for.
ConcealedRecording conceal(const ChallengeItem& item);

/// `quick`: one of most kinds, at the middle level of noise. `seed` is added to those of all recordings.
std::vector<ChallengeItem> challenge_matrix(bool quick, unsigned seed = 0);

}  // namespace asperity
