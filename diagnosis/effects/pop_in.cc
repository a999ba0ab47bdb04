// A burst of displacement when the force first passes a threshold (dislocations nucleate, a film breaks):
// from then on the contact lies deeper by the jump,
//   f = f_law(d) up to f_0,  f = f_law(d - jump) afterwards.
// Under a driven displacement the force drops, under a driven force the displacement jumps.
#include <algorithm>
#include <cmath>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/contact_on_law.h"

namespace asperity {
namespace {

class ContactWithBurst : public ContactOnLaw {
 public:
  ContactWithBurst(const NormalContact& law, double jump, double threshold)
      : ContactOnLaw(law), jump_(jump), threshold_(threshold) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<ContactWithBurst>(*this); }
  std::shared_ptr<const NormalContact> solved_by(const SolutionOfLaw& solution) const override {
    const auto solved = law().solved_by(solution);
    return solved ? std::make_shared<ContactWithBurst>(*solved, jump_, threshold_) : nullptr;
  }
  double release() const override { return law().release() + (has_burst_ ? jump_ : 0); }
  double force(double d) const override { return law().force(d - (bursts_at(d) ? jump_ : 0)); }
  double displacement(double force) const override {
    return law().displacement(force) + (has_burst_ || force > threshold_ ? jump_ : 0);
  }
  void accept(double d) override {
    has_burst_ = bursts_at(d);
    ContactOnLaw::accept(d - (has_burst_ ? jump_ : 0));
  }

 private:
  bool bursts_at(double d) const { return has_burst_ || law().force(d) > threshold_; }
  double jump_, threshold_;
  bool has_burst_ = false;
};

/// A step of the residual between two neighbours, means of a few samples to either side.
struct Step {
  double size = 0;       ///< in the unit of the response
  double force = 0;      ///< where it begins [N]
  double stiffness = 0;  ///< of the recording there [N/m]
};

Step largest_step(const Samples& samples, const SampleRun& run, const std::vector<double>& residual) {
  constexpr std::size_t reach = 3;
  Step largest;
  for (std::size_t i = run.begin + reach; i + reach < run.end; ++i) {
    const Sample &before = samples.list[i - 1], &after = samples.list[i + reach - 1];
    if (before.part != after.part || before.direction < 0 || before.part != samples.list[i - reach].part)
      continue;
    double step = 0;
    for (std::size_t k = 0; k < reach; ++k) step += (residual[i + k] - residual[i - 1 - k]) / reach;
    if (std::abs(step) <= std::abs(largest.size)) continue;
    const double force = run.response_is_displacement ? before.normal_force : before.response;
    const double depth = run.response_is_displacement ? before.response : before.normal_displacement;
    if (force > 0 && depth > 0) largest = {step, force, 1.5 * force / depth};
  }
  return largest;
}

class PopIn : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "pop_in",
        "Pop-in",
        "f = f_law(d) up to f_0, f = f_law(d - jump) afterwards",
        "Gerberich et al. 1996; Lorenz et al. 2003; Bei, Gao, Shim, George & Pharr 2008",
        "At a threshold of load the indenter moves on all at once: dislocations nucleate, a film breaks or a "
        "crack opens. The jump stays.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"burst"},
        3,
        false};
    return d;
  }
  bool can_show(const Experiment& e) const override { return e.has_trace; }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double range = e.largest_displacement, force = e.largest_force;
    return {{"jump", "m", "further displacement of the burst", 1e-4 * range, range, true, {0.05 * range}},
            {"threshold_force", "N", "f_0", 0.01 * force, force, true, {0.5 * force}}};
  }
  std::vector<EffectStart> starts(const Samples& samples,
                                  const std::vector<double>& residual) const override {
    std::vector<EffectStart> list;
    for (const auto& run : samples.runs) {
      if (run.independent_rows) continue;
      const Step step = largest_step(samples, run, residual);
      const double jump = run.response_is_displacement ? step.size
                          : step.stiffness > 0         ? -step.size / step.stiffness
                                                       : 0;
      if (jump <= 0) continue;
      for (const double part : {0.97, 1.0, 1.03}) list.push_back({jump, part * step.force});
    }
    return list;
  }
  /// What breaks or glides is no part of the case; the contact beside it is the solved one.
  EntersBy enters_by(const Experiment&) const override { return EntersBy::in_series; }
  std::string why_not_by_finite_elements(const Experiment&) const override { return ""; }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact = std::make_shared<ContactWithBurst>(*m.normal.contact, p[0], p[1]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(pop_in, PopIn)
