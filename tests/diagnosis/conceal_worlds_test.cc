// Concealed experiments without noise against formulas of their own truth: the path they drive, and what each
// effect does to them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/hertz.h"
#include "dem_compare/laws/rail_balance.h"
#include "diagnosis/conceal/concealed_recording.h"
#include "diagnosis/conceal/instrument_noise.h"
#include "diagnosis/conceal/sphere.h"
#include "diagnosis/conceal/world.h"

namespace asperity {
namespace {

/// A concealed recording without noise, and its truth.
struct Silent {
  ConcealedRecording concealed;
  const RecordingTable& table = concealed.recording.tables[0];
  Silent(Motion mode, const std::vector<std::string>& effects, unsigned seed = 1,
         const std::string& setting = "")
      : concealed(conceal({mode, effects, 0, seed, setting})) {}
  const std::vector<double>& of(const std::string& channel) const { return table.column(channel); }
  double parameter(const std::string& name) const {
    return concealed.truth.effects.at(0).parameters.at(name).value;
  }
  double friction() const { return concealed.truth.coefficients.begin()->second; }
};

const ElasticBody borosilicate_body{71e9, 0.17}, silicon_body{179e9, 0.25}, diamond_body{1140e9, 0.07};
const hidden::Sphere on_silicon{reduced_modulus(borosilicate_body, silicon_body), 8.5e-6},
    on_diamond{reduced_modulus(borosilicate_body, diamond_body), 8.5e-6};

TEST(SlidingWorld_analytic, goes_there_and_back_between_two_ends_in_even_steps) {
  const Silent silent(Motion::sliding, {"surface_tilt"});
  const auto &x = silent.of("lateral_displacement"), &run = silent.of("run"), &time = silent.of("time"),
             &cycle = silent.of("cycle");
  const double A = 250e-9, step = 2 * A / 60;
  EXPECT_NEAR(*std::max_element(x.begin(), x.end()), A, 1e-15);
  EXPECT_NEAR(*std::min_element(x.begin(), x.end()), -A, 1e-15);
  EXPECT_NEAR(x[0], step, 1e-15);
  EXPECT_NEAR(x[29], A, 1e-15);  // half a stroke first, then two loops of four
  ASSERT_EQ(std::count(run.begin(), run.end(), 1.0), 30 + 4 * 60);
  for (std::size_t i = 1; i < 270; ++i) {
    EXPECT_NEAR(std::abs(x[i] - x[i - 1]), step, 1e-15) << i;
    EXPECT_NEAR(time[i] - time[i - 1], step / 1e-6, 1e-9) << i;
    EXPECT_EQ(silent.table.segment[i], x[i] > x[i - 1] ? "forward" : "backward") << i;
  }
  EXPECT_EQ(cycle[100], 0);
  EXPECT_EQ(cycle[269], 1);
}

/// Force at the end of each stroke of the first run, and its load.
struct LoopEnds {
  double load = 0, forward = 0, backward = 0, half = 0;
  explicit LoopEnds(const Silent& silent) : load(silent.of("normal_force")[0]) {
    const auto &x = silent.of("lateral_displacement"), &f = silent.of("lateral_force");
    std::size_t i = 0;
    while (x[i + 1] > x[i]) ++i;
    half = f[i];
    while (x[i + 1] < x[i]) ++i;
    backward = f[i];
    while (i + 1 < x.size() && x[i + 1] > x[i] && silent.of("run")[i + 1] == silent.of("run")[i]) ++i;
    forward = f[i];
  }
};

TEST(SlidingWorld_analytic, slides_at_mu_times_the_load) {
  const Silent null(Motion::sliding, {});
  const LoopEnds ends(null);
  EXPECT_NEAR(ends.forward, null.friction() * ends.load, 1e-12);
  EXPECT_NEAR(ends.backward, -null.friction() * ends.load, 1e-12);
  EXPECT_NEAR(ends.half, null.friction() * ends.load, 1e-12);
  EXPECT_GT(null.friction(), 0.2);
  EXPECT_LT(null.friction(), 0.45);
  const double guessed = null.concealed.recording.simulation.parameters.at("sliding_friction").value;
  EXPECT_GT(guessed, 0.7 * null.friction());
  EXPECT_LT(guessed, 1.4 * null.friction());
}

TEST(SlidingWorld_analytic, limits_follow_the_formulas_of_their_effects) {
  for (const unsigned seed : {1u, 2u}) {
    const Silent adhesive(Motion::sliding, {"adhesion_offset"}, seed);
    const LoopEnds pulled(adhesive);
    EXPECT_NEAR(pulled.forward, adhesive.friction() * (pulled.load + adhesive.parameter("adhesion_force")),
                1e-12);
    const Silent shifted(Motion::sliding, {"lateral_zero_offset"}, seed);
    const LoopEnds ends(shifted);
    EXPECT_NEAR(ends.forward + ends.backward, 2 * shifted.parameter("offset"), 1e-12);
    EXPECT_NEAR(ends.forward - ends.backward, 2 * shifted.friction() * ends.load, 1e-12);
    const Silent tilted(Motion::sliding, {"surface_tilt"}, seed);
    const LoopEnds turned(tilted);
    const double angle = tilted.parameter("angle");
    EXPECT_NEAR(turned.forward + turned.backward, 2 * std::tan(angle) * turned.load, 1e-12);
    EXPECT_NEAR(turned.forward - turned.backward, 2 * tilted.friction() * turned.load / std::cos(angle),
                1e-12);
    const Silent sheared(Motion::sliding, {"area_proportional_friction"}, seed);
    const LoopEnds area(sheared);
    const double a = on_silicon.contact_radius_at_force(area.load);
    EXPECT_NEAR(area.forward, sheared.parameter("shear_strength") * hidden::pi * a * a, 1e-12);
  }
}

TEST(SlidingWorld_analytic, friction_changes_as_its_effects_say) {
  const Silent fast(Motion::sliding, {"velocity_dependence"});
  const auto &speed = fast.of("speed"), &force = fast.of("lateral_force"), &load = fast.of("normal_force"),
             &run = fast.of("run");
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (i + 1 < run.size() && run[i + 1] == run[i]) continue;  // a run's last sample slides
    // sinh^-1 of much more than one is a logarithm.
    EXPECT_NEAR(force[i] / load[i],
                fast.friction() + fast.parameter("coefficient") * std::log(speed[i] / 1e-6), 1e-9);
  }
  const Silent run_in(Motion::sliding, {"run_in"});
  const LoopEnds first(run_in);  // half a loop has passed at the end of the first stroke back
  EXPECT_NEAR(first.backward / (-run_in.friction() * first.load),
              1 + run_in.parameter("change") * std::exp(-0.5 / run_in.parameter("cycles")), 1e-9);
  const Silent peak(Motion::sliding, {"static_friction_peak"});
  const LoopEnds settled(peak);
  const auto& f = peak.of("lateral_force");
  const double most = *std::max_element(f.begin(), f.begin() + 30);
  EXPECT_NEAR(settled.backward / (-peak.friction() * settled.load), 1, 0.05);
  EXPECT_LT(most, peak.parameter("peak_ratio") * peak.friction() * settled.load);
  EXPECT_GT(most, (1 + 0.5 * (peak.parameter("peak_ratio") - 1)) * peak.friction() * settled.load);
}

TEST(SlidingWorld_analytic, a_compliance_makes_the_flanks_of_the_loop_less_steep) {
  const Silent soft(Motion::sliding, {"lateral_compliance"}, 3), stiff(Motion::sliding, {}, 3);
  const double C = soft.parameter("compliance"), load = soft.of("normal_force").back();
  const auto area = [](const Silent& silent) {  // of the first loop of the run under the largest load
    const auto &x = silent.of("lateral_displacement"), &f = silent.of("lateral_force");
    const std::size_t first = x.size() - 270;
    double sum = 0;
    for (std::size_t i = first + 30; i < first + 150; ++i) sum += 0.5 * (f[i] + f[i - 1]) * (x[i] - x[i - 1]);
    return sum;
  };
  // An elastic-plastic loop over 2 A has the area 4 mu f (A - mu f C_whole).
  const double limit = soft.friction() * load;
  EXPECT_NEAR(area(soft) - area(stiff), -4 * limit * limit * C, 0.08 * 4 * limit * limit * C);
}

TEST(NormalWorld_analytic, presses_holds_and_lets_go_along_a_straight_path) {
  const Silent silent(Motion::normal, {"contact_point_offset"});
  const auto &d = silent.of("normal_displacement"), &f = silent.of("normal_force"), &run = silent.of("run");
  ASSERT_EQ(std::count(run.begin(), run.end(), 3.0), 110 + 40 + 110);
  const double offset = silent.parameter("offset");
  for (std::size_t i = 0; i < d.size(); ++i)
    EXPECT_NEAR(f[i], on_silicon.force(d[i] - offset), 1e-5 * on_silicon.force(d.back() + 1e-7)) << i;
  const std::size_t first = 2 * 260;
  EXPECT_EQ(silent.table.segment[first], "load");
  EXPECT_EQ(silent.table.segment[first + 120], "hold");
  EXPECT_EQ(silent.table.segment[first + 259], "unload");
  for (std::size_t i = 0; i < 110; ++i) EXPECT_NEAR(d[first + i], d[first + 259 - i], 1e-15);
  EXPECT_EQ(d[first + 115], d[first + 140]);
  const double deepest = d[first + 120];
  EXPECT_NEAR(d[first], -0.6 * deepest + 1.6 * deepest * 0.5 / 110, 1e-15);
  EXPECT_NEAR(d[120],
              on_silicon.approach_of(on_silicon.contact_radius_at_force(on_silicon.force(deepest) / 4)),
              1e-13);
}

TEST(NormalWorld_analytic, instruments_change_the_curve_as_their_formulas_say) {
  for (const unsigned seed : {1u, 2u}) {  // driven by displacement
    const Silent soft(Motion::normal, {"instrument_compliance"}, seed),
        drifting(Motion::normal, {"thermal_drift"}, seed);
    const Silent tilted(Motion::normal, {"baseline_tilt"}, seed),
        larger(Motion::normal, {"effective_radius"}, seed);
    const hidden::Sphere other{on_silicon.reduced_modulus,
                               on_silicon.radius * larger.parameter("radius_ratio")};
    for (std::size_t i = 560; i < 780; i += 10) {
      const double f = soft.of("normal_force")[i], d = soft.of("normal_displacement")[i];
      EXPECT_NEAR(f, on_silicon.force(d - soft.parameter("compliance") * f), 1e-8);
      const double gone = drifting.parameter("rate") * drifting.of("time")[i];
      EXPECT_NEAR(drifting.of("normal_force")[i],
                  on_silicon.force(drifting.of("normal_displacement")[i] - gone), 1e-8);
      const double x = tilted.of("normal_displacement")[i];
      EXPECT_NEAR(tilted.of("normal_force")[i], on_silicon.force(x) + tilted.parameter("slope") * x, 1e-8);
      EXPECT_NEAR(larger.of("normal_force")[i], other.force(larger.of("normal_displacement")[i]), 1e-8);
    }
  }
}

TEST(NormalWorld_analytic, under_force_control_adds_compliance_and_drift_to_the_displacement) {
  const Silent silent(Motion::normal, {"instrument_compliance", "thermal_drift"}, 3);  // every third seed
  ASSERT_EQ(silent.table.response, "normal_displacement");
  const double C = silent.parameter("compliance"),
               rate = silent.concealed.truth.effects[1].parameters.at("rate").value;
  for (std::size_t i = 5; i < silent.table.rows(); i += 37) {
    const double f = silent.of("normal_force")[i],
                 d = on_silicon.approach_of(on_silicon.contact_radius_at_force(f));
    EXPECT_NEAR(silent.of("normal_displacement")[i], d + C * f + rate * silent.of("time")[i], 1e-13) << i;
  }
}

TEST(NormalWorld_analytic, adhesion_opens_at_its_pull_off_force) {
  const Silent silent(Motion::normal, {"adhesion"}, 2);
  const auto& f = silent.of("normal_force");
  const double pull = silent.parameter("pull_off_force"), least = *std::min_element(f.begin(), f.end());
  EXPECT_LT(-least, 1.001 * pull);
  EXPECT_GT(-least, 0.85 * pull);  // between samples it opens
}

TEST(SeriesWorld_analytic, rolling_follows_the_formulas_of_its_effects) {
  const Silent null(Motion::rolling, {}), adhesive(Motion::rolling, {"rolling_adhesion_offset"}),
      viscous(Motion::rolling, {"viscous_rolling"});
  const Silent rough(Motion::rolling, {"roughness_dependent_rolling"}),
      scaled(Motion::rolling, {"contact_radius_scaling"});
  const auto compare = [](const Silent& silent, auto coefficient_times_load) {
    for (std::size_t i = 0; i < silent.table.rows(); i += 5) {
      const double sign = silent.table.segment[i] == "forward" ? 1 : -1;
      EXPECT_NEAR(silent.of("lateral_force")[i] / (sign * coefficient_times_load(i)), 1, 1e-9) << i;
    }
  };
  compare(null, [&](std::size_t i) { return null.friction() * null.of("normal_force")[i]; });
  compare(adhesive, [&](std::size_t i) {
    return adhesive.friction() * (adhesive.of("normal_force")[i] + adhesive.parameter("adhesion_force"));
  });
  compare(viscous, [&](std::size_t i) {
    return (viscous.friction() + viscous.parameter("coefficient") * viscous.of("speed")[i]) *
           viscous.of("normal_force")[i];
  });
  compare(rough, [&](std::size_t i) {
    return (rough.parameter("b") + rough.parameter("c") * std::exp(-rough.of("rms_roughness")[i] /
                                                                   rough.parameter("decay_length"))) *
           rough.of("normal_force")[i];
  });
  compare(scaled, [&](std::size_t i) {
    const double f = scaled.of("normal_force")[i];
    const double lengths = on_silicon.contact_radius_at_force(f) + on_diamond.contact_radius_at_force(f);
    return scaled.parameter("rolling_friction") * lengths / (2 * 8.5e-6) * f;
  });
  EXPECT_EQ(*std::max_element(null.of("normal_force").begin(), null.of("normal_force").end()),
            null.of("normal_force").back());
}

TEST(SeriesWorld_other_code, rail_is_the_papers_balance) {
  const Silent torsion(Motion::rail, {"torsion_resistance"}),
      adhesive(Motion::rail, {"rolling_adhesion_offset"});
  for (std::size_t i = 0; i < torsion.table.rows(); ++i) {
    const double angle = torsion.of("rail_angle")[i], f = torsion.of("normal_force")[i];
    // At the plate: both slopes' forces.
    const double slope = f / (2 * std::cos(angle));
    EXPECT_NEAR(torsion.of("lateral_force")[i] /
                    (2 * slope *
                     rail_friction(angle, {torsion.friction(), torsion.parameter("torsion_friction"), 0, 0})),
                1, 1e-9);
    // An attraction at three contacts: mu r (f + h) at the plate and twice mu r cos(angle) (f_s + h) at the
    // slopes.
    const double h = adhesive.parameter("adhesion_force"), g = adhesive.of("normal_force")[i],
                 g_slope = g / (2 * std::cos(angle));
    const double moments = adhesive.friction() * ((g + h) + 2 * std::cos(angle) * (g_slope + h));
    EXPECT_NEAR(adhesive.of("lateral_force")[i] / (moments / (1 + std::cos(angle))), 1, 1e-9);
  }
}

TEST(SeriesWorld_analytic, torsion_over_the_contact_is_that_of_its_pressure) {
  const Silent null(Motion::torsion, {}), scaled(Motion::torsion, {"contact_radius_scaling"});
  for (std::size_t i = 0; i < null.table.rows(); ++i) {
    EXPECT_NEAR(null.of("lateral_force")[i] / (null.friction() * null.of("normal_force")[i]), 1, 1e-12);
    const double f = scaled.of("normal_force")[i], a = on_silicon.contact_radius_at_force(f);
    EXPECT_NEAR(scaled.of("lateral_force")[i] / (scaled.parameter("rolling_friction") * a / 8.5e-6 * f), 1,
                1e-4)
        << i;
  }
}

TEST(WorldDice_analytic, signs_are_even_and_sizes_even_in_their_logarithm) {
  hidden::Random random(3);
  double signs = 0, logs = 0, least = 1e9, most = 0;
  constexpr int draws = 4000;
  for (int i = 0; i < draws; ++i) {
    const double s = hidden::sign(random), x = hidden::between(random, 2, 50);
    EXPECT_EQ(std::abs(s), 1);
    signs += s, logs += std::log(x / 2) / std::log(25);
    least = std::min(least, x), most = std::max(most, x);
  }
  EXPECT_NEAR(signs / draws, 0, 0.06);
  EXPECT_NEAR(logs / draws, 0.5, 0.02);
  EXPECT_GE(least, 2);
  EXPECT_LE(most, 50);
  EXPECT_GT(most, 48);
}

TEST(WorldDice_behaviour, parameters_are_kept_with_their_effect) {
  hidden::World world;
  EXPECT_EQ(world.hide("creep", "model", "amplitude", 3), 3);
  EXPECT_EQ(world.hide("creep", "other", "time_constant", 4, false), 4);
  world.hide("interference", "", "", 0);
  ASSERT_EQ(world.effects.size(), 2u);
  EXPECT_EQ(world.effects[0].model, "model");
  EXPECT_TRUE(world.effects[0].in_catalogue);
  EXPECT_FALSE(world.effects[0].parameters.at("time_constant").is_the_catalogues);
  EXPECT_FALSE(world.effects[1].in_catalogue);
  EXPECT_TRUE(world.effects[1].parameters.empty());
  EXPECT_TRUE(world.hides("interference"));
  EXPECT_FALSE(world.hides("adhesion"));
  EXPECT_EQ(world.value("creep", "time_constant"), 4);
  EXPECT_EQ(world.value("creep", "slope"), 0);
}

TEST(InstrumentNoise_analytic, outliers_come_as_often_and_as_large_as_asked_for) {
  hidden::Random random(9);
  std::vector<double> signal(40000, 0.0);
  hidden::InstrumentNoise noise;
  noise.sd = 1;
  noise.outlier_probability = 0.01;
  noise.add_to(signal, random);
  double far = 0, sum = 0, size = 0;
  for (const double value : signal)
    if (std::abs(value) > 5) ++far, sum += value, size += std::abs(value);
  EXPECT_NEAR(far, 400, 80);
  EXPECT_NEAR(size / far, 8, 0.2);
  EXPECT_NEAR(sum / far, 0, 1.5);
  EXPECT_EQ(noise.words(), "white, outliers");
  noise.outlier_probability = 0, noise.correlated_share = 0.2;
  EXPECT_EQ(noise.words().find("white with a part correlated over"), 0u);
}

TEST(ConcealedNoise_analytic, is_the_share_of_the_largest_response_that_was_asked_for) {
  for (const unsigned seed : {2u, 3u}) {
    const ConcealedRecording noisy = conceal({Motion::sliding, {"surface_tilt"}, 0.02, seed, ""}),
                             silent = conceal({Motion::sliding, {"surface_tilt"}, 0, seed, ""});
    const auto &with = noisy.recording.tables[0].column("lateral_force"),
               &without = silent.recording.tables[0].column("lateral_force");
    double largest = 0, square = 0;
    for (std::size_t i = 0; i < with.size(); ++i)
      largest = std::max(largest, std::abs(without[i])), square += std::pow(with[i] - without[i], 2);
    EXPECT_NEAR(std::sqrt(square / double(with.size())) / (0.02 * largest), 1, 0.08);
    ASSERT_EQ(noisy.recording.noise.count("lateral_force"), seed % 3 == 0 ? 1u : 0u);
    if (seed % 3 == 0) {
      EXPECT_NEAR(noisy.recording.noise.at("lateral_force") / (0.02 * largest), 1, 1e-12);
    }
  }
  const ConcealedRecording series = conceal({Motion::rolling, {"rolling_adhesion_offset"}, 0.01, 1, ""}),
                           quiet = conceal({Motion::rolling, {"rolling_adhesion_offset"}, 0, 1, ""});
  double largest = 0;
  for (const double f : quiet.recording.tables[0].column("lateral_force"))
    largest = std::max(largest, std::abs(f));
  EXPECT_NEAR(series.recording.tables[0].column("lateral_force_sd")[0] / (0.01 * largest), 1, 1e-12);
}

/// What rolling gains from an offset alone is not what a larger coefficient would explain too.
TEST(ConcealedNoise_analytic, contribution_is_what_no_other_coefficient_explains) {
  const ConcealedRecording c = conceal({Motion::rolling, {"rolling_adhesion_offset"}, 0.01, 1, ""});
  const Silent quiet(Motion::rolling, {"rolling_adhesion_offset"});
  const double h = quiet.parameter("adhesion_force"), mu = quiet.friction(),
               sd = c.recording.tables[0].column("lateral_force_sd")[0];
  double both = 0, own = 0;
  for (const double f : quiet.of("normal_force")) both += (f + h) * f, own += f * f;
  for (std::size_t i = 0; i < quiet.table.rows(); ++i) {
    const double f = quiet.of("normal_force")[i], sign = quiet.table.segment[i] == "forward" ? 1 : -1;
    EXPECT_NEAR(c.truth.contributions[0].in_noise[i], sign * mu * (f + h - both / own * f) / sd, 1e-6) << i;
  }
}

}  // namespace
}  // namespace asperity
