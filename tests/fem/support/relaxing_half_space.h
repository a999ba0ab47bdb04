// A sphere that rolls on a relaxing half-space, by boundary elements in time: another formulation of what the
// solver does with a body whose shear modulus relaxes, for bodies that do not change their volume.
#pragma once

#include <cmath>

#include "half_space/normal_contact.h"

namespace asperity::test {

/// In each cell, under pressures that change evenly over a step (standard linear solid, under stress),
///   u = v + q,  tau_c dq/dt = c v - q,  c = g/(1 - g),  tau_c = tau/(1 - g),
/// v: displacement of the fast elastic body.
class RelaxingHalfSpace {
 public:
  /// modulus: E* of fast loading [Pa]; share: g [-]; time: tau [s].
  RelaxingHalfSpace(double radius, double modulus, double share, double time, double load)
      : radius_(radius),
        modulus_(modulus),
        load_(load),
        part_(share / (1 - share)),
        time_(time / (1 - share)) {
    contact_radius_ = std::cbrt(0.75 * load * radius / (modulus * (1 - share)));
    constexpr int across = 64;
    constexpr double wide = 2.6;
    grid_ = {2 * across, across, wide * contact_radius_ / across, wide * contact_radius_ / across};
    elastic_.assign(grid_.cells(), 0.0), delayed_ = elastic_;
  }

  double contact_radius() const { return contact_radius_; }  ///< of Hertz, relaxed [m]

  /// Moment about the contact of steady rolling over the lag g tau/(1 - g) times speed times load [-];
  /// `speed` in contact radii per second.
  double steady_moment(double speed) {
    constexpr double from = -1.3, steady_from = -0.1, step = 0.05;  // contact radii
    const double lag = time_ * part_ / (1 + part_), soon = 1e-3 * time_, late = 1e3 * time_;
    moment_at(from, soon);
    moment_at(from, late);
    double sum = 0;
    int count = 0;
    for (double at = from + step; at < -from; at += step) {
      const double moment = moment_at(at, step / speed);
      if (at > steady_from) sum += moment, ++count;
    }
    return sum / count / (lag * speed * contact_radius_ * load_);
  }

 private:
  /// With the sphere over a place [contact radii], a time after the last [N m].
  double moment_at(double place, double time_step) {
    const double t = time_step / time_, left = std::exp(-t), mean = -std::expm1(-t) / t,
                 at_once = 1 + part_ * (1 - mean);
    half_space::Field gap(grid_.cells());
    for_each_cell([&](std::size_t k, double x, double y) {
      const double from_middle = x - place * contact_radius_;
      gap[k] = (from_middle * from_middle + y * y) / (2 * radius_) + delayed_[k] * left +
               part_ * (mean - left) * elastic_[k];
    });
    const half_space::NormalContact contact(grid_, half_space::Boundary::free, modulus_ / at_once, gap);
    const auto solution = contact.at_force(load_);
    half_space::Field pressed(grid_.cells());
    contact.compliance().apply(solution.pressure, pressed);
    double moment = 0;
    for_each_cell([&](std::size_t k, double x, double) {
      moment += solution.pressure[k] * grid_.cell_area() * (x - place * contact_radius_);
      const double before = elastic_[k];
      elastic_[k] = pressed[k] / at_once;
      delayed_[k] = delayed_[k] * left + part_ * (elastic_[k] * (1 - mean) + before * (mean - left));
    });
    return moment;
  }
  template <class Do>
  void for_each_cell(const Do& act) const {
    for (int j = 0; j < grid_.ny; ++j)
      for (int i = 0; i < grid_.nx; ++i)
        act(static_cast<std::size_t>(j) * grid_.nx + i, grid_.x(i), grid_.y(j));
  }

  double radius_, modulus_, load_, part_, time_, contact_radius_ = 0;
  half_space::Grid grid_;
  half_space::Field elastic_, delayed_;  ///< v and q [m]
};

}  // namespace asperity::test
