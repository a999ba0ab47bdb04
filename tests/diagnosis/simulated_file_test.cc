// before.csv and after.csv: the recording's rows with what the simulation gives.
#include "diagnosis/simulated_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/csv.h"
#include "core/hertz.h"
#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::nm;
constexpr double compliance = 1e-5, noise = 3e-6;

/// Hertz' contact behind a spring, 120 samples, some of them empty.
RecordingTable behind_spring(const std::string& file, const Hertz& hertz, unsigned seed) {
  RecordingTable table;
  table.file = file;
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 120; ++i) {
    const double d = 0.3 * nm * i, force = hertz.force(d);
    table.columns["time"].push_back(0.1 * i);
    table.columns["normal_displacement"].push_back(d + compliance * force);
    table.columns["normal_force"].push_back(i == 7 ? std::nan("") : force + noise * normal(random));
  }
  return table;
}

Recording recorded() {
  Recording r;
  r.mode = Motion::normal;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  const Hertz hertz{reduced_modulus({r.particle.youngs_modulus, r.particle.poissons_ratio},
                                    {r.substrate.youngs_modulus, r.substrate.poissons_ratio}),
                    r.particle.radius};
  r.tables = {behind_spring("first, quoted.csv", hertz, 1), behind_spring("second.csv", hertz, 2)};
  r.tables[1].segment.assign(120, "load");
  return r;
}

TEST(SimulatedFile_behaviour, holds_every_row_of_every_table_with_both_simulations) {
  const Recording recording = recorded();
  const Diagnosis d = diagnose(recording);
  ASSERT_FALSE(d.left_out.empty()) << d.in_words;
  EXPECT_EQ(d.left_out[0].id, "instrument_compliance");
  const test::TemporaryFolder folder;
  const auto read = [&](SimulatedState state) {
    return read_csv(folder.write("simulated.csv", simulated_csv(recording, d, state)));
  };
  const CsvTable before = read(SimulatedState::before), after = read(SimulatedState::after);
  const auto recorded_force = after.numbers("normal_force [N]"),
             force_before = before.numbers("simulated_normal_force [N]"),
             force_after = after.numbers("simulated_normal_force [N]");
  ASSERT_EQ(recorded_force.size(), 240u);
  ASSERT_EQ(force_after.size(), 240u);
  // The row whose response is missing is simulated all the same.
  EXPECT_TRUE(std::isnan(recorded_force[7]));
  EXPECT_GT(force_after[7], 0);
  double rms_before = 0, rms_after = 0;
  int count = 0;
  for (std::size_t i = 0; i < recorded_force.size(); ++i) {
    if (std::isnan(recorded_force[i])) continue;
    rms_before += std::pow(recorded_force[i] - force_before[i], 2);
    rms_after += std::pow(recorded_force[i] - force_after[i], 2);
    ++count;
  }
  EXPECT_NEAR(std::sqrt(rms_before / count) / d.baseline.rms.at("normal_force"), 1, 1e-6);
  EXPECT_NEAR(std::sqrt(rms_after / count) / d.improved.rms.at("normal_force"), 1, 1e-6);
  EXPECT_LT(rms_after, 0.2 * rms_before);
}

TEST(SimulatedFile_behaviour, quotes_names_and_leaves_cells_empty_that_a_table_lacks) {
  Recording recording = recorded();
  Diagnosis d;
  for (std::size_t t = 0; t < 2; ++t)
    d.simulated.push_back({std::vector<double>(120, 1e-6), std::vector<double>(120, 2e-6)});
  d.simulated[0].after[3] = std::nan("");
  const std::string text = simulated_csv(recording, d, SimulatedState::after);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "table,time [s],normal_displacement [m],normal_force [N],segment,simulated_normal_force [N]");
  EXPECT_NE(text.find("\n\"first, quoted.csv\",0,0,"), std::string::npos);
  EXPECT_NE(text.find(",,2e-06\n"), std::string::npos);
  EXPECT_NE(text.find(",load,2e-06\n"), std::string::npos);
  EXPECT_NE(text.find(",,\n\"first, quoted.csv\",0.4,"), std::string::npos);
}

}  // namespace
}  // namespace asperity
