// Equal cases have one hash, others another.
#include "app/inputs_hash.h"

#include <gtest/gtest.h>

#include <set>

#include "app/case_file.h"
#include "core/sha256.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using test::smooth_case;
using test::TemporaryFolder;

class InputsHash_analytic : public testing::Test {
 protected:
  std::string hash(const std::vector<std::string>& overrides = {}) const {
    return inputs_sha256(read_settings(file, overrides), file);
  }
  const TemporaryFolder folder;
  const fs::path file = folder.write("case.prm", smooth_case());
};

}  // namespace

TEST_F(InputsHash_analytic, is_one_for_all_ways_to_write_a_case) {
  const std::string expected = hash();
  EXPECT_EQ(expected.size(), 64u);
  for (const char* same :
       {"Experiment/Normal load=1000 uN", "Experiment/Normal load=0.001", "Mesh/Layers=4",
        "Interface/Friction coefficient=0", "Title=another", "Solver/Threads=7", "Output/Fields=false"})
    EXPECT_EQ(hash({same}), expected) << same;
  const fs::path complete =
      folder.write("elsewhere/case.prm", format_settings(complete_settings(read_settings(file), file)));
  EXPECT_EQ(inputs_sha256(read_settings(complete), complete), expected);
}

TEST_F(InputsHash_analytic, is_another_for_each_entry_that_decides_the_answer) {
  std::set<std::string> all{hash()};
  const std::vector<std::string> others{"Experiment/Normal load=1.0001 mN",
                                        "Mesh/Layers=5",
                                        "Interface/Friction coefficient=0.1",
                                        "Interface/Work of adhesion=0.1 J/m^2",
                                        "Interface/Work of adhesion on separation=0.1 J/m^2",
                                        "Interface/Adhesion range=1 nm",
                                        "Interface/Adhesion law=exponential",
                                        "Solver/Tolerance=1e-7",
                                        "Solver/Backend=assembled",
                                        "Substrate/Yield stress=3 GPa",
                                        "Particle/Yield stress=3 GPa",
                                        "Experiment/Unload=false",
                                        "Substrate/Topography=generated(rms=1 nm, seed=1)",
                                        "Substrate/Topography=generated(rms=1 nm, seed=2)",
                                        "Particle/Topography=generated(rms=1 nm, seed=1)"};
  for (const auto& other : others) EXPECT_TRUE(all.insert(hash({other})).second) << other;
}

/// Checkpoints and results of the version before go on to be of the same inputs.
TEST_F(InputsHash_analytic, of_a_renamed_entry_stays_that_of_its_first_name) {
  const std::string before = sha256(
      "asperity-inputs/1\nParticle/Radius = 8.5e-06\nParticle/Young modulus = 71000000000\n"
      "Particle/Poisson ratio = 0.17\nSubstrate/Young modulus = 179000000000\nSubstrate/Poisson ratio = "
      "0.25\n"
      "Interface/Opening work = 0.1\nExperiment/Normal load = 0.001\nExperiment/Way back = 2e-07\n");
  EXPECT_EQ(hash({"Interface/Opening work=0.1 J/m^2", "Experiment/Way back=200 nm"}), before);
  EXPECT_EQ(hash({"Interface/Work of adhesion on separation=0.1 J/m^2", "Experiment/Return distance=200 nm"}),
            before);
}

TEST_F(InputsHash_analytic, goes_by_the_content_of_a_scan_and_not_by_its_folder) {
  const std::string entry =
      "subsection Substrate\n set Topography = scan(scan.txt, size=1 um, unit=nm)\nend\n";
  const auto with_scan = [&](const std::string& name, const std::string& heights) {
    folder.write(name + "/scan.txt", heights);
    const fs::path path = folder.write(name + "/case.prm", smooth_case() + entry);
    return inputs_sha256(read_settings(path), path);
  };
  EXPECT_EQ(with_scan("one", "0 1\n1 0\n"), with_scan("two", "0 1\n1 0\n"));
  EXPECT_NE(with_scan("one", "0 1\n1 0\n"), with_scan("two", "0 1\n1 2\n"));
}

}  // namespace asperity
