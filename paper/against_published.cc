#include "paper/against_published.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "dem_compare/cases/path_averages.h"
#include "paper/published_column.h"

namespace asperity {
namespace {

Quantity quantity_of(const MotionMode& mode) {
  if (&mode == &sliding_mode()) return Quantity::sliding_friction;
  return &mode == &rolling_mode() ? Quantity::rolling_friction : Quantity::torsion_friction;
}

/// Coefficients and offsets of Table 2 for a motion.
const Uncertain& coefficient(const PublishedSurface& surface, const MotionMode& mode) {
  return &mode == &sliding_mode() ? surface.sliding : surface.rolling_r;
}
const Uncertain& offset(const PublishedSurface& surface, const MotionMode& mode) {
  return &mode == &sliding_mode() ? surface.sliding_offset : surface.rolling_r_offset;
}

/// Of the mean over both contacts, what happens at the silicon's.
double contacts_in_mean(const MotionMode& mode) { return &mode == &rolling_mode() ? 2 : 1; }

/// The sphere's contact with the indenter, rolled under this load; none if the study lacks it.
const MovingContact* indenter_of(const MovingStudy& study, const PublishedColumn& column, double load) {
  for (const auto& contact : study.contacts)
    if (column.is_with_indenter(contact.bodies) && contact.find(rolling_mode(), load)) return &contact;
  return nullptr;
}

/// From the magnitudes of the result, which must be complete; those of one contact and motion stand together.
void add_laws(const PublishedColumn& column, AgainstPublished& result) {
  for (std::size_t first = 0, next; first < result.magnitudes.size(); first = next) {
    const MeasuredMagnitude& lead = result.magnitudes[first];
    std::vector<double> loads;
    std::vector<Uncertain> resistances;
    for (next = first; next < result.magnitudes.size(); ++next) {
      const MeasuredMagnitude& one = result.magnitudes[next];
      if (one.contact != lead.contact || one.mode != lead.mode) break;
      if (one.indenter != lead.indenter) continue;
      loads.push_back(one.load);
      resistances.push_back(one.simulated * one.load);
    }
    const PublishedSurface* surface = column.surface_of(lead.contact->bodies);
    if (loads.size() < 2 || !surface || lead.mode == &torsion_mode()) continue;
    const auto [low, high] = std::minmax_element(loads.begin(), loads.end());
    result.laws.push_back({lead.contact, lead.indenter, lead.mode, *low, *high,
                           coefficient_over_loads(lead.contact->bodies.rms, loads, resistances),
                           coefficient(*surface, *lead.mode), offset(*surface, *lead.mode)});
  }
}

/// Over the surfaces of Table 2: of the coefficient, or of the resistance over a load.
Trend published_trend(const Published& published, const MotionMode& mode, double load) {
  std::vector<double> rms;
  std::vector<Uncertain> values;
  for (const auto& surface : published.surfaces) {
    rms.push_back(surface.rms.value);
    values.push_back(
        std::isnan(load)
            ? coefficient(surface, mode)
            : propagate([load](const std::vector<double>& x) { return x[0] * (1 + x[1] / load); },
                        {coefficient(surface, mode), offset(surface, mode)}));
  }
  return fit_trend(rms, values);
}

/// Loads at which the paper measured: PublishedColumn knows them.
bool was_measured(const PublishedColumn& column, const MovingContact& contact, const MotionMode& mode,
                  double load) {
  return column.value(quantity_of(mode), contact.bodies, load).known();
}

void add_trends(const RoughnessTrend& trend, const PublishedColumn& column, const Published& published,
                AgainstPublished& result) {
  if (trend.mode == &torsion_mode() || column.plane_of(trend.contacts.front()->bodies) != "silicon") return;
  const double length = trend.mode == &sliding_mode() ? 1 : trend.contacts.front()->bodies.radius;
  const double both = contacts_in_mean(*trend.mode);
  for (const auto& at : trend.loads) {
    const bool inside = std::any_of(trend.contacts.begin(), trend.contacts.end(), [&](const auto* contact) {
      return was_measured(column, *contact, *trend.mode, at.load);
    });
    if (!inside) continue;
    const MovingState* state = nullptr;
    for (const auto* contact : trend.contacts)
      if (!state) state = contact->find(*trend.mode, at.load);
    const double to_paper = state->scale() / (at.load * length);
    result.trends.push_back({&trend, at.load, at.total.slope * to_paper,
                             published_trend(published, *trend.mode, at.load).slope * both});
  }
  if (std::isfinite(trend.coefficient.slope.value))
    result.trends.push_back(
        {&trend, NAN, trend.coefficient.slope, published_trend(published, *trend.mode, NAN).slope * both});
}

}  // namespace

AgainstPublished against_published(const MovingStudy& study, const std::vector<RoughnessTrend>& trends,
                                   const Published& published) {
  const PublishedColumn column(published);
  AgainstPublished result;
  std::set<std::string> reasons;
  for (const auto& contact : study.contacts)
    for (const auto& state : contact.states) {
      if (column.is_with_indenter(contact.bodies))
        continue;  // half of the measured means, not a contact of Table 2
      const ComparedValue value = column.value(quantity_of(*state.mode), contact.bodies, state.load);
      if (!value.known()) {
        reasons.insert(name_of(state.mode->motion) + ": " + value.reason);
        continue;
      }
      const double length = state.mode == &sliding_mode() ? 1 : contact.bodies.radius;
      const MovingContact* indenter =
          state.mode == &rolling_mode() ? indenter_of(study, column, state.load) : nullptr;
      const Uncertain resistance =
          indenter ? (state.resistance + indenter->find(rolling_mode(), state.load)->resistance) * 0.5
                   : state.resistance;
      result.magnitudes.push_back({&contact,
                                   indenter,
                                   state.mode,
                                   state.load,
                                   resistance * (1 / (state.load * length)),
                                   {value.value, value.sd},
                                   value.source});
    }
  add_laws(column, result);
  for (const auto& trend : trends) add_trends(trend, column, published, result);
  result.remarks.assign(reasons.begin(), reasons.end());
  return result;
}

}  // namespace asperity
