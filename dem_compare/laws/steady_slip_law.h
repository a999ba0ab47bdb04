// Any law of a contact that slips steadily, as one value: what it resists at a ratio of its velocities. Such
// a law has no stiffness and no history, so that a particle's contact is not led by it. SI units.
#pragma once

#include "dem_compare/laws/any_law.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

/// What resists steady slip.
struct SlipResistance {
  double force = 0;   ///< lateral [N]
  double moment = 0;  ///< about the normal [N m]
};

/// The kind, for the registry.
struct SteadySlipMode {
  static constexpr const char* name = "steady slip";

  /// What every law of this kind gives.
  class Interface {
   public:
    virtual ~Interface() = default;
    virtual const char* ratio() const = 0;  ///< the ratio of velocities with its unit, such as "creep [1]"
    /// Resistance at a ratio, in that unit.
    virtual SlipResistance at(const NormalState& normal, double ratio) const = 0;
  };

  /// A law held as one of this kind.
  template <class Law>
  class Held final : public Interface {
   public:
    explicit Held(Law law) : law_(std::move(law)) {}
    const char* ratio() const override { return Law::ratio; }
    SlipResistance at(const NormalState& normal, double ratio) const override {
      return law_.resistance(normal.force, normal.contact_radius, ratio);
    }

   private:
    Law law_;
  };
};

using SteadySlipLaw = LawOf<SteadySlipMode>;

}  // namespace asperity
