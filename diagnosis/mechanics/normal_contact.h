// The law between the displacement of the contact and its normal force, with a history: the slot into which
// effects put theirs.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "core/hertz.h"

namespace asperity {

class NormalContact;
/// A contact as it was solved, in place of its reduced law; null: it stays that law.
using SolutionOfLaw = std::function<std::shared_ptr<const NormalContact>(const NormalContact& law)>;

class NormalContact {
 public:
  virtual ~NormalContact() = default;
  /// With its history.
  virtual std::unique_ptr<NormalContact> clone() const = 0;
  /// Force [N] at a displacement of the contact [m] that follows the history accepted last.
  virtual double force(double displacement) const = 0;
  /// Displacement at a force in closed form, where there is one; NaN: solve force() for it.
  /// [N] to [m].
  virtual double displacement(double) const { return std::numeric_limits<double>::quiet_NaN(); }
  /// A step of this duration begins [s]; 0 for the first sample of a run.
  virtual void begin_step(double) {}
  /// The step to this displacement was taken.
  virtual void accept(double) {}
  /// Displacement below which there is no contact, whatever came before [m].
  virtual double release() const { return 0; }
  /// Displacement at which surfaces that attract each other part: release(), or beyond it where they still do
  /// once they no longer touch [m].
  virtual double parting() const { return release(); }
  /// Force of a contact that has not parted, at any displacement [N]: down to parting(), and what is there
  /// beyond it.
  virtual double held_force(double displacement) const { return force(std::max(displacement, release())); }
  /// Force at which a solution of the contact is at this displacement [N]: of a body that relaxes the elastic
  /// one, for the elastic body is what was solved.
  virtual double solved_force(double displacement) const { return force(displacement); }
  /// This contact with what a solution makes of the law in it; null where that changes nothing.
  virtual std::shared_ptr<const NormalContact> solved_by(const SolutionOfLaw& solution) const {
    return solution(*this);
  }
  /// Law without history and adhesion, from which others are made; null if this is another.
  virtual const Hertz* hertz() const { return nullptr; }
};

/// Hertz' law, which has no history.
class HertzContact : public NormalContact {
 public:
  explicit HertzContact(const Hertz& law) : law_(law) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<HertzContact>(*this); }
  double force(double d) const override {
    return d <= 0 ? 0 : 4.0 / 3.0 * law_.reduced_modulus * std::sqrt(law_.radius * d) * d;
  }
  double displacement(double force) const override {
    return force > 0 ? std::cbrt(std::pow(force / (4.0 / 3.0 * law_.reduced_modulus), 2) / law_.radius)
                     : std::numeric_limits<double>::quiet_NaN();
  }
  const Hertz* hertz() const override { return &law_; }

 private:
  Hertz law_;
};

}  // namespace asperity
