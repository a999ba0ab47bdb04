#include "dem_compare/derive/length_choice.h"

#include <cmath>

namespace asperity {

bool LengthChoice::is_told() const { return std::abs(log_odds) > std::log(telling_odds); }

LengthScale LengthChoice::scale() const {
  return is_told() && log_odds < 0 ? LengthScale::particle_radius : LengthScale::contact_radius;
}

const ResistanceLaw& LengthChoice::law() const {
  return scale() == LengthScale::particle_radius ? with_radius : with_contact;
}

LengthChoice choose_length(const std::vector<ResistancePoint>& points) {
  constexpr auto radius = LengthScale::particle_radius, contact = LengthScale::contact_radius;
  LengthChoice choice;
  choice.with_radius = fit_resistance(points, radius);
  choice.with_contact = fit_resistance(points, contact);
  if (distinct_loads(points).size() > 1)
    choice.log_odds = log_evidence(points, contact) - log_evidence(points, radius);
  choice.radius_error = leave_one_out(points, radius);
  choice.contact_error = leave_one_out(points, contact);
  return choice;
}

nlohmann::ordered_json to_json(const ResistanceLaw& law) {
  return {{"coefficient", law.coefficient},
          {"offset", law.offset},
          {"covariance",
           {{law.covariance(0, 0), law.covariance(0, 1)}, {law.covariance(1, 0), law.covariance(1, 1)}}},
          {"offset_is_told", law.has_offset},
          {"case_scatter", law.case_scatter},
          {"realisation_scatter", law.realisation_scatter},
          {"relative_misfit", law.misfit},
          {"degrees_of_freedom", law.degrees_of_freedom}};
}

nlohmann::ordered_json to_json(const LengthChoice& choice) {
  return {{"r", to_json(choice.with_radius)},
          {"a", to_json(choice.with_contact)},
          {"log_odds_a_over_r", choice.log_odds},
          {"leave_one_out_r", choice.radius_error},
          {"leave_one_out_a", choice.contact_error}};
}

}  // namespace asperity
