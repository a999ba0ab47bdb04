// The surface is not perpendicular to the load: f_l = f + tan(theta) f_n, the same sign in both directions.
#include <cmath>

#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

class SurfaceTilt : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"surface_tilt",
                                     "Tilt of the surface",
                                     "f_l = f + tan(theta) f_n",
                                     "Bhushan & Ruan 1994; Sundararajan & Bhushan 2000",
                                     "A part of the normal load points along the tilted surface; it keeps "
                                     "its sign when the motion reverses, and grows with load.",
                                     EffectKind::instrument,
                                     {Motion::sliding, Motion::rolling}};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_both_directions; }
  std::vector<EffectParameter> parameters(const Experiment&) const override {
    constexpr double steepest = 0.5, slight = 0.01;  // [rad]
    return {{"angle",
             "rad",
             "theta of the surface against the perpendicular to the load",
             -steepest,
             steepest,
             false,
             {-slight, slight}}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    const double slope = std::tan(p[0]);
    m.lateral.additions.push_back([slope](const Sample& s) { return slope * s.normal_force; });
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(surface_tilt, SurfaceTilt)
