// Verdicts on recordings made by hand, from formulas and not from the mechanics that diagnoses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "core/error.h"
#include "core/shear_moduli.h"
#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/made_tables.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::borosilicate;
using test::diamond;
using test::indentation;
using test::loops;
using test::nm;
using test::silicon;
using test::uN;

double hertz(double d) {
  const Experiment e = test::experiment(Motion::normal);
  return 4.0 / 3 * e.reduced_modulus() * std::sqrt(8.5e-6) * std::pow(std::max(0.0, d), 1.5);
}

const auto no_change = [](double, double, int) { return 0.0; };

TEST(Diagnose_analytic, hertz_and_noise_is_no_mismatch) {
  const Diagnosis d = diagnose(indentation([](double x, double) { return hertz(x); }, 20 * uN, 1));
  EXPECT_EQ(d.verdict, Verdict::no_mismatch);
  EXPECT_TRUE(d.left_out.empty());
  EXPECT_TRUE(d.mismatch.empty());
  EXPECT_NEAR(d.noise.at("normal_force").value, 20 * uN, 2 * uN);
}

TEST(Diagnose_analytic, friction_loops_of_mindlin_and_coulomb_are_no_mismatch) {
  EXPECT_EQ(diagnose(loops(0, no_change, 4 * uN, 2)).verdict, Verdict::no_mismatch);
}

TEST(Diagnose_analytic, a_drift_is_named_with_its_rate) {
  const Diagnosis d =
      diagnose(indentation([](double x, double t) { return hertz(x - 0.2 * nm * t); }, 20 * uN, 3));
  ASSERT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 1u);
  EXPECT_EQ(d.left_out[0].id, "thermal_drift");
  EXPECT_EQ(d.left_out[0].kind, EffectKind::instrument);
  const DiagnosedParameter& rate = d.left_out[0].parameters[0];
  EXPECT_NEAR(rate.value, 0.2 * nm, 3 * (rate.high - rate.low) / 3.92);
  EXPECT_LT(d.improved.held_out_chi2_reduced, 1.2);
  EXPECT_GT(d.baseline.held_out_chi2_reduced, 2);
}

TEST(Diagnose_analytic, a_constant_attraction_in_contact_is_adhesion_and_nothing_more) {
  // Derjaguin, Muller & Toporov: Hertz less the pull-off force, which is 2 % of the load here.
  const double pull_off = 60 * uN;
  const Diagnosis d =
      diagnose(indentation([&](double x, double) { return x >= 0 ? hertz(x) - pull_off : 0; }, 12 * uN, 10));
  ASSERT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 1u) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "adhesion");
  EXPECT_NEAR(d.left_out[0].parameters[0].value, pull_off, 0.05 * pull_off);
}

TEST(Diagnose_analytic, a_compliance_in_series_is_named_and_located_after_the_reversals) {
  const double C = 4e-5;
  const Diagnosis d = diagnose(loops(C, no_change, 4 * uN, 4));
  ASSERT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 1u);
  EXPECT_EQ(d.left_out[0].id, "lateral_compliance");
  const DiagnosedParameter& found = d.left_out[0].parameters[0];
  EXPECT_NEAR(found.value, C, 3 * (found.high - found.low) / 3.92);
  ASSERT_FALSE(d.mismatch.empty());
  // The force of the largest load turns over 2 x 230 uN x (C + 1/k) = 28 nm after each reversal.
  for (const auto& region : d.mismatch) {
    EXPECT_EQ(region.variable, "lateral_displacement");
    if (region.segment == "forward") {
      EXPECT_LT(region.to, 40 * nm);
    }
    if (region.segment == "backward") {
      EXPECT_GT(region.from, 60 * nm);
    }
  }
}

TEST(Diagnose_analytic, a_pair_is_named_as_a_pair) {
  const auto both = [](double, double load, int) { return 8 * uN + std::tan(0.05) * load; };
  const Diagnosis d = diagnose(loops(0, both, 4 * uN, 5));
  ASSERT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 2u);
  EXPECT_EQ(d.left_out[0].id, "lateral_zero_offset");
  EXPECT_EQ(d.left_out[1].id, "surface_tilt");
  EXPECT_NEAR(d.left_out[0].parameters[0].value, 8 * uN, 1 * uN);
  EXPECT_NEAR(d.left_out[1].parameters[0].value, 0.05, 0.002);
}

TEST(Diagnose_analytic, what_no_effect_can_do_stays_unexplained_and_is_located) {
  const auto ripple = [](double x, double load, int direction) {
    return direction * 0.06 * load * std::sin(2 * 3.14159 * x / (37 * nm) + 1);
  };
  const Diagnosis d = diagnose(loops(0, ripple, 4 * uN, 6));
  EXPECT_EQ(d.verdict, Verdict::unexplained) << diagnosis_json(d);
  EXPECT_TRUE(d.left_out.empty());
  EXPECT_FALSE(d.mismatch.empty());
}

TEST(Diagnose_behaviour, what_is_nearest_to_an_unexplained_recording_is_shown_and_not_named) {
  const auto jump_and_ripple = [](double d, double) {
    return hertz(d - 3 * nm) * (1 + 0.25 * std::sin(2 * 3.14159 * d / (13 * nm)));
  };
  const Diagnosis d = diagnose(indentation(jump_and_ripple, 20 * uN, 16));
  ASSERT_EQ(d.verdict, Verdict::unexplained) << diagnosis_json(d);
  EXPECT_TRUE(d.left_out.empty());
  ASSERT_FALSE(d.nearest.empty());
  EXPECT_LT(d.with_nearest.chi2_reduced, d.baseline.chi2_reduced);
  EXPECT_EQ(d.improved.chi2_reduced, d.baseline.chi2_reduced);
  const auto json = nlohmann::json::parse(diagnosis_json(d));
  EXPECT_FALSE(json.at("nearest").at("is_named").get<bool>());
  EXPECT_EQ(json.at("nearest").at("effects").at(0), d.nearest.front().id);
  EXPECT_NE(d.compared.at(0).after, d.compared.at(0).before);
  EXPECT_EQ(d.simulated.at(0).after, d.simulated.at(0).before);  // what is written is no answer
}

TEST(Diagnose_analytic, what_the_data_cannot_separate_is_ambiguous_and_an_experiment_is_named) {
  // Rolling in one direction: an offset of the sensor and adhesion add the same force.
  Recording r;
  r.mode = Motion::rolling;
  r.particle = borosilicate();
  r.substrate = silicon();
  r.indenter = diamond();
  RecordingTable table;
  table.file = "series.csv";
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.response = "lateral_force";
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 40; ++i) {
    const double load = (100 + 70 * i) * uN;
    table.columns["normal_force"].push_back(load);
    table.columns["lateral_force"].push_back(6e-4 * (load + 400 * uN) + 0.02 * uN * normal(random));
    table.columns["lateral_force_sd"].push_back(0.02 * uN);
  }
  r.tables = {table};
  const Diagnosis d = diagnose(r);
  ASSERT_EQ(d.verdict, Verdict::ambiguous) << diagnosis_json(d);
  std::vector<std::string> ids;
  for (const auto& a : d.alternatives) ids.push_back(a.effects.front().id);
  EXPECT_NE(std::find(ids.begin(), ids.end(), "rolling_adhesion_offset"), ids.end());
  EXPECT_NE(std::find(ids.begin(), ids.end(), "lateral_zero_offset"), ids.end());
  EXPECT_NE(d.alternatives[0].told_apart_by.find("opposite direction"), std::string::npos)
      << d.alternatives[0].told_apart_by;
}

/// Rolling on substrates of these roughnesses, friction by the law of three constants.
Recording rolling_on(const std::vector<double>& roughnesses) {
  Recording r;
  r.mode = Motion::rolling;
  r.particle = borosilicate();
  r.substrate = silicon();
  r.indenter = diamond();
  RecordingTable table;
  table.file = "series.csv";
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.response = "lateral_force";
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for (const double rms : roughnesses)
    for (int i = 1; i <= 10; ++i)
      for (const int direction : {1, -1}) {
        const double load = 200 * i * uN, friction = 3e-4 + 6e-4 * std::exp(-rms / (1.2 * nm));
        table.columns["normal_force"].push_back(load);
        table.columns["rms_roughness"].push_back(rms);
        table.columns["lateral_force"].push_back(direction * friction * load + 0.01 * uN * normal(random));
        table.columns["lateral_force_sd"].push_back(0.01 * uN);
        table.segment.push_back(direction > 0 ? "forward" : "backward");
      }
  r.tables = {table};
  return r;
}

/// From `start` [nm] up to 50 nm and back, in steps of 0.4 nm.
Recording one_curve(double start, bool unloads, const std::function<double(double d, double t)>& force) {
  Recording r = indentation(force, 0, 1);
  RecordingTable& table = r.tables[0];
  for (auto& [channel, values] : table.columns) values.clear();
  table.segment.clear();
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  double t = 0;
  const auto add = [&](double d, const char* segment) {
    table.columns["run"].push_back(1);
    table.columns["time"].push_back(t += 0.1);
    table.columns["normal_displacement"].push_back(d * nm);
    table.columns["normal_force"].push_back(force(d * nm, t) + 10 * uN * normal(random));
    table.segment.push_back(segment);
  };
  for (double d = start; d < 50; d += 0.4) add(d, "load");
  for (double d = 50; unloads && d > start; d -= 0.4) add(d, "unload");
  return r;
}

TEST(Diagnose_analytic, a_tilted_baseline_is_an_answer_only_with_samples_off_contact) {
  const auto tilted = [](double d, double) { return hertz(d) + 3e3 * d; };
  const Diagnosis off_contact = diagnose(one_curve(-20, true, tilted)),
                  touching = diagnose(one_curve(0, true, tilted));
  ASSERT_EQ(off_contact.verdict, Verdict::explained) << diagnosis_json(off_contact);
  EXPECT_EQ(off_contact.left_out.at(0).id, "baseline_tilt");
  ASSERT_EQ(touching.verdict, Verdict::ambiguous) << diagnosis_json(touching);
  EXPECT_NE(diagnosis_json(touching).find("record approach and retraction out of contact too"),
            std::string::npos);
}

TEST(Diagnose_analytic, a_drift_is_an_answer_only_with_a_hold_or_the_way_back) {
  const auto drifting = [](double d, double t) { return hertz(d - 0.4 * nm * t); };
  const Diagnosis back = diagnose(one_curve(0, true, drifting)),
                  ramp = diagnose(one_curve(0, false, drifting));
  ASSERT_EQ(back.verdict, Verdict::explained) << diagnosis_json(back);
  EXPECT_EQ(back.left_out.at(0).id, "thermal_drift");
  ASSERT_EQ(ramp.verdict, Verdict::ambiguous) << diagnosis_json(ramp);
}

TEST(Diagnose_analytic, a_law_of_three_constants_is_not_named_from_three_roughnesses_but_from_four) {
  const auto names = [](const Diagnosis& d) {
    std::vector<std::string> ids;
    for (const auto& effect : d.left_out) ids.push_back(effect.id);
    for (const auto& alternative : d.alternatives)
      for (const auto& effect : alternative.effects) ids.push_back(effect.id);
    return ids;
  };
  const auto three = diagnose(rolling_on({0.3 * nm, 1.5 * nm, 2.7 * nm}));
  const auto named = names(three);
  EXPECT_EQ(std::count(named.begin(), named.end(), "roughness_dependent_rolling"), 0);
  EXPECT_NE(three.verdict, Verdict::no_mismatch);
  ASSERT_FALSE(three.remarks.empty());
  EXPECT_EQ(three.remarks.back(),
            "roughness_dependent_rolling was not tried: 3 different values of rms_roughness cannot test its "
            "law, 4 or more would");
  const auto four = diagnose(rolling_on({0.3 * nm, 0.9 * nm, 1.5 * nm, 2.7 * nm}));
  EXPECT_EQ(four.verdict, Verdict::explained) << diagnosis_json(four);
  EXPECT_EQ(names(four), std::vector<std::string>{"roughness_dependent_rolling"});
}

TEST(Diagnose_behaviour, outliers_are_left_out_and_said) {
  Recording r = indentation([](double x, double) { return hertz(x); }, 20 * uN, 8);
  for (const int i : {100, 333, 555, 777})
    r.tables[0].columns["normal_force"][static_cast<std::size_t>(i)] += 800 * uN;
  const Diagnosis d = diagnose(r);
  EXPECT_EQ(d.verdict, Verdict::no_mismatch);
  ASSERT_FALSE(d.remarks.empty());
  EXPECT_NE(d.remarks[0].find("4 samples lie far off"), std::string::npos) << d.remarks[0];
}

TEST(Diagnose_behaviour, points_of_a_fitted_curve_are_said_to_be_none_of_a_measurement) {
  Recording r;
  r.mode = Motion::sliding;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "line.csv";
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.response = "lateral_force";
  for (const double load : {3.0, 10.0, 20.0, 40.0, 65.0, 100.0}) {
    table.columns["normal_force"].push_back(load * uN);
    table.columns["lateral_force"].push_back(0.23 * (load + 12) * uN);
    table.columns["lateral_force_sd"].push_back(0.65 * uN);
  }
  r.tables = {table};
  const Diagnosis d = diagnose(r);
  ASSERT_EQ(d.left_out.size(), 1u) << diagnosis_json(d);
  EXPECT_EQ(d.left_out[0].id, "adhesion_offset");
  EXPECT_TRUE(d.rows_are_points_of_a_curve);
  EXPECT_EQ(d.in_words.find("noise"), std::string::npos) << d.in_words;
  EXPECT_EQ(nlohmann::json::parse(diagnosis_json(d))["rows_are"], "points of a fitted curve");
}

TEST(Diagnose_behaviour, a_deviation_that_is_given_too_large_is_said) {
  Recording r = indentation([](double x, double) { return hertz(x); }, 20 * uN, 8);
  const auto says = [&](const Diagnosis& d) {
    for (const auto& remark : d.remarks)
      if (remark.find("too large by a factor of about") != std::string::npos) return remark;
    return std::string();
  };
  r.noise["normal_force"] = 20 * uN;
  EXPECT_EQ(says(diagnose(r)), "");
  r.noise["normal_force"] = 60 * uN;
  const Diagnosis d = diagnose(r);
  EXPECT_FALSE(d.rows_are_points_of_a_curve);
  EXPECT_NE(says(d).find("factor of about 3,"), std::string::npos) << diagnosis_json(d);
}

TEST(Diagnose_behaviour, json_has_the_formats_entries) {
  const Diagnosis d =
      diagnose(indentation([](double x, double t) { return hertz(x - 0.2 * nm * t); }, 20 * uN, 3));
  const auto json = nlohmann::json::parse(diagnosis_json(d));
  EXPECT_EQ(json["format"], "asperity-diagnosis/1");
  EXPECT_EQ(json["verdict"], "explained");
  EXPECT_EQ(json["noise"]["normal_force"]["unit"], "N");
  EXPECT_GT(json["baseline"]["chi2_reduced"], json["improved"]["chi2_reduced"]);
  EXPECT_TRUE(json["baseline"].contains("held_out_chi2_reduced"));
  EXPECT_EQ(json["left_out"][0]["effect"], "thermal_drift");
  EXPECT_EQ(json["left_out"][0]["kind"], "instrument");
  EXPECT_EQ(json["left_out"][0]["parameters"]["rate"]["unit"], "m/s");
  EXPECT_EQ(json["left_out"][0]["parameters"]["rate"]["ci95"].size(), 2u);
  for (const auto& key :
       {"table", "channel", "segment", "variable", "from", "to", "unit", "p_value", "share"})
    EXPECT_TRUE(json["mismatch"][0].contains(key)) << key;
  EXPECT_TRUE(json["alternatives"].is_array() && json["remaining"].is_array());
}

TEST(Diagnose_behaviour, refuses_a_recording_in_which_nothing_presses) {
  Recording r = indentation([](double x, double) { return -hertz(x); }, 0, 1);
  EXPECT_NE(test::message_of<InputError>([&] { diagnose(r); }).find("compression is positive"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity
