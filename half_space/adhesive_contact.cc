#include "half_space/adhesive_contact.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/quantity.h"
#include "core/threads.h"
#include "half_space/bounded_gradients.h"

namespace asperity::half_space {
namespace {

double sum_of(const Field& field) {
  return sums_over<1>(field.size(), [&](std::size_t k, auto& sum) { sum[0] += field[k]; })[0];
}

}  // namespace

AdhesiveContact::AdhesiveContact(const NormalContact& contact, Attraction attraction)
    : contact_(contact), attraction_(std::move(attraction)) {
  if (!attraction_.closing || !attraction_.opening || !(attraction_.range > 0))
    throw InputError("an adhesive half-space contact needs laws of attraction with a range above 0");
}

/// Nothing touches, nothing attracts.
AdhesiveSolution AdhesiveContact::without_attraction() const {
  AdhesiveSolution solution;
  const std::size_t cells = contact_.grid().cells();
  solution.contact.pressure.assign(cells, 0.0);
  solution.attraction.assign(cells, 0.0);
  solution.has_touched.assign(cells, 0);
  return solution;
}

AdhesiveSolution AdhesiveContact::at_force(double force, const NormalContactOptions& options,
                                           double tolerance) const {
  if (!(force >= 0) || !std::isfinite(force))
    throw InputError("an adhesive half-space contact needs a force of 0 or more");
  AdhesiveSolution solution = without_attraction();
  if (force > 0) {
    solution.contact = contact_.at_force(force, options);
  } else {
    solution.contact.gap = contact_.gap();
    const double touch = *std::min_element(contact_.gap().begin(), contact_.gap().end());
    for (double& gap : solution.contact.gap) gap -= touch;
  }
  settle(solution, true, force, options, tolerance);
  return solution;
}

AdhesiveSolution AdhesiveContact::at_approach(double approach, const NormalContactOptions& options,
                                              double tolerance) const {
  AdhesiveSolution solution = without_attraction();
  const double touch = *std::min_element(contact_.gap().begin(), contact_.gap().end());
  if (approach > touch) {
    solution.contact = contact_.at_approach(approach, options);
  } else {
    solution.contact.gap = contact_.gap();
    for (double& gap : solution.contact.gap) gap -= approach;
  }
  settle(solution, false, approach, options, tolerance);
  return solution;
}

AdhesiveSolution AdhesiveContact::separated(const AdhesiveSolution& closer, double approach,
                                            const NormalContactOptions& options, double tolerance) const {
  if (approach > closer.contact.approach)
    throw InputError("surfaces are separated to " + format_quantity(approach, Dimension::length) +
                     ", which is closer than the " +
                     format_quantity(closer.contact.approach, Dimension::length) + " they come from");
  AdhesiveSolution solution = closer;
  settle(solution, false, approach, options, tolerance);
  return solution;
}

/// Attraction of the gaps as they are. By how much its sum changed [N].
double AdhesiveContact::update_attraction(AdhesiveSolution& solution) const {
  constexpr int grain = 512;
  const Field& pressure = solution.contact.pressure;
  const Field& gap = solution.contact.gap;
  for_parts(static_cast<int>(gap.size()), grain, [&](int k, int end) {
    for (; k < end; ++k) {
      if (pressure[k] > 0) solution.has_touched[k] = 1;
      const double open = std::max(0.0, gap[k]);
      solution.attraction[k] =
          solution.has_touched[k] ? attraction_.opening(open) : attraction_.closing(open);
    }
  });
  const double before =
      std::exchange(solution.attracting, contact_.grid().cell_area() * sum_of(solution.attraction));
  return solution.attracting - before;
}

/// Attraction and contact in turn. What is left is the sum of a geometric series: the changes shrink by a
/// factor that the last two tell.
void AdhesiveContact::settle(AdhesiveSolution& solution, bool by_force, double value,
                             const NormalContactOptions& options, double tolerance) const {
  constexpr int most_updates = 2000;
  constexpr double no_faster_than = 0.5;
  Field pulled, gap(contact_.gap().size());
  NormalContactOptions how = options;
  how.tolerance = std::max(options.tolerance, 0.01 * tolerance);
  double change_before = 0;
  for (solution.updates = 0;; ++solution.updates) {
    const double change = std::abs(update_attraction(solution));
    const double factor =
        change_before > 0 ? std::clamp(change / change_before, no_faster_than, 0.999) : no_faster_than;
    const double left = change * factor / (1 - factor);
    if (solution.updates > 1 && left <= tolerance * solution.attracting) break;
    if (solution.updates == most_updates)
      throw WorkError("the attraction of the half-space contact does not settle in " +
                      std::to_string(most_updates) + " updates; take a larger range of attraction");
    change_before = change;
    contact_.compliance().apply(solution.attraction, pulled);
    for_entries(static_cast<int>(gap.size()), [&](int k) { gap[k] = contact_.gap()[k] - pulled[k]; });
    solution.contact.convolutions = 0;
    iterate(contact_.compliance(), gap, {by_force, by_force ? value + solution.attracting : value}, how,
            solution.contact);
    solution.force = solution.contact.force - solution.attracting;
  }
}

double AdhesiveContact::stiffness(const AdhesiveSolution& pressed,
                                  const NormalContactOptions& options) const {
  // The parabola through three states, far enough apart for the contact's edge to pass over cells.
  constexpr double share = 0.05, close = 1e-5;
  const double step =
      share * (pressed.contact.force > 0 ? pressed.contact.force / contact_.stiffness(pressed.contact)
                                         : attraction_.range);
  const AdhesiveSolution first = separated(pressed, pressed.contact.approach, options, close),
                         second = separated(first, pressed.contact.approach - step, options, close),
                         third = separated(second, pressed.contact.approach - 2 * step, options, close);
  return (3 * first.force - 4 * second.force + third.force) / (2 * step);
}

/// The tension over the approach has one maximum, or an end where the contact jumps apart: found between
/// states of equal steps, which are then halved.
PullOff AdhesiveContact::pull_off(const AdhesiveSolution& pressed, const NormalContactOptions& options,
                                  const OnSeparation& on_state) const {
  constexpr double steps_over_range = 4, tolerance = 2e-4, past_the_largest = 0.5, close_enough = 1e-3;
  constexpr int most_halvings = 10;
  const double touch = *std::min_element(contact_.gap().begin(), contact_.gap().end());
  double step = attraction_.range / steps_over_range;
  PullOff found;
  const auto at = [&](const AdhesiveSolution& closer, double approach) {
    ++found.states;
    AdhesiveSolution state = separated(closer, approach, options, tolerance);
    if (on_state) on_state(state.contact.approach, state.force);
    return state;
  };
  // Inwards from where undeformed surfaces touch, as long as the tension grows.
  AdhesiveSolution best = pressed, closer = pressed;
  if (touch < pressed.contact.approach) {
    best = at(pressed, touch);
    while (best.contact.approach + step < pressed.contact.approach) {
      closer = at(pressed, best.contact.approach + step);
      if (closer.force >= best.force) break;
      best = closer;
    }
    if (best.contact.approach + step >= pressed.contact.approach) closer = pressed;
  }
  // Outwards until it has fallen.
  AdhesiveSolution last = best;
  while (last.attracting > 0 && (last.force > 0 || last.force <= past_the_largest * best.force)) {
    AdhesiveSolution next = at(last, last.contact.approach - step);
    if (next.force < best.force) closer = last, best = next;
    last = std::move(next);
  }
  for (int n = 0; n < most_halvings; ++n) {
    step *= 0.5;
    const AdhesiveSolution inner = closer.contact.approach > best.contact.approach + step
                                       ? at(closer, best.contact.approach + step)
                                       : closer;
    const AdhesiveSolution outer = at(best, best.contact.approach - step);
    const double spread = std::max(inner.force, outer.force) - best.force;
    const bool is_found = std::abs(spread) <= close_enough * std::abs(best.force);
    if (outer.force < best.force && outer.force < inner.force)
      closer = std::exchange(best, outer);
    else if (inner.force < best.force)
      best = inner;
    else
      closer = inner;
    if (is_found) break;
  }
  found.force = std::max(0.0, -best.force);
  found.approach = best.contact.approach;
  return found;
}

}  // namespace asperity::half_space
