// A sphere on a soft cantilever in a liquid, as a force microscope has it. The truth is an equation of
// motion: the base moves, the fluid resists, the surface adheres, and the probe jumps off it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;

constexpr double nN = 1e-9;

struct Probe {
  double stiffness = 0.3;     ///< of the cantilever [N/m]
  double drag = 1e-3;         ///< [N s/m]
  double zero = 0, tilt = 0;  ///< of the sensor [N], [N/m]
  double pull_off = 20 * nN;  ///< [N]
  double compliance = 0;      ///< of the sample's holder [m/N]
  double ripple = 0;          ///< of the contact's force, over 10 nm, which no effect has [-]
};

/// Johnson, Kendall & Roberts: the contact closes at first touch and opens where it has no equilibrium any
/// more.
class AdhesiveContact {
 public:
  explicit AdhesiveContact(double pull_off) : work_(pull_off / (1.5 * M_PI * radius)) {}
  double force(double d) {
    const double smallest = std::cbrt(M_PI * work_ * radius * radius / (8 * modulus));  // where it opens
    if (!touches_) touches_ = d >= 0;
    if (touches_ && d < approach(smallest)) touches_ = false;
    if (!touches_) return 0;
    double low = smallest, high = 3e-6;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (approach(middle) < d ? low : high) = middle;
    }
    return 2 * modulus * (low * d - low * low * low / (3 * radius));
  }

 private:
  static constexpr double modulus = 1e6, radius = 8e-6;  // of the bodies below [Pa], [m]
  double approach(double a) const { return a * a / radius - std::sqrt(2 * M_PI * work_ * a / modulus); }
  double work_;  ///< of adhesion [J/m^2]
  bool touches_ = false;
};

/// Base there and back at 5 um/s with holds at both ends, 1 kHz; drag d' = k (base - d) - f_contact(d).
Recording probed(const Probe& probe, unsigned seed) {
  constexpr double speed = 5e-6, farthest = -1500 * nm, step = 1e-5, held = 0.1, deepest = 150 * nm;
  Recording r;
  r.mode = Motion::normal;
  r.particle = {"glass", 70e9, 0.2, 8e-6, 0, RecordedBody::unknown};
  r.substrate = {"gel", 0.75e6, 0.5, RecordedBody::unknown, 0, RecordedBody::unknown};
  RecordingTable table;
  table.file = "curve.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const double ramp = (deepest - farthest) / speed, whole = 2 * ramp + 3 * held;
  AdhesiveContact contact(probe.pull_off);
  double d = farthest;
  for (int i = 0; i * step < whole; ++i) {
    const double t = i * step,
                 moved = std::clamp(t - held, 0.0, ramp) - std::clamp(t - 2 * held - ramp, 0.0, ramp),
                 base = farthest + speed * moved;
    const double spring = probe.stiffness * (base - d);
    const double contact_force = contact.force(d) * (1 + probe.ripple * std::sin(2 * M_PI * d / (10 * nm)));
    d += (spring - contact_force) / probe.drag * step;
    if (i % 100 != 0) continue;
    table.columns["run"].push_back(1);
    table.columns["time"].push_back(t);
    table.columns["normal_displacement"].push_back(d + probe.compliance * contact_force);
    table.columns["normal_force"].push_back(spring + probe.zero + probe.tilt * d + 0.3 * nN * normal(random));
    table.segment.push_back(t < held || (t > held + ramp && t < 2 * held + ramp) || t > whole - held ? "hold"
                            : t < 2 * held + ramp                                                    ? "load"
                                                  : "unload");
  }
  r.tables = {table};
  return r;
}

std::vector<std::string> named(const Diagnosis& d) {
  std::vector<std::string> names;
  for (const auto& effect : d.left_out) names.push_back(effect.id);
  std::sort(names.begin(), names.end());
  return names;
}

const DiagnosedParameter& first_of(const Diagnosis& d, const std::string& id) {
  for (const auto& effect : d.left_out)
    if (effect.id == id) return effect.parameters.front();
  throw std::runtime_error(id + " is not named");
}

TEST(ProbeInFluid_analytic, adhesion_drag_and_zero_are_named_with_their_sizes) {
  Probe probe;
  probe.zero = -2 * nN;
  const Diagnosis d = diagnose(probed(probe, 1));
  ASSERT_EQ(named(d), (std::vector<std::string>{"adhesion", "fluid_drag", "normal_zero_offset"}))
      << diagnosis_json(d);
  EXPECT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  EXPECT_NE(diagnosis_json(d).find("samples in which the probe jumps"), std::string::npos);
  EXPECT_NEAR(first_of(d, "adhesion").value, probe.pull_off, 0.05 * probe.pull_off);
  EXPECT_NEAR(first_of(d, "fluid_drag").value, probe.drag, 0.02 * probe.drag);
  EXPECT_NEAR(first_of(d, "normal_zero_offset").value, probe.zero, 0.05 * nN);
}

TEST(ProbeInFluid_analytic, what_samples_off_contact_show_leaves_room_for_more) {
  Probe probe;
  probe.zero = 3 * nN, probe.tilt = 8e-3, probe.compliance = 0.15, probe.pull_off = 0;
  const Diagnosis d = diagnose(probed(probe, 2));
  ASSERT_EQ(named(d), (std::vector<std::string>{"baseline_tilt", "fluid_drag", "instrument_compliance",
                                                "normal_zero_offset"}))
      << diagnosis_json(d);
  EXPECT_EQ(d.verdict, Verdict::explained);
  EXPECT_NEAR(first_of(d, "baseline_tilt").value, probe.tilt, 0.05 * probe.tilt);
  EXPECT_NEAR(first_of(d, "fluid_drag").value, probe.drag, 0.02 * probe.drag);
  EXPECT_NEAR(first_of(d, "instrument_compliance").value, probe.compliance, 0.05 * probe.compliance);
}

TEST(ProbeInFluid_analytic, what_samples_off_contact_show_is_named_though_structure_remains_in_contact) {
  // Zero and drag are a small part of the mismatch, most of which the compliance makes.
  Probe probe;
  probe.zero = 0.4 * nN, probe.drag = 1e-4, probe.compliance = 0.3, probe.pull_off = 0, probe.ripple = 0.15;
  const Diagnosis d = diagnose(probed(probe, 3));
  EXPECT_EQ(d.verdict, Verdict::partly_explained);
  ASSERT_EQ(named(d), (std::vector<std::string>{"fluid_drag", "instrument_compliance", "normal_zero_offset"}))
      << diagnosis_json(d);
  EXPECT_NEAR(first_of(d, "fluid_drag").value, probe.drag, 0.1 * probe.drag);
  EXPECT_NEAR(first_of(d, "normal_zero_offset").value, probe.zero, 0.2 * nN);
}

}  // namespace
}  // namespace asperity
