// An effect of somebody's own, all of it: the reading of an interferometer errs periodically along the
// displacement (Heydemann 1981), d = d_contact + A sin(2 pi d/p) with the period p = 15 nm.
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "core/registry.h"
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

constexpr double period = 15e-9;  // [m]

class PeriodicReading : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{"periodic_reading",
                                     "Periodic error of the displacement",
                                     "d = d_contact + A sin(2 pi d/p)",
                                     "Heydemann 1981",
                                     "The interferometer reads too much and too little in turns.",
                                     EffectKind::instrument,
                                     {Motion::normal},
                                     {},
                                     {}};
    return d;
  }
  std::vector<EffectParameter> parameters(const Experiment&) const override {
    return {{"amplitude", "m", "A", -period / 4, period / 4, false, {-period / 50, period / 50}}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.shifts.push_back([amplitude = p[0]](const Sample& s) {
      return amplitude * std::sin(boost::math::double_constants::two_pi * s.normal_displacement / period);
    });
  }
};

const Registered<std::unique_ptr<Effect> (*)()> entry{
    []() -> std::unique_ptr<Effect> { return std::make_unique<PeriodicReading>(); }};

}  // namespace
}  // namespace asperity
