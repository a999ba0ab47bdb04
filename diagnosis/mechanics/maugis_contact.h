// A contact that attracts by a constant stress out to a gap (Maugis 1992, dem_compare/laws/maugis_branch.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "diagnosis/mechanics/attraction_in_case.h"
#include "diagnosis/mechanics/normal_contact.h"

namespace asperity {

/// It forms at d = 0 and breaks where d has its minimum (fixed grips), or a spring in series lets it.
class MaugisContact : public NormalContact {
 public:
  /// force: pi w R [N]; lambda: Maugis' [-].
  MaugisContact(const Hertz& law, double force, double lambda)
      : branch_(maugis_branch(lambda)),
        force_(force),
        approach_(std::cbrt(std::pow(force / (4.0 / 3 * law.reduced_modulus), 2) / law.radius)) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<MaugisContact>(*this); }
  double release() const override { return approach_ * branch_->release(); }
  double force(double d) const override {
    return d < (touching_ ? release() : 0) ? 0 : force_ * branch_->force(d / approach_);
  }
  double displacement(double force) const override {
    if (force <= (touching_ ? -force_ * branch_->pull_off() : 0.0))
      return std::numeric_limits<double>::quiet_NaN();
    return approach_ * branch_->approach(force / force_);
  }
  double parting() const override { return approach_ * branch_->parting(); }
  double held_force(double d) const override {
    const double place = std::max(d, parting()) / approach_;
    return force_ * (place < branch_->release() ? branch_->force_apart(place) : branch_->force(place));
  }
  void accept(double d) override { touching_ = d >= (touching_ ? release() : 0); }

 private:
  std::shared_ptr<const MaugisBranch> branch_;
  double force_, approach_;  ///< Maugis' units [N], [m]
  bool touching_ = false;
};

}  // namespace asperity
