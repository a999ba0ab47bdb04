// asperity derive as a person calls it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/atomic_file.h"
#include "core/shear_moduli.h"
#include "engines/parameters/contact_parameters.h"
#include "results/history.h"
#include "tests/app/called_program.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::call;
using test::Outcome;
using test::TemporaryFolder;

constexpr double local_friction = 0.3;

/// A smooth elastic sliding contact: linear up to mu f, there and back.
void write_sliding_case(const fs::path& folder, double radius, double load) {
  const ElasticBody glass{71e9, 0.17};
  const Hertz hertz{reduced_modulus(glass, glass), radius};
  const double stiffness = 8 * reduced_shear_modulus(glass, glass) * hertz.contact_radius(load),
               limit = local_friction * load;
  History history;
  const auto add = [&](double force, double position, double resistance) {
    for (const auto& column : history_columns())
      if (column.always) (history.*column.values).push_back(0);
    history.normal_force.back() = force;
    history.normal_displacement.back() = hertz.approach(force);
    history.contact_radius.back() = hertz.contact_radius(force);
    history.lateral_displacement.back() = position;
    history.lateral_force.back() = resistance;
  };
  constexpr int load_steps = 6, steps = 40;
  for (int i = 1; i <= load_steps; ++i) add(load * i / load_steps, 0, 0);
  const double step = limit / stiffness / 3;
  for (int i = 1; i <= steps; ++i) add(load, i * step, std::min(limit, stiffness * i * step));
  for (int i = 1; i <= steps; ++i)
    add(load, (steps - i) * step, std::max(-limit, limit - stiffness * i * step));
  fs::create_directories(folder);
  write_file_atomically(folder / "history.csv", format_history(history));
  const nlohmann::json glass_json{
      {"youngs_modulus", 71e9}, {"poissons_ratio", 0.17}, {"topography", "smooth"}};
  write_file_atomically(folder / "result.json", nlohmann::json{{"format", "asperity-result/1"},
                                                               {"experiment", "sliding"},
                                                               {"inputs",
                                                                {{"particle", glass_json},
                                                                 {"substrate", glass_json},
                                                                 {"radius", radius},
                                                                 {"friction_coefficient", local_friction}}},
                                                               {"mesh", {{"interface_spacing", 2e-8}}},
                                                               {"versions", {{"asperity", "0.1.0"}}}}
                                                    .dump());
}

/// A smooth elastic contact, pressed and drawn off, whose stated stiffness and pull-off force are given.
void write_normal_case(const fs::path& folder, double load, double stiffness, double pull_off) {
  const ElasticBody glass{71e9, 0.17};
  const Hertz hertz{reduced_modulus(glass, glass), 8.5e-6};
  History history;
  for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0, 0.5, 0.0}) {
    for (const auto& column : history_columns())
      if (column.always) (history.*column.values).push_back(0);
    history.normal_force.back() = share > 0 ? share * load : -pull_off;
    history.normal_displacement.back() = hertz.approach(share * load);
    history.contact_radius.back() = hertz.contact_radius(share * load);
  }
  fs::create_directories(folder);
  write_file_atomically(folder / "history.csv", format_history(history));
  const nlohmann::json glass_json{
      {"youngs_modulus", 71e9}, {"poissons_ratio", 0.17}, {"topography", "smooth"}};
  const nlohmann::json effective{{"normal_stiffness", {{"value", stiffness}, {"unit", "N/m"}, {"sd", 0}}},
                                 {"pull_off_force", {{"value", pull_off}, {"unit", "N"}, {"sd", 0}}}};
  write_file_atomically(
      folder / "result.json",
      nlohmann::json{{"format", "asperity-result/1"},
                     {"experiment", "normal"},
                     {"inputs", {{"particle", glass_json}, {"substrate", glass_json}, {"radius", 8.5e-6}}},
                     {"effective", effective},
                     {"mesh", {{"interface_spacing", 2e-8}}},
                     {"versions", {{"asperity", "0.1.0"}}}}
          .dump());
}

TEST(DeriveCommand_analytic, takes_surfaces_along_that_half_spaces_alone_have_solved) {
  const TemporaryFolder folder;
  constexpr double load = 1e-4, stiffness = 2e4, pull_off = 1e-6, both = 1.1;
  nlohmann::json cases = nlohmann::json::array();
  for (int r = 1; r <= 5; ++r) {
    const std::string name = "100_uN-r" + std::to_string(r);
    const double of_surface = r <= 2 ? 1 : 2;  // in the mean of five 1.6
    cases.push_back({{"name", name},
                     {"values", nlohmann::json::object()},
                     {"realisation", r},
                     {"inputs_sha256", ""},
                     {"half_spaces",
                      {{"normal_stiffness", {{"value", of_surface * stiffness}, {"unit", "N/m"}}},
                       {"pull_off_force", {{"value", of_surface * pull_off}, {"unit", "N"}}}}}});
    if (r <= 2) write_normal_case(folder.path / "study" / name, load, both * stiffness, both * pull_off);
  }
  folder.write("study/previews.json",
               nlohmann::json{{"format", "asperity-previews/1"}, {"cases", cases}}.dump());
  const fs::path file = folder.path / "parameters.json";
  const Outcome outcome = call("derive " + (folder.path / "study").string() + " --output " + file.string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const ContactParameters parameters = read_contact_parameters(file);
  ASSERT_TRUE(parameters.normal_stiffness && parameters.pull_off_force);
  EXPECT_NEAR(parameters.pull_off_force->value / (both * 1.6 * pull_off), 1, 1e-6);
  // One of the two solved smooth contacts, which are the same, and three surfaces twice as stiff, in the
  // logarithm.
  EXPECT_NEAR(parameters.normal_stiffness->value / (both * stiffness * std::pow(2, 0.75)), 1, 1e-6);
  EXPECT_NE(parameters.normal_stiffness->provenance.find("3 surfaces more by half-spaces"), std::string::npos)
      << parameters.normal_stiffness->provenance;
}

TEST(DeriveCommand_analytic, writes_parameters_with_uncertainty_loads_and_provenance) {
  const TemporaryFolder folder;
  for (const double load : {1e-4, 3e-4, 1e-3})
    write_sliding_case(folder.path / "cases" / std::to_string(load), 8.5e-6, load);
  const fs::path file = folder.path / "parameters.json";
  const Outcome outcome = call("derive " + (folder.path / "cases").string() + " --output " + file.string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("Sliding"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("not identifiable"), std::string::npos) << outcome.output;
  const ContactParameters parameters = read_contact_parameters(file);
  ASSERT_TRUE(parameters.sliding_friction);
  EXPECT_NEAR(parameters.sliding_friction->value, local_friction, 1e-6);
  EXPECT_TRUE(std::isfinite(parameters.sliding_friction->sd));
  EXPECT_TRUE(parameters.sliding_friction->load_range);
  EXPECT_NE(parameters.sliding_friction->provenance.find("3 cases"), std::string::npos)
      << parameters.sliding_friction->provenance;
  EXPECT_EQ(parameters.derivation["cases"].size(), 3u);
}

TEST(DeriveCommand_behaviour, says_which_cases_an_engine_still_needs) {
  const TemporaryFolder folder;
  write_sliding_case(folder.path / "sliding", 8.5e-6, 1e-4);
  const Outcome outcome =
      call("derive " + (folder.path / "sliding").string() + " --output " + (folder.path / "p.json").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto at = outcome.output.find("What an engine still needs\n");
  ASSERT_NE(at, std::string::npos) << outcome.output;
  const std::string needed = outcome.output.substr(at);
  EXPECT_EQ(needed.find("sliding_friction"), std::string::npos) << needed;
  for (const std::string motion : {"rolling", "torsion"})
    EXPECT_NE(needed.find(motion + "_friction and " + motion + "_stiffness (a case with Experiment/Type = " +
                          motion + "): without it engines get no " + motion + " resistance"),
              std::string::npos)
        << needed;
}

TEST(DeriveCommand_behaviour, writes_one_file_for_each_radius_and_says_so) {
  const TemporaryFolder folder;
  write_sliding_case(folder.path / "small", 5e-6, 1e-4);
  write_sliding_case(folder.path / "large", 8.5e-6, 1e-4);
  const Outcome outcome =
      call("derive " + (folder.path / "small").string() + " " + (folder.path / "large").string() +
           " --output " + (folder.path / "p.json").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // In the order of the folders' names, in whatever order they are given.
  EXPECT_NE(outcome.output.find("they differ in Particle/Radius: 8.5 um, 5 um"), std::string::npos)
      << outcome.output;
  EXPECT_EQ(read_contact_parameters(folder.path / "p_1.json").particle.radius, 8.5e-6);
  EXPECT_EQ(read_contact_parameters(folder.path / "p_2.json").particle.radius, 5e-6);
  EXPECT_FALSE(fs::exists(folder.path / "p.json"));
}

TEST(DeriveCommand_behaviour, refuses_folders_without_cases_and_broken_results_in_one_sentence) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path / "empty");
  const Outcome empty =
      call("derive " + (folder.path / "empty").string() + " --output " + (folder.path / "p.json").string());
  EXPECT_EQ(empty.status, 2);
  EXPECT_NE(empty.output.find("neither a solved case"), std::string::npos) << empty.output;
  write_sliding_case(folder.path / "broken", 5e-6, 1e-4);
  write_file_atomically(folder.path / "broken" / "result.json", "{");
  const Outcome broken =
      call("derive " + (folder.path / "broken").string() + " --output " + (folder.path / "p.json").string());
  EXPECT_EQ(broken.status, 2);
  EXPECT_NE(broken.output.find("result.json"), std::string::npos) << broken.output;
  EXPECT_EQ(call("derive " + (folder.path / "nowhere").string()).status, 2);
  EXPECT_FALSE(fs::exists(folder.path / "p.json"));
}

}  // namespace
}  // namespace asperity
