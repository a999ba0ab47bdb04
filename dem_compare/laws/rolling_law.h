// Any of the rolling laws, as one value: a spring that yields at the law's limit. SI units.
#pragma once

#include "dem_compare/laws/any_law.h"
#include "dem_compare/laws/rotation_scales.h"

namespace asperity {

using RollingHistory = SpringSlider<Eigen::Vector3d>;  ///< resistance: moment [N m]

struct RollingMode {
  static constexpr const char* name = "rolling";

  /// What every law of this kind gives.
  class Interface {
   public:
    virtual ~Interface() = default;
    /// After a relative rotation [rad] in the contact plane; `lever` [m]: from the particle's centre to the
    /// contact.
    virtual RollingHistory advance(const RollingHistory& before, const NormalState& normal, double lever,
                                   const Eigen::Vector3d& increment) const = 0;
    /// Largest moment [N m].
    virtual double limit(const NormalState& normal, double lever) const = 0;
    /// lambda, the length that moments are counted in [m].
    virtual double length(const NormalState& normal, double lever) const = 0;
  };

  /// A law states its limit, its length scale and its spring.
  template <class Law>
  class Held final : public Interface {
   public:
    explicit Held(Law law) : law_(std::move(law)) {}
    RollingHistory advance(const RollingHistory& before, const NormalState& normal, double lever,
                           const Eigen::Vector3d& increment) const override {
      return advance_spring(law_, before, normal, lever, increment);
    }
    double limit(const NormalState& normal, double lever) const override { return law_.limit(normal, lever); }
    double length(const NormalState& normal, double lever) const override {
      return length_of(law_.length, normal, lever);
    }

   private:
    Law law_;
  };
};

using RollingLaw = LawOf<RollingMode>;

}  // namespace asperity
