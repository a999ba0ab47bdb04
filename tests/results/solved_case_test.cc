#include "results/solved_case.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

class SolvedCaseFolder_behaviour : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("asperity-solved-case-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    History history;
    for (const auto& column : history_columns()) history.*column.values = {1.5, 2.5};
    write_file_atomically(folder / "history.csv", format_history(history));
  }
  void TearDown() override { fs::remove_all(folder); }
  void write_prm() {
    write_file_atomically(
        folder / "case.prm",
        "set Title = A case  # its name\nsubsection Particle\n  set Radius = 8.5 um\n"
        "  set Young modulus = 71 GPa\n  set Poisson ratio = 0.17\n  set Yield stress = 3 GPa\nend\n"
        "subsection Substrate\n  set Young modulus = 179 GPa\n  set Poisson ratio = 0.25\nend\n");
  }
  fs::path folder;
};

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
                            "particle": {"youngs_modulus": 71e9, "poissons_ratio": 0.17,
                                "yield_stress": "inf",
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

TEST_F(SolvedCaseFolder_behaviour, a_result_with_a_part_of_another_kind_is_refused_by_its_name) {
  write_prm();
  const auto refusal = [&](const char* text) {
    write_file_atomically(folder / "result.json", text);
    return test::message_of<InputError>([&] { read_solved_case(folder); });
  };
  EXPECT_NE(refusal(R"({"format": true})").find("result.json: 'format' is no text"), std::string::npos);
  EXPECT_NE(refusal(R"({"format": "asperity-result/1", "title": 3})").find("'title' is no text"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"format": "asperity-result/1", "mesh": []})").find("'mesh' is no object"),
            std::string::npos);
  EXPECT_NE(
      refusal(R"({"format": "asperity-result/1", "complete": 1})").find("'complete' is no true or false"),
      std::string::npos);
  write_file_atomically(
      folder / "result.json",
      R"({"format": "asperity-result/1", "mesh": {"interface_spacing": {"value": "5 nm"}}})");
  EXPECT_TRUE(std::isnan(read_solved_case(folder).interface_spacing())) << "a text is no number";
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
