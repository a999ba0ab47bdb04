#include "dem_compare/solved_case.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/atomic_file.h"
#include "core/error.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

class SolvedCaseFolder_behaviour : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("asperity-solved-case-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    ContactHistory history;
    for (const auto& column : history_columns()) history.*column.values = {1.5, 2.5};
    write_file_atomically(folder / "history.csv", format_history(history));
  }
  void TearDown() override { fs::remove_all(folder); }
  void write_prm() {
    write_file_atomically(folder / "case.prm",
                          "set Title = A case  # its name\nsubsection Particle\n  set Radius = 8.5 um\n"
                          "  set Young modulus = 71 GPa\n  set Poisson ratio = 0.17\n  set Yield stress = 3 GPa\nend\n"
                          "subsection Substrate\n  set Young modulus = 179 GPa\n  set Poisson ratio = 0.25\nend\n");
  }
  fs::path folder;
};

TEST_F(SolvedCaseFolder_behaviour, a_history_is_read_as_it_was_written) {
  const ContactHistory history = read_history(folder / "history.csv");
  for (const auto& column : history_columns()) EXPECT_EQ(history.*column.values, (std::vector<double>{1.5, 2.5}));
}

TEST_F(SolvedCaseFolder_behaviour, a_history_without_a_column_is_refused_by_file_and_column) {
  write_file_atomically(folder / "history.csv", "step,time [s]\n1,2\n");
  try {
    read_history(folder / "history.csv");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("history.csv"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("normal_displacement [m]"), std::string::npos);
  }
}

TEST_F(SolvedCaseFolder_behaviour, an_unfinished_case_is_known_from_its_case_file) {
  write_prm();
  const SolvedCase solved = read_solved_case(folder);
  EXPECT_FALSE(solved.finished());
  EXPECT_EQ(solved.title(), "A case");
  EXPECT_NEAR(solved.hertz().reduced_modulus, 52.86838771e9, 1e2);
  EXPECT_EQ(solved.hertz().radius, 8.5e-6);
  EXPECT_TRUE(solved.can_yield());
  EXPECT_FALSE(solved.is_rough());
  EXPECT_TRUE(std::isfinite(solved.first_yield_force()));
}

TEST_F(SolvedCaseFolder_behaviour, without_its_case_file_a_result_knows_its_inputs) {
  write_file_atomically(folder / "result.json",
                        R"json({"format": "asperity-result/1", "title": "From the result", "inputs": {
                            "particle": {"youngs_modulus": 71e9, "poissons_ratio": 0.17, "yield_stress": "inf",
                                         "topography": "generated(rms=1.5 nm)"},
                            "radius": 9e-6, "substrate": {"youngs_modulus": 179e9, "poissons_ratio": 0.25}},
                            "mesh": {"interface_spacing": 5e-9}})json");
  const SolvedCase solved = read_solved_case(folder);
  EXPECT_TRUE(solved.finished());
  EXPECT_EQ(solved.title(), "From the result");
  EXPECT_EQ(solved.hertz().radius, 9e-6);
  EXPECT_NEAR(solved.hertz().reduced_modulus, 52.86838771e9, 1e2);
  EXPECT_EQ(solved.interface_spacing(), 5e-9);
  EXPECT_TRUE(solved.is_rough());
  EXPECT_FALSE(solved.can_yield());
}

TEST_F(SolvedCaseFolder_behaviour, a_folder_without_inputs_or_with_a_broken_result_is_refused) {
  EXPECT_THROW(read_solved_case(folder), InputError);
  write_prm();
  write_file_atomically(folder / "result.json", "{\"format\": ");
  EXPECT_THROW(read_solved_case(folder), InputError);
  EXPECT_THROW(read_solved_case(folder / "nothing"), InputError);
}

}  // namespace
}  // namespace asperity
