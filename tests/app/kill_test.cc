// kill -9 in the middle of a solution, and going on from what it left.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>
#include <vector>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

namespace fs = std::filesystem;
using namespace asperity;

const char* const rough_case =
    "subsection Particle\n  set Radius = 8.5 um\n  set Young modulus = 71 GPa\n  set Poisson ratio = 0.17\n  "
    "set Yield stress = 3 GPa\n"
    "  set Topography = generated(rms=1.5 nm, hurst=0.8, rolloff=300 nm, cutoff=150 nm, seed=1)\nend\n"
    "subsection Substrate\n  set Young modulus = 179 GPa\n  set Poisson ratio = 0.25\n  set Yield stress = 4 "
    "GPa\nend\n"
    "subsection Experiment\n  set Normal load = 100 uN\n  set Load steps = 4\n  set Unload steps = 3\nend\n"
    "subsection Mesh\n  set Interface spacing = 37 nm\n  set Layers = 2\nend\n"
    "subsection Solver\n  set Threads = 1\nend\n"
    "subsection Output\n  set Fields = false\nend\n";

pid_t start(const std::vector<std::string>& arguments) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  std::vector<char*> argv;
  for (const auto& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  if (!std::freopen("/dev/null", "w", stdout)) ::_exit(127);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

int finish(pid_t child) {
  int status = -1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Of the step that the manifest names; an interrupted one may lie beside it.
fs::path part_of(const fs::path& checkpoint) {
  return checkpoint / nlohmann::json::parse(read_file(checkpoint / "latest.json"))
                          .at("parts")
                          .at(0)
                          .at("file")
                          .get<std::string>();
}

void flip_a_bit(const fs::path& file) {
  std::string bytes = read_file(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  write_file_atomically(file, bytes);
}

std::size_t rows(const fs::path& history) { return fs::exists(history) ? read_csv(history).rows.size() : 0; }

TEST(Killed_behaviour, solve_leaves_valid_files_and_resumes_to_the_same_answer) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("rough.prm", rough_case).string();
  const fs::path whole = folder.path / "whole", killed = folder.path / "killed";
  ASSERT_EQ(finish(start({ASPERITY_EXECUTABLE, "solve", file, "--output", whole.string()})), 0);

  // An earlier result in the folder must not pass for that of the run that is killed.
  fs::create_directories(killed);
  fs::copy_file(whole / "result.json", killed / "result.json");
  const pid_t child = start({ASPERITY_EXECUTABLE, "solve", file, "--output", killed.string(), "--overwrite"});
  for (int i = 0; i < 6000 && rows(killed / "history.csv") < 3; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ::kill(child, SIGKILL);
  finish(child);
  ASSERT_GE(rows(killed / "history.csv"), 3u);
  ASSERT_FALSE(fs::exists(killed / "result.json"))
      << "of the earlier run, or killed too late to show anything";

  // Not over what there is, not with another material, not from a damaged checkpoint; then on.
  EXPECT_EQ(finish(start({ASPERITY_EXECUTABLE, "solve", file, "--output", killed.string()})), 2);
  EXPECT_EQ(finish(start({ASPERITY_EXECUTABLE, "solve", (killed / "case.prm").string(), "--output",
                          killed.string(), "--resume", "--set", "Substrate/Young modulus=150 GPa"})),
            2);
  const fs::path part = part_of(killed / "checkpoint");
  flip_a_bit(part);
  EXPECT_EQ(finish(start({ASPERITY_EXECUTABLE, "solve", file, "--output", killed.string(), "--resume"})), 1);
  flip_a_bit(part);
  ASSERT_EQ(finish(start({ASPERITY_EXECUTABLE, "solve", file, "--output", killed.string(), "--resume"})), 0);
  const auto expected = read_csv(whole / "history.csv"), resumed = read_csv(killed / "history.csv");
  ASSERT_EQ(resumed.rows.size(), expected.rows.size());
  // All but what the clock, the iterations and their last residuals say.
  const std::set<std::string> of_the_run{"wall_time [s]", "newton_iterations", "linear_iterations",
                                         "penetration",   "force_error",       "moment_error",
                                         "energy_error"};
  double worst = 0;
  std::string where = "none";
  for (const auto& column : expected.names) {
    if (of_the_run.count(column)) continue;
    const auto before = expected.numbers(column), after = resumed.numbers(column);
    double largest = 0, difference = 0;
    for (std::size_t k = 0; k < before.size(); ++k) {
      ASSERT_EQ(std::isnan(after[k]), std::isnan(before[k])) << column;
      if (std::isnan(before[k])) continue;
      largest = std::max(largest, std::abs(before[k])),
      difference = std::max(difference, std::abs(after[k] - before[k]));
    }
    const double relative = largest > 0 ? difference / largest : difference;
    if (relative > worst) worst = relative, where = column;
  }
  const test::Verified verified{"Interruption",
                                "kill -9 and resumed: every number of the history, over its column's largest",
                                "the uninterrupted run"};
  EXPECT_TRUE(verified.below(worst, 1e-6)) << where;
  for (const std::string column :
       {"normal_force [N]", "normal_displacement [m]", "contact_area [m^2]", "max_pressure [Pa]", "work [J]"})
    for (std::size_t k = 0; k < expected.rows.size(); ++k)
      EXPECT_NEAR(resumed.numbers(column)[k] / expected.numbers(column)[k], 1, 1e-6)
          << column << " step " << k + 1;
  // Case, checkpoint and result say the same inputs and program.
  const auto result = nlohmann::json::parse(read_file(killed / "result.json")),
             manifest = nlohmann::json::parse(read_file(killed / "checkpoint" / "latest.json"));
  const std::string inputs = result.at("inputs_sha256"), commit = result.at("commit");
  EXPECT_EQ(inputs.size(), 64u);
  EXPECT_EQ(manifest.at("inputs_sha256"), inputs);
  EXPECT_EQ(manifest.at("commit"), commit);
  EXPECT_EQ(
      read_file(killed / "case.prm").rfind("# inputs_sha256: " + inputs + "\n# commit: " + commit + "\n", 0),
      0u);
  EXPECT_EQ(nlohmann::json::parse(read_file(whole / "result.json")).at("inputs_sha256"), inputs);
  // The case asks for one thread.
  EXPECT_NE(read_file(killed / "result.json").find("\"threads\": 1,"), std::string::npos)
      << read_file(killed / "result.json");
}

}  // namespace
