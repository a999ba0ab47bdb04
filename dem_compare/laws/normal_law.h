// Any of the normal laws, as one value. advance() is pure: the caller keeps the state that was last accepted.
// SI units.
#pragma once

#include "dem_compare/laws/any_law.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

struct NormalMode {
  static constexpr const char* name = "normal";

  /// What every law of this kind gives.
  class Interface {
   public:
    virtual ~Interface() = default;
    /// State at an approach [m] that was reached from `before`.
    virtual NormalState advance(const NormalState& before, double approach) const = 0;
    /// Approach in equilibrium with a pressing force [N].
    virtual double approach(double force) const = 0;
    virtual double radius() const = 0;  ///< R [m]
  };

  /// A law held as one of this kind.
  template <class Law>
  class Held final : public Interface {
   public:
    explicit Held(Law law) : law_(std::move(law)) {}
    NormalState advance(const NormalState& before, double approach) const override {
      return law_.advance(before, approach);
    }
    double approach(double force) const override { return law_.approach(force); }
    double radius() const override { return law_.radius; }

   private:
    Law law_;
  };
};

using NormalLaw = LawOf<NormalMode>;

}  // namespace asperity
