// Any of the torsion laws, as one value. advance() is pure: the caller keeps the history that was last
// accepted. SI units.
#pragma once

#include <vector>

#include "dem_compare/laws/any_law.h"
#include "dem_compare/laws/rotation_scales.h"

namespace asperity {

/// What a torsion law remembers of its contact; resistance: moment about the normal [N m].
struct TorsionHistory : SpringSlider<double> {
  double angle = 0;  ///< since the contact closed [rad]; of laws with partial slip
  std::vector<double>
      turns;  ///< angles at which the twist turned back and that no wider loop has wiped out [rad]
};

/// The kind, for the registry.
struct TorsionMode {
  static constexpr const char* name = "torsion";

  /// What every law of this kind gives.
  class Interface {
   public:
    virtual ~Interface() = default;
    /// After a relative rotation [rad] about the normal; `lever` [m]: from the particle's centre to the
    /// contact.
    virtual TorsionHistory advance(const TorsionHistory& before, const NormalState& normal, double lever,
                                   double increment) const = 0;
    /// Largest moment [N m].
    virtual double limit(const NormalState& normal, double lever) const = 0;
    /// lambda, the length that moments are counted in [m].
    virtual double length(const NormalState& normal, double lever) const = 0;
  };

  /// A law held as one of this kind.
  template <class Law>
  class Held final : public Interface {
   public:
    explicit Held(Law law) : law_(std::move(law)) {}
    TorsionHistory advance(const TorsionHistory& before, const NormalState& normal, double lever,
                           double increment) const override {
      return law_.advance(before, normal, lever, increment);
    }
    double limit(const NormalState& normal, double lever) const override { return law_.limit(normal, lever); }
    double length(const NormalState& normal, double lever) const override {
      return length_of(law_.length, normal, lever);
    }

   private:
    Law law_;
  };
};

using TorsionLaw = LawOf<TorsionMode>;

}  // namespace asperity
