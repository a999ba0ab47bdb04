#include "fem/contact/interface_tractions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/threads.h"
#include "fem/contact/rate_limited_shear.h"

namespace asperity::fem {

InterfaceTractions::InterfaceTractions(const ContactSystem& system, const FrictionLaw* friction,
                                       const AdhesionLaws& adhesion, double penalty)
    : system_(system),
      friction_(friction),
      adhesion_(adhesion),
      penalty_(penalty),
      pressure_(system.rows().size(), 0.0),
      history_size_(history_size()) {
  if (has_adhesion()) attraction_.assign(pressure_.size(), {0, 0, 0});
  if (!friction_) return;
  limit_.assign(pressure_.size(), 0.0);
  shear_.assign(pressure_.size(), Shear{{0, 0}, 0, 0, 0, true});
}

std::array<std::vector<double>, 2> InterfaceTractions::slips(const InterfaceOperator& interface,
                                                             const ContactState& state) const {
  // The particle's own node is placed by the state's own motion, whatever the turn under which the interfaces
  // are coupled.
  const double radius = system_.options().mesh.sizes.radius;
  const Rotation turn = rotation(state.motion);
  std::array<std::vector<double>, 3> displacement;
  for (int c = 0; c < 3; ++c) displacement[c] = interface.nodes().gather(state.displacement.begin(), c);
  std::array<std::vector<double>, 2> slips;
  for (auto& component : slips) component.resize(pressure_.size());
  constexpr int grain = 128;
  for_parts(static_cast<int>(pressure_.size()), grain, [&](int first, int last) {
    for (int r = first; r < last; ++r) {
      const int own = system_.rows()[r].node;
      auto point = system_.interface_points()[own];
      for (int c = 0; c < 3; ++c) point[c] += displacement[c][own];
      const auto place = turned(turn, point, radius);
      slips[0][r] = place[0] + state.motion.x;
      slips[1][r] = place[1] + state.motion.y;
      interface.for_row(r, [&](int node, double weight) {
        if (node == own) return;
        for (int c = 0; c < 2; ++c) slips[c][r] += weight * displacement[c][node];
      });
    }
  });
  return slips;
}

void InterfaceTractions::begin_step(const ContactState& accepted, const RigidMotion& motion,
                                    const std::vector<double>& gaps_before, const std::vector<double>& gaps,
                                    bool load_grows, double time_step) {
  time_ = accepted.time + time_step, time_step_ = time_step;
  if (!friction_) return;
  gap_ = gaps;
  for (auto& component : slip_) component.assign(pressure_.size(), 0.0);
  start_ = slip_origin_ = slips(system_.interface(), accepted);
  start_before_ = slips(system_.interface_before(), accepted);
  shear_before_ = accepted.shear;
  limit_before_.resize(pressure_.size());
  for (std::size_t r = 0; r < pressure_.size(); ++r)
    limit_before_[r] = accepted.friction_history[r * history_size_ + 1];
  const double radius = system_.options().mesh.sizes.radius;
  const Rotation from = rotation(accepted.motion), to = rotation(motion);
  for (std::size_t r = 0; r < pressure_.size(); ++r) {
    if (accepted.multiplier[r] > 0) continue;
    // Of the gap, what the motion alone closes. A growing load closes the rest, next to a contact whose
    // stress has kept the surfaces there opposite each other all along.
    const double by_motion = gaps_before[r] > 0 ? std::max(0.0, 1 - gaps[r] / gaps_before[r]) : 0.0;
    const double open_part = by_motion > 1 ? 1 / by_motion : load_grows ? by_motion : 1.0;
    const auto& point = system_.interface_points()[system_.rows()[r].node];
    const auto before = turned(from, point, radius), after = turned(to, point, radius);
    const double slip[2] = {after[0] - before[0] + motion.x - accepted.motion.x,
                            after[1] - before[1] + motion.y - accepted.motion.y};
    for (int c = 0; c < 2; ++c) slip_origin_[c][r] += open_part * slip[c];
  }
  update_limits(accepted);
}

void InterfaceTractions::update_limits(const ContactState& state) {
  for (std::size_t r = 0; r < limit_.size(); ++r) limit_[r] = shear_limit(state, r, state.multiplier[r]);
}

InterfacePoint InterfaceTractions::point(const ContactState& state, std::size_t row, double pressure) const {
  InterfacePoint point;
  point.pressure = pressure;
  point.gap = gap_[row];
  if (pressure > 0 && shear_[row].slips) point.slip = {slip_[0][row], slip_[1][row]};
  const double step_slip = std::hypot(point.slip[0], point.slip[1]);
  point.slip_path = state.friction_history[row * history_size_] + step_slip;
  point.slip_rate = time_step_ > 0 ? step_slip / time_step_ : 0;
  point.time = time_, point.time_step = time_step_;
  return point;
}

double InterfaceTractions::shear_limit(const ContactState& state, std::size_t row, double pressure) const {
  const double* history = state.friction_history.data() + row * history_size_ + kept_of_all_laws;
  // Under a law that resists by rate, whatever shear there is, is the limit at the slip that there is.
  if (resists_by_rate()) return std::hypot(state.shear[0][row], state.shear[1][row]);
  return friction_->limit(point(state, row, pressure), history).stress;
}

Shear InterfaceTractions::shear_at(const ContactState& state, std::size_t row, double pressure) const {
  const PlaneVector trial{state.shear[0][row] - penalty_ * slip_[0][row],
                          state.shear[1][row] - penalty_ * slip_[1][row]};
  if (!held_.empty() && held_[row] && limit_[row] > 0)
    return return_to_limit(trial, std::numeric_limits<double>::infinity());
  if (!resists_by_rate()) return return_to_limit(trial, limit_[row]);
  const double* history = state.friction_history.data() + row * history_size_;
  InterfacePoint before = point(state, row, pressure);
  before.slip_path = history[0];
  return return_to_rate(*friction_, before, history + kept_of_all_laws, trial, penalty_);
}

void InterfaceTractions::update_history(ContactState& state) const {
  state.time = time_;
  if (!friction_) return;
  for (std::size_t r = 0; r < pressure_.size(); ++r) {
    double* kept = state.friction_history.data() + r * history_size_;
    const InterfacePoint reached = point(state, r, state.multiplier[r]);
    kept[1] = shear_limit(state, r, state.multiplier[r]);
    kept[0] = reached.slip_path;
    friction_->remember(reached, kept + kept_of_all_laws);
  }
}

void InterfaceTractions::evaluate(const ContactState& state, const std::vector<double>& gaps) {
  for (std::size_t r = 0; r < pressure_.size(); ++r)
    pressure_[r] = std::max(0.0, state.multiplier[r] - penalty_ * gaps[r]);
  for (std::size_t r = 0; r < attraction_.size(); ++r)
    attraction_[r] = attraction(state, static_cast<int>(r), gaps[r]);
  if (!friction_) return;
  gap_ = gaps;
  slip_ = slips(system_.interface(), state);
  for (std::size_t r = 0; r < pressure_.size(); ++r) {
    for (int c = 0; c < 2; ++c) slip_[c][r] -= slip_origin_[c][r];
    shear_[r] = shear_at(state, r, state.multiplier[r]);
  }
}

void InterfaceTractions::hold_unless_slipping_on(const ContactState& state) {
  constexpr double at_limit = 0.99;
  const auto moved = slips(system_.interface(), state);
  held_.assign(shear_.size(), 1);
  for (std::size_t r = 0; r < held_.size(); ++r) {
    const double tx = state.shear[0][r], ty = state.shear[1][r];
    const double along = tx * (moved[0][r] - slip_origin_[0][r]) + ty * (moved[1][r] - slip_origin_[1][r]);
    held_[r] = !(along < 0 && std::hypot(tx, ty) > at_limit * limit_[r]);
  }
}

void InterfaceTractions::hold_sticking() {
  held_.assign(shear_.size(), 0);
  for (std::size_t r = 0; r < shear_.size(); ++r) held_[r] = !shear_[r].slips;
}

void InterfaceTractions::update_multipliers(ContactState& state, double share) const {
  const auto move = [share](double& from, double to) { from = share < 1 ? from + share * (to - from) : to; };
  for (std::size_t r = 0; r < pressure_.size(); ++r) move(state.multiplier[r], pressure_[r]);
  for (std::size_t r = 0; r < shear_.size(); ++r)
    for (int c = 0; c < 2; ++c) move(state.shear[c][r], shear_[r].traction[c]);
}

InterfaceTractions::Change InterfaceTractions::change(const ContactState& state) const {
  double change = 0, total = 0, shear_change = 0, shear_total = 0;
  const auto& areas = system_.areas();
  for (std::size_t r = 0; r < pressure_.size(); ++r) {
    change += areas[r] * std::abs(pressure_[r] - state.multiplier[r]);
    total += areas[r] * pressure_[r];
  }
  for (std::size_t r = 0; r < shear_.size(); ++r) {
    const auto& t = shear_[r].traction;
    const auto size = [](const PlaneVector& v) { return std::hypot(v[0], v[1]); };
    const double limit_change = resists_by_rate() ? size(shear_at(state, r, pressure_[r]).traction) - size(t)
                                                  : shear_limit(state, r, pressure_[r]) - limit_[r];
    shear_change +=
        areas[r] * (size({t[0] - state.shear[0][r], t[1] - state.shear[1][r]}) + std::abs(limit_change));
    shear_total += areas[r] * std::hypot(t[0], t[1]);
  }
  // Shear far below the pressures, as in purely normal contact, need not be known to a fraction of itself.
  constexpr double weightless = 1e-3;
  shear_total = std::max(shear_total, weightless * total);
  return {total > 0 ? change / total : 0.0, shear_total > 0 ? shear_change / shear_total : 0.0};
}

void InterfaceTractions::add_forces(double* y) const {
  std::vector<double> forces(pressure_.size());
  for (std::size_t r = 0; r < forces.size(); ++r) forces[r] = pressure_[r] * system_.areas()[r];
  for (std::size_t r = 0; r < attraction_.size(); ++r)
    forces[r] -= attraction_[r].stress * system_.areas()[r];
  system_.interface().add_normal_forces(forces, y);
  if (!friction_) return;
  for (int c = 0; c < 2; ++c) {
    for (std::size_t r = 0; r < forces.size(); ++r) forces[r] = shear_[r].traction[c] * system_.areas()[r];
    system_.interface().add_forces(forces, y, c);
  }
}

double InterfaceTractions::total_force() const {
  double total = 0;
  for (std::size_t r = 0; r < pressure_.size(); ++r) total += pressure_[r] * system_.areas()[r];
  return total;
}

double InterfaceTractions::carried_load(const ContactState& accepted, const std::vector<double>& gaps) const {
  double load = 0;
  for (std::size_t r = 0; r < pressure_.size(); ++r) {
    const double pull = has_adhesion() ? attraction(accepted, static_cast<int>(r), gaps[r]).stress : 0.0;
    load += system_.areas()[r] * (accepted.multiplier[r] - pull);
  }
  return load;
}

double InterfaceTractions::shear_share() const {
  const double total = total_force();
  double shear = 0;
  for (std::size_t r = 0; r < shear_.size(); ++r)
    shear += system_.areas()[r] * std::hypot(shear_[r].traction[0], shear_[r].traction[1]);
  return total > 0 ? shear / total : 0.0;
}

int InterfaceTractions::closed() const {
  return static_cast<int>(std::count_if(pressure_.begin(), pressure_.end(), [](double p) { return p > 0; }));
}
bool InterfaceTractions::any_closed() const { return closed() > 0; }

int InterfaceTractions::sticking() const {
  return static_cast<int>(
      std::count_if(shear_.begin(), shear_.end(), [](const Shear& s) { return !s.slips; }));
}

std::vector<RowStiffness> InterfaceTractions::stiffness(bool convex, SlipStiffness slip) const {
  std::vector<RowStiffness> stiffness(pressure_.size());
  for (std::size_t r = 0; r < stiffness.size(); ++r) {
    const double k = penalty_ * system_.areas()[r];
    if (pressure_[r] > 0) stiffness[r].normal = k;
    if (!convex && !attraction_.empty()) stiffness[r].normal += attraction_[r].slope * system_.areas()[r];
    if (!friction_) continue;
    if (slip == SlipStiffness::secant && shear_[r].slips) {
      stiffness[r].xx = stiffness[r].yy = k * shear_[r].secant();
      continue;
    }
    stiffness[r].xx = k * shear_[r].xx;
    stiffness[r].xy = k * shear_[r].xy;
    stiffness[r].yy = k * shear_[r].yy;
  }
  return stiffness;
}

double InterfaceTractions::friction_work(const ContactState& state) const {
  if (!friction_) return 0;
  const auto here = slips(system_.interface(), state), seen_before = slips(system_.interface_before(), state);
  double work = 0;
  for (std::size_t r = 0; r < shear_.size(); ++r) {
    const double tx = shear_[r].traction[0], ty = shear_[r].traction[1], now = std::hypot(tx, ty);
    if (!shear_[r].slips) {
      work -= system_.areas()[r] * (tx * slip_[0][r] + ty * slip_[1][r]);
      continue;
    }
    const double slip[2] = {0.5 * (here[0][r] - start_[0][r] + seen_before[0][r] - start_before_[0][r]),
                            0.5 * (here[1][r] - start_[1][r] + seen_before[1][r] - start_before_[1][r])};
    // Slipping rows transmit their shear limit, taken as the mean of where slip began and where it ended,
    // also where contact began or ended within the step. What stuck begins to slip when its limit has fallen
    // to its shear.
    const double stuck = std::hypot(shear_before_[0][r], shear_before_[1][r]),
                 began = std::min(limit_before_[r], std::max(stuck, now));
    const double bx = now > 0 ? tx : shear_before_[0][r], by = now > 0 ? ty : shear_before_[1][r],
                 size = std::hypot(bx, by);
    // Slip that reversed within the step ends against its mean: it dissipated, but the amount does not follow
    // from both ends and counts as zero.
    if (size > 0)
      work += system_.areas()[r] * 0.5 * (began + now) * std::max(0.0, -(bx * slip[0] + by * slip[1]) / size);
  }
  return work;
}

}  // namespace asperity::fem
