// What a concealed recording really is: sealed beside it in truth.json ("asperity-truth/1"), which the
// diagnosis never reads. SI units.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity {

/// A parameter's true value, in SI units.
struct TrueParameter {
  double value = 0;
  /// Means what the catalogue means by it: an estimate can be held against it. Another law of the same
  /// physics may have parameters of its own.
  bool is_the_catalogues = true;
};

/// An effect that is in the recording.
struct TrueEffect {
  std::string id;
  bool in_catalogue = true;
  std::map<std::string, TrueParameter> parameters;
  std::string model;  ///< the formulation that made the data
};

/// The effect's share in one table: with and without it, in units of the noise.
struct TrueContribution {
  std::string table;
  std::vector<double> in_noise;  ///< of each row
};

/// Family of recordings that hold an effect which is not in the catalogue.
inline constexpr const char* out_of_catalogue = "out_of_catalogue";
/// The family as a file names it; files of an earlier version call the one above "outsider".
std::string family_named(const std::string& name);

struct Truth {
  std::string family;  ///< "single", "pair", "null", "out_of_catalogue", "decoy", "indistinguishable"
  std::vector<TrueEffect> effects;  ///< none: a null
  std::vector<std::string>
      cannot_be_told_from;  ///< effects that do as well on these data: the verdict ought to be ambiguous
  double noise = 0;         ///< relative to the largest response
  unsigned seed = 0;
  std::string noise_model;
  std::map<std::string, double> coefficients;  ///< of the simulation's laws
  std::vector<TrueContribution> contributions;
};

/// Writes truth.json into the folder.
void write_truth(const Truth& truth, const std::filesystem::path& folder);

}  // namespace asperity
