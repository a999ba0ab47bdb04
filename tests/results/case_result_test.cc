#include "results/case_result.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

Json whole() {
  return Json::parse(
      R"({"format": "asperity-result/1", "title": "A case", "experiment": "rolling", "commit": "abc",
    "inputs": {"entries": {"Particle/Radius": "8.5 um", "Experiment/Cycles": 2},
        "rms_in_region": {"particle": 7e-10, "substrate": 1.5e-9}},
    "mesh": {"cells": 1000, "dofs": 3000, "interface_spacing": 5e-9, "contact_reaches_rim": true,
             "roughness": {"particle": null, "substrate": {"shortest_wave": 7.2e-8,
                 "cells_over_shortest_wave": 14.4, "repeats_every": null,
                           "slope_variance_in_shorter_waves": 0.02,
                               "missed_by_facets": {"rms_height": 0.001, "slope_variance": 0.03}}}},
    "effective": {"rolling_moment": {"value": 1e-12, "unit": "N m", "sd": 1e-13}, "spots": {"value": 3,
        "unit": "", "sd": null}},
    "balance": {"force": 1e-7, "energy": -0.003}, "cost": {"wall_time": 12.5, "peak_memory": 1e9},
        "versions": {"asperity": "0.1.0"}})");
}

TEST(CaseResult_behaviour, of_an_earlier_version_has_its_entries_under_their_present_names) {
  Json document = whole();
  document["inputs"]["entries"] = {{"Interface/Opening work", "0.2 J/m^2"}, {"Experiment/Way back", "1 nm"}};
  const CaseResult result = case_result_of(document, "made");
  ASSERT_EQ(result.physical_entries.size(), 2u);
  EXPECT_EQ(result.physical_entries.at("Interface/Work of adhesion on separation"), "0.2 J/m^2");
  EXPECT_EQ(result.physical_entries.at("Experiment/Return distance"), "1 nm");
}

TEST(CaseResult_behaviour, has_each_part_of_the_file_under_its_name) {
  const CaseResult result = case_result_of(whole(), "made");
  EXPECT_EQ(result.title, "A case");
  EXPECT_EQ(result.experiment, "rolling");
  EXPECT_EQ(result.version, "0.1.0");
  EXPECT_EQ(result.commit, "abc");
  EXPECT_EQ(result.physical_entries.at("Particle/Radius"), "8.5 um");
  EXPECT_EQ(result.physical_entries.at("Experiment/Cycles"), "2");
  EXPECT_EQ(result.rms_in_region[0], 7e-10);
  EXPECT_EQ(result.rms_in_region[1], 1.5e-9);
  EXPECT_EQ(result.cells, 1000);
  EXPECT_EQ(result.unknowns, 3000);
  EXPECT_EQ(result.interface_spacing, 5e-9);
  EXPECT_TRUE(result.reaches_rim);
  EXPECT_FALSE(result.roughness[0]);
  ASSERT_TRUE(result.roughness[1]);
  EXPECT_EQ(result.roughness[1]->shortest_wave, 7.2e-8);
  EXPECT_EQ(result.roughness[1]->cells_over_shortest_wave, 14.4);
  EXPECT_EQ(result.roughness[1]->slope_variance_in_shorter_waves, 0.02);
  EXPECT_EQ(result.roughness[1]->missed_slope_variance, 0.03);
  EXPECT_TRUE(std::isnan(result.roughness[1]->repeats_every));
  EXPECT_EQ(result.effective_number("rolling_moment").value, 1e-12);
  EXPECT_EQ(result.effective_number("rolling_moment").sd, 1e-13);
  EXPECT_EQ(result.effective_number("rolling_moment").unit, "N m");
  EXPECT_TRUE(std::isnan(result.effective_number("spots").sd));
  EXPECT_TRUE(result.has("spots"));
  EXPECT_FALSE(result.has("pull_off_force"));
  EXPECT_TRUE(std::isnan(result.effective_number("pull_off_force").value));
  EXPECT_EQ(result.balance_of("energy"), -0.003);
  EXPECT_TRUE(std::isnan(result.balance_of("moment")));
  EXPECT_EQ(result.wall_time, 12.5);
  EXPECT_EQ(result.peak_memory, 1e9);
}

TEST(CaseResult_behaviour, says_what_files_of_a_users_own_have_added) {
  EXPECT_TRUE(case_result_of(whole(), "made").added_columns.empty());
  Json document = whole();
  document["added"] = Json::parse(R"({
    "columns": [{"name": "own path [m]", "meaning": "how far"}, {"meaning": "without a name"}],
    "fields": [{"name": "own", "unit": "Pa", "meaning": "what", "place": "bodies", "components": 6}]})");
  const CaseResult result = case_result_of(document, "made");
  ASSERT_EQ(result.added_columns.size(), 1u);
  EXPECT_EQ(result.added_columns[0].name, "own path [m]");
  EXPECT_EQ(result.added_columns[0].meaning, "how far");
  ASSERT_EQ(result.added_fields.size(), 1u);
  EXPECT_EQ(result.added_fields[0].label(), "own [Pa]");
  EXPECT_EQ(result.added_fields[0].place, "bodies");
  EXPECT_EQ(result.added_fields[0].components, 6);
  document["added"] = 5;
  const std::string message = test::message_of<InputError>([&] { case_result_of(document, "made"); });
  EXPECT_NE(message.find("made: 'added' is no object"), std::string::npos) << message;
}

TEST(CaseResult_behaviour, of_an_earlier_version_lacks_what_it_did_not_tell) {
  const CaseResult result = case_result_of({{"format", CaseResult::format}}, "made");
  EXPECT_TRUE(result.complete);
  EXPECT_TRUE(result.physical_entries.empty());
  EXPECT_TRUE(std::isnan(result.interface_spacing));
  EXPECT_FALSE(result.roughness[0]);
}

TEST(CaseResult_behaviour, numbers_of_another_kind_are_none) {
  Json document = whole();
  document["mesh"]["cells"] = "many", document["mesh"]["contact_reaches_rim"] = "yes",
  document["mesh"]["roughness"] = 3;
  document["effective"]["rolling_moment"] = "large", document["inputs"]["entries"] = 5;
  const CaseResult result = case_result_of(document, "made");
  EXPECT_TRUE(std::isnan(result.cells));
  EXPECT_FALSE(result.reaches_rim);
  EXPECT_FALSE(result.roughness[1]);
  EXPECT_TRUE(std::isnan(result.effective_number("rolling_moment").value));
  EXPECT_TRUE(result.physical_entries.empty());
}

TEST(CaseResult_behaviour, that_is_missing_or_not_complete_is_none_and_a_broken_one_is_refused) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(read_case_result(folder.path / "result.json"));
  Json document = whole();
  document["complete"] = false;
  EXPECT_FALSE(read_case_result(folder.write("stopped.json", document.dump())));
  EXPECT_TRUE(read_case_result(folder.write("result.json", whole().dump())));
  const auto refusal = [&](const std::string& text) {
    const auto file = folder.write("broken.json", text);
    return test::message_of<InputError>([&] { read_case_result(file); });
  };
  EXPECT_NE(refusal(whole().dump().substr(0, 300)).find("broken.json: is not valid JSON"), std::string::npos);
  EXPECT_NE(refusal("[]").find("is not valid JSON"), std::string::npos);
  document["format"] = "asperity-result/9";
  EXPECT_NE(refusal(document.dump())
                .find("has the format 'asperity-result/9' where this program reads 'asperity-result/1'"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity
