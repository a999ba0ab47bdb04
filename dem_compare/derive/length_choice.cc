#include "dem_compare/derive/length_choice.h"

#include <cmath>

#include "core/printed.h"

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

nlohmann::ordered_json to_json(const LengthChoice& choice) {
  return {{"r", to_json(choice.with_radius)},
          {"a", to_json(choice.with_contact)},
          {"log_odds_a_over_r", choice.log_odds},
          {"leave_one_out_r", choice.radius_error},
          {"leave_one_out_a", choice.contact_error}};
}

void tell_choice(const LengthChoice& choice, LawReport& report) {
  report.findings.push_back("lambda = r: " + to_text(choice.with_radius));
  report.findings.push_back("lambda = a: " + to_text(choice.with_contact));
  const bool contact_is_likelier = choice.log_odds >= 0;
  constexpr double most_that_matters = 6;  // powers of ten
  const double tens = std::abs(choice.log_odds) / std::log(10.0);
  std::string text =
      "odds " +
      (tens > most_that_matters ? "more than 10^6" : printed("%.3g", std::exp(std::abs(choice.log_odds)))) +
      " to 1 for lambda = " + (contact_is_likelier ? "a" : "r");
  if (std::isfinite(choice.contact_error))
    text += "; a contact predicted from the others is off by " + percent(choice.contact_error) + " with a, " +
            percent(choice.radius_error) + " with r";
  report.findings.push_back(text);
  if (!choice.is_told())
    report.not_identifiable.push_back(
        "the length lambda: odds below 20 to 1; lambda = a is written, as friction over the contact demands. "
        "Loads from 0.1 to 3 mN, four or more, or other radii of the particle would tell");
}

}  // namespace asperity
