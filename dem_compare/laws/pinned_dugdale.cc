#include "dem_compare/laws/pinned_dugdale.h"

#include <cmath>
#include <limits>

namespace asperity {

PinnedDugdale::PinnedDugdale(double lambda, double ratio)
    : ratio_(ratio),
      approach_of_closing_(std::cbrt(ratio * ratio)),
      radius_of_closing_(std::cbrt(ratio)),
      closing_(lambda * approach_of_closing_),
      opening_(lambda) {}

PinnedDugdale::Contact PinnedDugdale::grown(const MaugisBranch::Contact& own) const {
  const double a = own.radius * radius_of_closing_;
  return {own.approach * approach_of_closing_, own.force * ratio_, a, a, own.edge * radius_of_closing_};
}

PinnedDugdale::Contact PinnedDugdale::peeled(const MaugisBranch::Contact& contact) const {
  return {contact.approach, contact.force, contact.radius, contact.edge, contact.edge};
}

PinnedDugdale::Contact PinnedDugdale::at(double approach, const Contact& before, const Contact& near,
                                         const HeldCurve* curve) const {
  const bool was_free = !(before.held_edge > 0);
  if (!std::isfinite(approach) || (was_free && approach < 0)) return {approach, 0, 0, 0, 0};
  const double own = approach / approach_of_closing_;
  if (was_free) return grown(closing_.contact(own));
  if (approach == before.approach) return before;
  if (approach > before.approach && own > closing_.release()) {
    const Contact contact = grown(closing_.contact(own));
    if (contact.radius >= before.held_edge) return contact;
  }
  return opened(approach, before, near, curve);
}

PinnedDugdale::Contact PinnedDugdale::opened(double approach, const Contact& before, const Contact& near,
                                             const HeldCurve* curve) const {
  if (curve && curve->holds(approach)) return curve->at(approach);
  if (approach < parting()) return {approach, 0, 0, 0, 0};
  const bool touches = approach > release();
  if (approach < before.approach) {
    if (touches) {
      const MaugisBranch::Contact contact = opening_.contact(approach);
      if (contact.edge <= before.held_edge) return peeled(contact);
    } else if (const double c = opening_.edge_apart(approach); c <= before.held_edge) {
      return {approach, opening_.force_apart(approach), 0, c, c};
    }
  }
  if (touches && curve && curve->is_beyond(approach)) return {approach, 0, 0, 0, 0};
  const HeldDugdale held(opening_.lambda(), ratio_, before.held_edge);
  Contact found{};
  const Contact& start = near.held_edge == before.held_edge && !near.apart() ? near : before;
  if (touches && held.solve(approach, false, start, found)) return found;
  const Contact apart = held.apart(approach);
  if (held.is_apart(apart)) return apart;
  // Too small to be stable where its edge lets go, it breaks.
  return touches && held.search(approach, found) ? found : Contact{approach, 0, 0, 0, 0};
}

PinnedDugdale::Contact PinnedDugdale::under(double force, const Contact& before) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Contact nowhere{none, none, none, none, none};
  const bool was_free = !(before.held_edge > 0);
  if (force <= (was_free ? 0 : -pull_off())) return nowhere;
  if (was_free) return grown(closing_.contact_under(force / ratio_));
  if (force == before.force) return before;
  if (force > before.force && force > -pull_off_unpressed()) {
    const Contact contact = grown(closing_.contact_under(force / ratio_));
    if (contact.radius >= before.held_edge) return contact;
  }
  if (force < before.force) {
    const MaugisBranch::Contact contact = opening_.contact_under(force);
    if (contact.edge <= before.held_edge) return peeled(contact);
  }
  Contact found{};
  const HeldDugdale held(opening_.lambda(), ratio_, before.held_edge);
  return held.solve(force, true, before, found) ? found : nowhere;
}

}  // namespace asperity
