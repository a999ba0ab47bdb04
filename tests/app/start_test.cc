// How quickly the program starts, and the commands that stand in a program of their own.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include "app/solver_commands.h"
#include "tests/app/called_program.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct Cost {
  double seconds;    ///< of CPU
  double megabytes;  ///< at most, resident
};

Cost cost_of_version() {
  const pid_t child = ::fork();
  if (child == 0) {
    if (!std::freopen("/dev/null", "w", stdout)) ::_exit(127);
    ::execl(ASPERITY_EXECUTABLE, "asperity", "--version", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = -1;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  const auto seconds = [](const timeval& t) { return t.tv_sec + 1e-6 * t.tv_usec; };
  return {seconds(used.ru_utime) + seconds(used.ru_stime), used.ru_maxrss / 1000.0};
}

TEST(Start_behaviour, version_takes_less_than_60_megabytes_and_a_twentieth_of_a_second) {
  Cost least = cost_of_version();
  for (int i = 0; i < 60; ++i) {  // the least: other tests run beside this one
    const Cost cost = cost_of_version();
    least = {std::min(least.seconds, cost.seconds), std::max(least.megabytes, cost.megabytes)};
  }
  EXPECT_LT(least.megabytes, 60);
  EXPECT_LT(least.seconds, 0.05);
}

TEST(Start_behaviour, commands_of_the_solver_are_listed_and_say_their_own_help) {
  const std::string help = test::call("--help").output;
  for (const auto& command : {solver_commands::preview, solver_commands::mesh, solver_commands::solve,
                              solver_commands::study, solver_commands::report}) {
    EXPECT_NE(help.find(command.says), std::string::npos) << help;
    const test::Outcome own = test::call(std::string(command.name) + " --help");
    EXPECT_EQ(own.status, 0);
    EXPECT_NE(own.output.find(command.says), std::string::npos) << own.output;
    EXPECT_NE(own.output.find("asperity " + std::string(command.name)), std::string::npos) << own.output;
  }
  EXPECT_EQ(test::call("solve").status, 2);
}

TEST(Start_behaviour, a_program_that_is_missing_is_said) {
  const test::TemporaryFolder folder;
  const fs::path alone = folder.path / "asperity";
  fs::copy_file(ASPERITY_EXECUTABLE, alone);
  const test::Outcome outcome = test::call_program(alone.string(), "solve case.prm --output result");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.output, "asperity: the program asperity-solver is missing in '" + folder.path.string() +
                                "'; build or install asperity anew, with all of its programs\n");
}

}  // namespace
}  // namespace asperity
