// Concealed recordings: what they hold, and that the truth stays sealed.
#include <gtest/gtest.h>

#include <cmath>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/json_text.h"
#include "diagnosis/challenge/challenge_matrix.h"
#include "diagnosis/conceal/concealed_recording.h"
#include "tests/dem_compare/compare/solved_folders.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::TemporaryFolder;

TEST(ConcealedRecording_behaviour, every_effect_stands_out_of_its_noise_in_its_own_experiment) {
  for (const Motion mode : all_modes())
    for (const auto* list : {"catalogue", "out_of_catalogue"})
      for (const auto& effect :
           list == std::string("catalogue") ? concealable_effects(mode) : out_of_catalogue_effects(mode))
        for (const unsigned seed : {1u, 2u, 3u}) {
          const ConcealedRecording concealed = conceal({mode, {effect}, 0.01, seed, ""});
          ASSERT_EQ(concealed.truth.effects.size(), 1u);
          EXPECT_EQ(concealed.truth.effects[0].in_catalogue, list == std::string("catalogue")) << effect;
          double squares = 0;
          for (const double value : concealed.truth.contributions.at(0).in_noise) squares += value * value;
          EXPECT_GT(squares, 200) << effect << " seed "
                                  << seed;  // chi2 of 200 is fourteen standard deviations
        }
}

TEST(ConcealedRecording_behaviour, null_has_no_contribution_and_no_effects) {
  for (const Motion mode : all_modes()) {
    const ConcealedRecording concealed = conceal({mode, {}, 0.01, 4, ""});
    EXPECT_EQ(concealed.truth.family, "null");
    EXPECT_TRUE(concealed.truth.effects.empty());
    for (const double value : concealed.truth.contributions.at(0).in_noise) EXPECT_NEAR(value, 0, 1e-9);
  }
}

TEST(ConcealedRecording_behaviour, is_the_same_for_the_same_seed_and_another_for_another) {
  const ConcealOptions options{Motion::sliding, {"surface_tilt"}, 0.02, 7, ""};
  ConcealOptions other = options;
  other.seed = 8;
  const auto force = [](const ConcealOptions& o) {
    return conceal(o).recording.tables[0].column("lateral_force");
  };
  EXPECT_EQ(force(options), force(options));
  EXPECT_NE(force(options), force(other));
}

TEST(ConcealedRecording_behaviour, says_nothing_of_its_truth_but_in_the_sealed_file) {
  const TemporaryFolder folder;
  const ConcealedRecording concealed =
      conceal({Motion::normal, {"instrument_compliance", "thermal_drift"}, 0.01, 2, ""});
  write_concealed(concealed, folder.path);
  const std::string visible =
      read_file(folder.path / "recording.json") + read_file(folder.path / "loading.csv").substr(0, 200);
  for (const char* word : {"compliance", "drift", "truth", "effect"})
    EXPECT_EQ(visible.find(word), std::string::npos) << word;
  const auto truth = parse_json(read_file(folder.path / "truth.json"), "truth.json");
  EXPECT_EQ(truth["format"], "asperity-truth/1");
  EXPECT_EQ(truth["family"], "pair");
  ASSERT_EQ(truth["effects"].size(), 2u);
  EXPECT_EQ(truth["effects"][0]["id"], "instrument_compliance");
  EXPECT_GT(truth["effects"][0]["parameters"]["compliance"]["value"], 0);
  EXPECT_EQ(truth["contributions"][0]["in_noise"].size(), concealed.recording.tables[0].rows());
  const Recording read = read_recording(folder.path);
  EXPECT_EQ(read.tables[0].rows(), concealed.recording.tables[0].rows());
}

TEST(ConcealedRecording_behaviour, settings_that_cannot_tell_effects_apart_say_so) {
  EXPECT_EQ(conceal({Motion::sliding, {"surface_tilt"}, 0.01, 1, "one_load"}).truth.cannot_be_told_from,
            std::vector<std::string>{"lateral_zero_offset"});
  EXPECT_EQ(conceal({Motion::normal, {"thermal_drift"}, 0.01, 1, "ramp_only"}).truth.cannot_be_told_from,
            std::vector<std::string>{"instrument_compliance"});
  EXPECT_TRUE(conceal({Motion::sliding, {"surface_tilt"}, 0.01, 1, ""}).truth.cannot_be_told_from.empty());
}

TEST(ConcealedRecording_behaviour, refuses_what_is_unknown_or_excludes_each_other) {
  const auto message = [](const ConcealOptions& options) {
    return message_of<InputError>([&] { conceal(options); });
  };
  EXPECT_NE(message({Motion::normal, {"adhesio"}, 0.01, 1, ""}).find("did you mean 'adhesion'?"),
            std::string::npos);
  EXPECT_NE(message({Motion::normal, {"surface_tilt"}, 0.01, 1, ""})
                .find("no effect 'surface_tilt' can be concealed in mode normal"),
            std::string::npos);
  EXPECT_NE(message({Motion::normal, {"adhesion", "creep"}, 0.01, 1, ""}).find("two laws for one place"),
            std::string::npos);
  EXPECT_NE(message({Motion::normal, {}, 2, 1, ""}).find("noise"), std::string::npos);
  EXPECT_NE(message({Motion::normal, {}, 0.01, 1, "no_load"}).find("there is no setting 'no_load'"),
            std::string::npos);
}

TEST(ConcealedRecording_behaviour, of_a_case_that_slides_backwards_begins_with_its_first_step_of_sliding) {
  const TemporaryFolder folder;
  test::SolvedFolder solved;
  solved.roughness = "smooth";
  test::write_solved(folder.path, solved);
  const ConcealOptions options{Motion::sliding, {}, 0, 1, ""};
  const auto forwards = conceal_case(folder.path, options).recording.tables[0];
  History history = read_history(folder.path / "history.csv");
  for (auto* values : {&history.lateral_displacement, &history.lateral_force})
    for (double& v : *values) v = -v;
  write_file_atomically(folder.path / "history.csv", format_history(history));
  const auto backwards = conceal_case(folder.path, options).recording.tables[0];
  ASSERT_EQ(backwards.rows(), forwards.rows());
  for (std::size_t i = 0; i < forwards.rows(); ++i)
    EXPECT_EQ(backwards.column("lateral_force")[i], -forwards.column("lateral_force")[i]);
}

TEST(ConcealedRecording_analytic, a_solved_case_becomes_a_recording_of_its_accepted_steps) {
  const TemporaryFolder folder;
  test::SolvedFolder solved;
  solved.roughness = "smooth";
  test::write_solved(folder.path, solved);
  ConcealOptions options{Motion::sliding, {"partial_slip"}, 0, 1, ""};
  const ConcealedRecording sliding = conceal_case(folder.path, options);
  const auto& table = sliding.recording.tables[0];
  EXPECT_EQ(sliding.truth.effects[0].model, "finite elements");
  EXPECT_NEAR(table.column("lateral_force").back(), 0.23 * solved.load, 1e-9);
  EXPECT_EQ(table.column("lateral_force").front(), 0);
  EXPECT_GE(table.rows(), 240u);
  EXPECT_EQ(table.column("normal_force").front(), solved.load);
  options.mode = Motion::rolling;
  EXPECT_NE(message_of<InputError>([&] { conceal_case(folder.path, options); }).find("not rolling"),
            std::string::npos);
  options.mode = Motion::normal;
  solved.experiment = "normal";
  test::write_solved(folder.path, solved);
  const auto normal = conceal_case(folder.path, options).recording.tables[0];
  for (std::size_t i = 0; i < normal.rows(); ++i) {
    const double d = normal.column("normal_displacement")[i];
    EXPECT_NEAR(normal.column("normal_force")[i], solved.hertz().force(d), 1e-6 * solved.load);
  }
}

TEST(ConcealedRecording_behaviour, of_a_case_that_pulls_off_holds_no_force_that_no_contact_had) {
  const auto folder = solved_truth("adhesion_hysteresis");
  const CsvTable solved = read_csv(folder / "history.csv");
  const auto d = solved.numbers("normal_displacement [m]"), f = solved.numbers("normal_force [N]");
  std::size_t open = 1;
  while (!(f[open - 1] < 0 && f[open] == 0)) ++open;
  const auto table = conceal_case(folder, {Motion::normal, {}, 0, 1, ""}).recording.tables[0];
  int held = 0, free = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.segment[i] != "unload") continue;
    const double at = table.column("normal_displacement")[i], force = table.column("normal_force")[i];
    EXPECT_FALSE(at < d[open - 1] - 1e-15 && at > d[open] + 1e-15) << at;
    (force < 0 ? held : free) += at < 0 ? 1 : 0;
    if (at <= d[open]) {
      EXPECT_EQ(force, 0);
    }
  }
  EXPECT_GT(held, 20);
  EXPECT_GT(free, 20);
}

}  // namespace
}  // namespace asperity
