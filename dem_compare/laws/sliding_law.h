// Any of the sliding laws, as one value. advance() is pure: the caller keeps the history that was last
// accepted. SI units.
#pragma once

#include "dem_compare/laws/any_law.h"
#include "dem_compare/laws/normal_state.h"
#include "dem_compare/laws/sliding_history.h"

namespace asperity {

struct SlidingMode {
  static constexpr const char* name = "sliding";

  /// What every law of this kind gives.
  class Interface {
   public:
    virtual ~Interface() = default;
    /// History after a shift [m] of the particle's surface against the other one, at the new normal state.
    virtual SlidingHistory advance(const SlidingHistory& before, const NormalState& normal,
                                   const Eigen::Vector3d& increment) const = 0;
    /// Largest lateral force [N] at a normal force [N].
    virtual double limit(double normal_force) const = 0;
  };

  /// A law held as one of this kind.
  template <class Law>
  class Held final : public Interface {
   public:
    explicit Held(Law law) : law_(std::move(law)) {}
    SlidingHistory advance(const SlidingHistory& before, const NormalState& normal,
                           const Eigen::Vector3d& increment) const override {
      return law_.advance(before, normal, increment);
    }
    double limit(double normal_force) const override { return law_.friction.limit(normal_force); }

   private:
    Law law_;
  };
};

using SlidingLaw = LawOf<SlidingMode>;

}  // namespace asperity
