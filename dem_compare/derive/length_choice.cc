#include <cmath>

#include "dem_compare/derive/motion_derivation.h"

namespace asperity {

bool LengthChoice::is_told() const { return std::abs(log_odds) > std::log(telling_odds); }

LengthScale LengthChoice::scale() const {
  return is_told() && log_odds < 0 ? LengthScale::particle_radius : LengthScale::contact_radius;
}

const ResistanceLaw& LengthChoice::law() const { return scale() == LengthScale::particle_radius ? with_radius : with_contact; }

LengthChoice choose_length(const std::vector<ResistancePoint>& points, double radius, const LengthOfLoad& contact_radius) {
  const LengthOfLoad constant = [radius](double) { return radius; };
  LengthChoice choice;
  choice.with_radius = fit_resistance(points, constant);
  choice.with_contact = fit_resistance(points, contact_radius);
  if (distinct_loads(points).size() > 1) choice.log_odds = log_evidence(points, contact_radius) - log_evidence(points, constant);
  choice.radius_error = leave_one_load_out(points, constant);
  choice.contact_error = leave_one_load_out(points, contact_radius);
  return choice;
}

}  // namespace asperity
