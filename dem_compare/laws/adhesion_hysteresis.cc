#include "dem_compare/laws/adhesion_hysteresis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "core/error.h"
#include "core/quantity.h"
#include "dem_compare/laws/pinned_dugdale.h"

namespace asperity {
namespace {

/// Made once for many states of the same contact.
const PinnedDugdale& pinned_dugdale(double lambda, double ratio) {
  struct Kept {
    double lambda, ratio;
    std::unique_ptr<const PinnedDugdale> law;
  };
  constexpr std::size_t most = 4;
  thread_local std::array<Kept, most> kept{};
  thread_local std::size_t oldest = 0;
  for (const Kept& one : kept)
    if (one.law && one.lambda == lambda && one.ratio == ratio) return *one.law;
  Kept& place = kept[oldest];
  oldest = (oldest + 1) % most;
  place = {lambda, ratio, std::make_unique<const PinnedDugdale>(lambda, ratio)};
  return *place.law;
}

}  // namespace

double AdhesionHysteresisLaw::lambda() const {
  constexpr double jkr = 100;  // force and pull-off within 1e-4 of the limit
  return std::min(jkr, units().lambda(work_of_separation / range));
}

double AdhesionHysteresisLaw::pull_off_force() const {
  return pinned_dugdale(lambda(), closing_ratio).pull_off() * units().force();
}

NormalState AdhesionHysteresisLaw::advance(const NormalState& before, double approach) const {
  const PinnedDugdale& law = pinned_dugdale(lambda(), closing_ratio);
  const double length = units().length(), depth = units().approach(), at = approach / depth;
  PinnedDugdale::Contact last{};
  if (before.touching)
    last = {before.approach / depth, before.force / units().force(), before.contact_radius / length,
            before.joined_radius / length, before.attraction_radius / length};
  const PinnedDugdale::Contact now = law.at(at, last);
  NormalState state{approach, 0, 0, 0, false};
  if (!(now.held_edge > 0)) return state;
  state.touching = true;
  state.force = now.force * units().force();
  state.contact_radius = now.radius * length;
  state.joined_radius = now.held_edge * length;
  state.attraction_radius = now.attraction_edge * length;
  // Of the parabola through here and two states ahead, or behind where it breaks ahead.
  constexpr double step = 1e-4;
  const bool opens = before.touching && at < last.approach, breaks = opens && at - 2 * step < law.parting();
  const double by = opens && !breaks ? -step : step,
               slope = (4 * law.at(at + by, last).force - law.at(at + 2 * by, last).force - 3 * now.force) /
                       (2 * by);
  state.stiffness = slope * units().force() / depth;
  return state;
}

double AdhesionHysteresisLaw::approach(double force) const {
  const PinnedDugdale& law = pinned_dugdale(lambda(), closing_ratio);
  // Just formed: on the branch of w_c under any force that it carries.
  constexpr double no_edge = 1e-12;
  const PinnedDugdale::Contact formed{-1e3, -law.pull_off(), no_edge, no_edge, no_edge};
  const PinnedDugdale::Contact found = law.under(force / units().force(), formed);
  if (!std::isfinite(found.approach))
    throw InputError("an adhesive contact that was not pressed before cannot carry " +
                     format_quantity(force, Dimension::force) + "; its pull-off force is " +
                     format_quantity(law.pull_off_unpressed() * units().force(), Dimension::force));
  return found.approach * units().approach();
}

}  // namespace asperity
