// A body that relaxes: the modulus falls from E* to (1 - g) E* with the time constant tau (standard linear
// solid), E(t) = E* psi(t), psi(t) = 1 - g + g exp(-t/tau). While the contact grows (Lee & Radok 1960)
//   f = int_0^t psi(t - s) dF(d(s)),  F: force of the elastic body, by Hertz 4/3 E* R^(1/2) d^(3/2),
// and where it shrinks it is as large as it was at t_1 (Ting 1966),
//   f = int_0^(t_1) psi(t - s) dF(d(s)),  int_(t_1)^t psi(t - s) dd(s) = 0.
// Pressed again, the first integral is over all that was: 1 % of the largest force off boundary elements
// where it had not opened, 10 % where it had, for the body has not recovered. Of a solved case F is the
// solution's: each displacement has one set of points that touch, whatever the modulus, so that this holds
// for rough contacts too.
#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/yielding_contact.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {
namespace {

class RelaxingContact : public NormalContact {
 public:
  RelaxingContact(const Hertz& law, double share, double time_constant)
      : law_(law), share_(share), time_constant_(time_constant) {}
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<RelaxingContact>(*this); }
  void begin_step(double time_step) override { step_ = time_step / time_constant_; }
  double solved_force(double d) const override { return elastic(d); }
  double force(double d) const override {
    if (d <= 0) return 0;
    const Instant largest = state_as_it_grows(d);
    if (grows_at(d)) return std::max(0.0, (1 - share_) * largest.force + share_ * largest.force_left);
    return shrunk_force(d);
  }
  void accept(double d) override {
    d = std::max(0.0, d);
    const Instant now = state_as_it_grows(d);
    if (d == 0) {
      growth_.assign(1, now);
      shrinking_ = 0;
    } else if (grows_at(d)) {
      growth_.push_back(now);
      shrinking_ = 0;
    } else {
      shrinking_ = shrinking_at(d);
    }
    time_ += step_;
    last_ = now;
  }

 private:
  /// While the contact grew, times in units of tau.
  struct Instant {
    double time = 0, depth = 0, force = 0;  ///< [-], [m], of the elastic body [N]
    double depth_left = 0, force_left = 0;  ///< integrals of exp(-(t - s)) over depth and force
  };

  double elastic(double d) const {
    return d > 0 ? 4.0 / 3 * law_.reduced_modulus * std::sqrt(law_.radius * d) * d : 0;
  }
  /// Mean of the exponential over a time.
  static double mean_left(double time) { return time > 1e-9 ? -std::expm1(-time) / time : 1; }
  /// After this step, with depth and elastic force growing evenly over it.
  Instant state_as_it_grows(double d) const {
    const double left = std::exp(-step_), mean = mean_left(step_), force = elastic(d);
    return {time_ + step_, d, force, last_.depth_left * left + (d - last_.depth) * mean,
            last_.force_left * left + (force - last_.force) * mean};
  }
  /// Integral of exp(-(t - s)) over the depth since the contact was largest [m].
  double shrinking_at(double d) const {
    return shrinking_ * std::exp(-step_) + (d - last_.depth) * mean_left(step_);
  }
  /// Integral of psi(t - s) over the depth since then [m].
  double regained_at(double d) const {
    return (1 - share_) * (d - growth_.back().depth) + share_ * shrinking_at(d);
  }
  bool grows_at(double d) const { return regained_at(d) >= 0; }
  /// Of a contact that is smaller than it was, as at t_1.
  double shrunk_force(double d) const {
    const double now = time_ + step_, since_largest = regained_at(d);
    const Instant& largest = growth_.back();
    const double largest_left = largest.depth_left * std::exp(largest.time - now);
    const auto regained_since = [&](const Instant& m) {
      return since_largest + (1 - share_) * (largest.depth - m.depth) +
             share_ * (largest_left - m.depth_left * std::exp(m.time - now));
    };
    const auto force_of = [&](const Instant& m) {
      return (1 - share_) * m.force + share_ * m.force_left * std::exp(m.time - now);
    };
    const auto after = std::partition_point(growth_.begin(), growth_.end(),
                                            [&](const Instant& m) { return regained_since(m) >= 0; });
    if (after == growth_.begin() || after == growth_.end()) return 0;
    const double before = regained_since(*(after - 1)), part = before / (before - regained_since(*after));
    return (1 - part) * force_of(*(after - 1)) + part * force_of(*after);
  }

  Hertz law_;
  double share_, time_constant_;
  std::vector<Instant> growth_{1};  ///< from first touch to where it was largest
  double step_ = 0, time_ = 0;      ///< of this step, and at the last; over tau
  double shrinking_ = 0;            ///< integral of exp(-(t - s)) over the depth since then [m]
  Instant last_;                    ///< of all of the history
};

bool is_of_elastic_case(const Experiment& e) {
  return std::isinf(std::min(e.particle_yield, e.substrate_yield)) && e.case_work_of_adhesion == 0 &&
         e.case_attraction_force == 0;
}

/// Of a body whose shear modulus relaxes and whose bulk modulus stays.
struct RelaxingBody {
  double share, time;  ///< [-], [s]
};

/// The softer body, if it is the one that lets E* of the pair fall by `share` with `time` [s]: with
/// E/(1 - nu^2) = 4 G (3K + G)/(3K + 4G), the same E* in the end and the same lag behind slow loading.
RelaxingBody relaxing_body(const Experiment& e, double share, double time) {
  const ElasticBody body = softer_body(e);
  const double G = body.youngs_modulus / (2 * (1 + body.poisson_ratio)),
               K = body.youngs_modulus / (3 * (1 - 2 * body.poisson_ratio));
  const auto indented = [K](double shear) { return 4 * shear * (3 * K + shear) / (3 * K + 4 * shear); };
  const double fast = e.reduced_modulus(), slow = (1 - share) * fast,
               of_body = 1 / (1 / slow - (1 / fast - 1 / indented(G)));
  double low = 0, high = G;
  constexpr int bisections = 60;
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (indented(middle) < of_body ? low : high) = middle;
  }
  const double left = 0.5 * (low + high), small = 1e-4 * left,
               slope = (indented(left + small) - indented(left - small)) / (2 * small);
  // Slow loading: E* = slow + share time fast d/dt, of the body M = of_body + slope (G - left) tau d/dt.
  const double lag = share * time * fast * std::pow(of_body / slow, 2) / (slope * (G - left));
  return {1 - left / G, lag};
}

class Viscoelasticity : public Effect {
 public:
  const EffectDescription& description() const override {
    static const EffectDescription d{
        "viscoelasticity",
        "Viscoelastic body",
        "f = 4/3 R^(1/2) int E(t - s) d[d(s)^(3/2)], E(t) = E* [1 - g + g exp(-t/tau)]",
        "Lee & Radok 1960; Ting 1966; Johnson 1985, sec. 6.5",
        "The body gives way with time: the faster it is pressed the stiffer it is, and unloading lies below "
        "loading without an imprint that stays. Where the contact shrinks, the integral ends at the time at "
        "which it was as large.",
        EffectKind::contact,
        {Motion::normal},
        {},
        {"normal_law"},
        1,
        true,
        0.1};
    return d;
  }
  /// In a hold it is creep, which is named so. Pressed at one speed it looks like yielding, which is nearer
  /// at hand for a stiff body.
  bool can_show(const Experiment& e) const override {
    constexpr double least_ratio = 2, stiffest_polymer = 20e9;
    return e.has_time && e.has_unloading && e.hold_duration == 0 &&
           (e.fastest_run > least_ratio * e.slowest_run || e.reduced_modulus() < stiffest_polymer);
  }
  std::vector<EffectParameter> parameters(const Experiment& e) const override {
    const double time = e.duration;
    return {
        {"share", "", "g, part of the modulus that relaxes", 1e-3, 0.999, false, {0.1, 0.5}},
        {"time_constant", "s", "tau", 1e-3 * time, 100 * time, true, {0.05 * time, 0.3 * time, 2 * time}}};
  }
  EntersBy enters_by(const Experiment& e) const override {
    return is_of_elastic_case(e) ? EntersBy::on_force : EntersBy::reduced_law_only;
  }
  std::string why_not_by_finite_elements(const Experiment& e) const override {
    return is_of_elastic_case(e)
               ? ""
               : "its law holds for elastic bodies without adhesion, and the case yields or attracts";
  }
  /// With the time of loading, half of what was recorded: it is pressed and drawn back without a hold.
  std::vector<CorrectedEntry> corrected_entries(const Experiment& e,
                                                const std::vector<DiagnosedParameter>& found) const override {
    if (!is_of_elastic_case(e)) return {};
    const std::string section = particle_is_softer(e) ? "Particle/" : "Substrate/";
    const RelaxingBody at = relaxing_body(e, found[0].value, found[1].value);
    CorrectedEntry share{section + "Relaxing share", "", at.share, at.share, at.share, ""},
        time{section + "Relaxation time", "s", at.time, at.time, at.time, ""};
    for (const double of_pair : {found[0].low, found[0].high})
      for (const double constant : {found[1].low, found[1].high}) {
        const RelaxingBody corner = relaxing_body(e, of_pair, constant);
        share.low = std::min(share.low, corner.share), share.high = std::max(share.high, corner.share);
        time.low = std::min(time.low, corner.time), time.high = std::max(time.high, corner.time);
      }
    const double loading = 0.5 * e.duration;
    return {share, time, {"Experiment/Load time", "s", loading, loading, loading, ""}};
  }
  void assemble(Mechanics& m, const double* p) const override {
    m.normal.contact = std::make_shared<RelaxingContact>(m.geometry, p[0], p[1]);
  }
};

}  // namespace
}  // namespace asperity

ASPERITY_EFFECT(viscoelasticity, Viscoelasticity)
