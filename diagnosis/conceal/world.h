// A concealed experiment before its noise: recorded channels, and the same without the effects. Each mode of
// motion has its own file; none of them uses anything of what diagnoses. SI units.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "diagnosis/conceal/truth.h"
#include "diagnosis/recording/recording.h"

namespace asperity::hidden {

using Random = std::mt19937_64;
/// Evenly over the logarithm.
double between(Random& random, double low, double high);
/// +1 or -1.
double sign(Random& random);

struct World {
  Recording recording;
  std::vector<TrueEffect> effects;
  std::map<std::string, double> coefficients;
  std::vector<std::vector<double>> without_effects;  ///< response of each table

  /// Records an effect with a parameter that means what the catalogue's does, and returns its value.
  double hide(const std::string& effect, const std::string& model, const std::string& parameter, double value,
              bool is_the_catalogues = true);
  bool hides(const std::string& effect) const;
  double value(const std::string& effect, const std::string& parameter) const;
};

/// The setting in which a normal contact yields, or is rough, by the solution of another code
/// (other_code_truth.h).
inline constexpr const char* by_other_code = "other_code";

/// What to conceal. `setting` "" is the ordinary experiment; others make effects indistinguishable
/// ("one_load", "ramp_only"), "long_hold" and "small_loops"
/// make one look like another.
struct WorldRequest {
  Motion mode = Motion::normal;
  std::vector<std::string> effects;
  std::string setting;
  unsigned seed = 1;

  bool asks_for(const std::string& effect) const {
    return std::find(effects.begin(), effects.end(), effect) != effects.end();
  }
};

/// Effects that can be concealed in a mode: of the catalogue, and outside of it.
std::vector<std::string> concealable(Motion mode);
std::vector<std::string> concealable_out_of_catalogue(Motion mode);
/// Effects that only a case of finite elements can be told to lack.
std::vector<std::string> concealable_beside_a_case(Motion mode);
/// Effects that another code has solved; of a film that is the only truth there is.
std::vector<std::string> concealable_by_other_code(Motion mode);

/// Normal contact under a request's load.
World normal_world(const WorldRequest& request);
/// Sliding under constant load.
World sliding_world(const WorldRequest& request);
/// Rolling, rail and torsion: series of loads.
World series_world(const WorldRequest& request);

/// The paper's sphere on silicon, with diamond above.
Recording paper_bodies(Motion mode, const std::string& title);

}  // namespace asperity::hidden
