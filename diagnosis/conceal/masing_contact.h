// Partial slip under constant load in closed form: the virgin curve of Cattaneo and Mindlin, and Masing's
// rule for what follows each reversal, with memory of the turning points (Mindlin & Deresiewicz 1953; Johnson
// 1985, sec. 7.4):
//   Q(x) = L [1 - (1 - |x|/s)^(3/2)],  s = (3/2) L/k;   after a reversal at (x_r, Q_r):  Q = Q_r -+ 2 Q(|x -
//   x_r|/2).
// k = 8 G* a, L = mu f_n. SI units.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace asperity::hidden {

class MasingContact {
 public:
  MasingContact() = default;
  /// stiffness [N/m], limit [N].
  MasingContact(double stiffness, double limit) : stiffness_(stiffness), limit_(limit) {}

  /// Positions in order.
  double force(double x) {
    if (x == position_) return force_;
    const int direction = x > position_ ? 1 : -1;
    if (direction_ != 0 && direction != direction_) turns_.push_back({position_, force_});
    direction_ = direction;
    // A branch that has come as far as the turning point before the last closes its loop: both are forgotten.
    while (turns_.size() >= 2 && direction * (x - turns_[turns_.size() - 2].first) >= 0)
      turns_.resize(turns_.size() - 2);
    // The first branch goes over into the virgin curve of the other direction where it has passed the mirror
    // of its turning point.
    if (turns_.size() == 1 && std::abs(x - turns_[0].first) >= 2 * std::abs(turns_[0].first - origin_))
      turns_.clear();
    position_ = x;
    if (turns_.empty())
      force_ = virgin(x - origin_);
    else
      force_ = turns_.back().second + 2 * virgin((x - turns_.back().first) / 2);
    // Sliding carries the contact along: turning points lose their places, the limit stays.
    if (std::abs(force_) >= limit_) {
      force_ = std::copysign(limit_, force_);
      turns_.clear();
      origin_ = x - direction * travel();
    }
    return force_;
  }

 private:
  double travel() const { return 1.5 * limit_ / stiffness_; }
  double virgin(double x) const {
    const double part = std::abs(x) / travel();
    return std::copysign(part >= 1 ? limit_ : limit_ * (1 - std::pow(1 - part, 1.5)), x);
  }

  double stiffness_ = 0, limit_ = 0;
  double position_ = 0, force_ = 0, origin_ = 0;
  int direction_ = 0;
  std::vector<std::pair<double, double>> turns_;
};

}  // namespace asperity::hidden
