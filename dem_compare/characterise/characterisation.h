// The numbers that a discrete element model needs of one contact, each with an interval: what `asperity
// characterise` ends with. SI units.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "dem_compare/cases/parameter_sets.h"
#include "dem_compare/derive/derivation.h"

namespace asperity {

/// One number of the table. Its uncertainties are standard deviations.
struct CharacterisedNumber {
  std::string key, meaning, unit;  ///< as in parameters.json, or of result.json
  double value = 0;
  double at_load = std::numeric_limits<double>::quiet_NaN();  ///< NaN: of the whole range [N]
  double fit_sd = std::numeric_limits<double>::quiet_NaN();   ///< of fit and realisations; NaN: not known
  double mesh_sd = std::numeric_limits<double>::quiet_NaN();  ///< discretisation error; NaN: not known
  double material_sd = 0;                                     ///< spread of Young's moduli
  bool holds_scatter = false;                                 ///< several realisations went in
  int degrees_of_freedom = 0;  ///< of the scatter in fit_sd: realisations less one, over all loads; 0: none
  bool is_assumed = false;     ///< nothing was measured: one load tells no offset
  /// Local friction that went in and that the number follows; NaN: none [-].
  double local_friction = std::numeric_limits<double>::quiet_NaN();
  bool input_is_known = true;  ///< false: that coefficient is a guess, and there is no interval
  std::string from;            ///< provenance, in words

  /// Half of a 95 % interval of what is known of the uncertainty; of few realisations Student's (1908). NaN
  /// if nothing is, if the number is zero or follows an input that is not known.
  double half_width() const;
  /// The same relative to the value [-]; NaN where the value is 0.
  double relative_half_width() const;
};

struct Characterisation {
  std::string label;  ///< what tells it from the others, such as "local friction 0.1"; empty for a single one
  std::vector<CharacterisedNumber> numbers;
  std::vector<std::string> not_known;  ///< keys of quantities that the cases do not tell
};

/// Of one parameter set and what was derived from it (sentences in place). modulus_spread: relative standard
/// deviation of the reduced modulus from the materials [-]; friction_is_known: whether local friction was
/// given or is a guess.
Characterisation characterised(const ParameterSet& set, const Derivation& derivation, double modulus_spread,
                               bool friction_is_known);

/// One object a number: key, value, unit, interval_95 and the standard deviations.
nlohmann::ordered_json to_json(const Characterisation& characterisation);

}  // namespace asperity
