// The two lengths that a limit mu lambda (f + h) can have, lambda = r or lambda = a(f), and what tells them
// apart: odds from marginal likelihoods (resistance_law.h) and the prediction of a contact from the others.
// SI units.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "dem_compare/derive/resistance_law.h"

namespace asperity {

struct LengthChoice {
  ResistanceLaw with_radius, with_contact;     ///< lambda = r, lambda = a(f)
  double log_odds = 0;                         ///< natural logarithm of p(data | a) / p(data | r)
  double radius_error = 0, contact_error = 0;  ///< leave one out, relative; NaN for fewer than three loads

  /// Odds above this one count as an answer ("strong", Jeffreys 1961).
  static constexpr double telling_odds = 20;
  bool is_told() const;
  /// Where the cases cannot tell, the contact radius: what friction over the contact demands (Lubkin 1951).
  LengthScale scale() const;
  const ResistanceLaw& law() const;
};
/// Fits both to the points and weighs them.
LengthChoice choose_length(const std::vector<ResistancePoint>& points);

/// For parameters.json, SI units.
nlohmann::ordered_json to_json(const ResistanceLaw& law);
nlohmann::ordered_json to_json(const LengthChoice& choice);

}  // namespace asperity
