// Which recordings the proof is made of: every effect alone at three levels of noise, pairs, nulls, effects
// outside of the catalogue, decoys, and settings in which effects are not distinguishable.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/conceal/concealed_recording.h"

namespace asperity {

/// The case of finite elements that is the simulation of a recording.
struct ChallengeCase {
  std::filesystem::path file;        ///< empty: smooth and elastic bodies, as the recording names them
  std::vector<std::string> entries;  ///< "Section/Entry=value" that replace the case's
};

/// One recording of the matrix.
struct ChallengeItem {
  std::string name;    ///< of its folder
  std::string family;  ///< "single", "finite_elements", "other_code", "pair", "null", "out_of_catalogue",
                       ///< "decoy", "indistinguishable"
  ConcealOptions options;
  std::vector<std::filesystem::path> cases;  ///< of family "finite_elements": what was solved
  std::optional<ChallengeCase> simulation;   ///< none: reduced laws
  bool knows_friction = false;  ///< the case's friction is the truth's, and not what the recording guesses
  bool knows_adhesion = false;  ///< the case has the truth's work of adhesion that rolling loses
  bool knows_spectrum = false;  ///< the case has the truth's spectrum, and a surface of its own
  /// What is right to name beside a case, which has partial slip of itself and a friction of its own: none
  /// for reduced laws, where it is what was concealed.
  std::optional<std::vector<std::string>> answer;

  const std::vector<std::string>& right_answer() const { return answer ? *answer : options.effects; }
};

/// Folder of a history that the solver solved (challenge/data).
std::filesystem::path solved_truth(const std::string& name);

/// Conceals what an item asks for.
ConcealedRecording conceal(const ChallengeItem& item);

/// `quick`: one of most kinds, at the middle level of noise. `seed` is added to those of all recordings.
std::vector<ChallengeItem> challenge_matrix(bool quick, unsigned seed = 0);

/// Recordings whose simulation is a case of finite elements: nulls of other meshes and formulations, physics
/// that the catalogue lacks, yielding and roughness by other codes, effects by other formulas. `quick`: a
/// dozen of them. `seed` as above.
std::vector<ChallengeItem> case_challenge_matrix(bool quick, unsigned seed = 0);

}  // namespace asperity
