// What laws of rolling and of torsion have in common: a moment against a relative rotation. SI units.
#pragma once

#include <type_traits>
#include <utility>

#include "dem_compare/laws/rotation_scales.h"

namespace asperity {

/// `History`: what a law remembers of its contact; `Rotation`: a vector, or a number about one axis.
template <class History, class Rotation>
struct RotationMode {
  /// What every law of this kind gives.
  class Interface {
   public:
    virtual ~Interface() = default;
    /// After a relative rotation [rad]; `lever` [m]: from the particle's centre to the contact. Pure: the
    /// caller keeps the history that was last accepted.
    virtual History advance(const History& before, const NormalState& normal, double lever,
                            const Rotation& increment) const = 0;
    /// Largest moment [N m].
    virtual double limit(const NormalState& normal, double lever) const = 0;
    /// lambda, the length that moments are counted in [m].
    virtual double length(const NormalState& normal, double lever) const = 0;
  };

  /// A law states its limit, its length scale, and its spring, or how it advances.
  template <class Law>
  class Held final : public Interface {
   public:
    explicit Held(Law law) : law_(std::move(law)) {}
    History advance(const History& before, const NormalState& normal, double lever,
                    const Rotation& increment) const override {
      if constexpr (advances_itself<Law>::value)
        return law_.advance(before, normal, lever, increment);
      else
        return History{advance_spring<Law, Rotation>(law_, before, normal, lever, increment)};
    }
    double limit(const NormalState& normal, double lever) const override { return law_.limit(normal, lever); }
    double length(const NormalState& normal, double lever) const override {
      return length_of(law_.length, normal, lever);
    }

   private:
    Law law_;
  };

 private:
  template <class Law, class = void>
  struct advances_itself : std::false_type {};
  template <class Law>
  struct advances_itself<Law, std::void_t<decltype(&Law::advance)>> : std::true_type {};
};

}  // namespace asperity
