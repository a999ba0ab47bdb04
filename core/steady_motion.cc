#include "core/steady_motion.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Values = std::vector<double>;

constexpr double few_sticking = 0.02, few_sticking_in_spin = 0.05, flat_share = 0.02;

double slope_to(const Values& x, const Values& y, std::size_t row) {
  return (y[row] - y[row - 1]) / (x[row] - x[row - 1]);
}

/// Where the resistance has stopped to grow.
std::size_t first_flat_row(const Values& x, const Values& y, const MotionLeg& leg) {
  constexpr std::size_t first_steps = 3;
  double steepest = 0;
  for (std::size_t i = leg.first + 1; i <= std::min(leg.first + first_steps, leg.last); ++i)
    steepest = std::max(steepest, std::abs(slope_to(x, y, i)));
  const auto flat = [&](std::size_t i) { return std::abs(slope_to(x, y, i)) < flat_share * steepest; };
  for (std::size_t i = leg.first + 2; i < leg.last; ++i)
    if (flat(i) && flat(i + 1)) return i;
  return leg.last + 1;
}

/// The first row from `from` on that does not rise towards the mean of those behind it.
std::size_t past_first_rise(const Values& resistance, const MotionLeg& leg, std::size_t from) {
  constexpr double reached = 0.99;
  double sum = 0;
  for (std::size_t i = from; i <= leg.last; ++i) sum += resistance[i];
  std::size_t row = from;
  for (; row < leg.last; ++row) {
    const double mean = sum / static_cast<double>(leg.last - row + 1), share = resistance[row] / mean;
    if (!(share < reached) || !(resistance[row + 1] / mean > share)) break;  // a mean of zero too
    sum -= resistance[row];
  }
  return row;
}

/// From where at most a share of the active contact nodes sticks; one past the leg's last: nowhere.
std::size_t first_row_sticking(const Values& sticking, const MotionLeg& leg, double at_most) {
  std::size_t row = leg.first + 1;
  while (row <= leg.last && sticking[row] > at_most) ++row;
  return row;
}

std::size_t first_rolling_row(const MotionRows& rows, const MotionLeg& leg) {
  std::size_t row = leg.first + 1;
  while (row <= leg.last && std::abs(rows.position[row] - rows.position[leg.first]) * rows.rolling_radius <
                                radii_rolled_until_steady * rows.contact_radius[row])
    ++row;
  return row;
}

std::size_t first_steady_row(const MotionRows& rows, const MotionLeg& leg) {
  if (rows.rolling_radius > 0) return first_rolling_row(rows, leg);
  if (rows.sticking.empty()) return first_flat_row(rows.position, rows.resistance, leg);
  const std::size_t slips = first_row_sticking(rows.sticking, leg, few_sticking);
  // Under little friction a contact slips as it is pressed: what sticks then tells nothing.
  if (slips == leg.first + 1) return past_first_rise(rows.resistance, leg, slips);
  if (!rows.spins) return slips;
  const std::size_t nearly = first_row_sticking(rows.sticking, leg, few_sticking_in_spin);
  return nearly > leg.last ? slips : std::min(slips, past_first_rise(rows.resistance, leg, nearly));
}

}  // namespace

std::vector<MotionLeg> motion_legs(const Values& x) {
  std::vector<MotionLeg> legs;
  if (x.empty()) return legs;
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  // Loading moves a rough contact sideways by less than this share of any motion that is prescribed.
  constexpr double rest_share = 2e-5;
  const double rest = rest_share * (*high - *low);
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double step = x[i] - x[i - 1];
    if (std::abs(step) <= rest) continue;
    const int direction = step > 0 ? 1 : -1;
    if (legs.empty() || legs.back().direction != direction) legs.push_back({i - 1, i, direction});
    legs.back().last = i;
  }
  return legs;
}

std::size_t steady_onset(const MotionRows& rows, const MotionLeg& leg) {
  const std::size_t from = first_steady_row(rows, leg);
  return from + fewest_steady_rows <= leg.last + 1 ? from : leg.last + 1;
}

SteadyRows steady_rows_of_first_leg(const MotionRows& rows) {
  const auto legs = motion_legs(rows.position);
  if (legs.empty()) return {};
  const std::size_t from = steady_onset(rows, legs.front());
  return from <= legs.front().last ? SteadyRows{from, legs.front().last} : SteadyRows{};
}

double per_path_length(const Values& position, const Values& sum, std::size_t first, std::size_t last) {
  return (sum[last] - sum[first]) / std::abs(position[last] - position[first]);
}

Values work_against_motion(const Values& position, const Values& resistance) {
  Values work(position.size(), 0.0);
  for (std::size_t i = 1; i < position.size(); ++i)
    work[i] = work[i - 1] + 0.5 * (resistance[i] + resistance[i - 1]) * (position[i] - position[i - 1]);
  return work;
}

}  // namespace asperity
