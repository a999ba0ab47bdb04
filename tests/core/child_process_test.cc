// Programs started beside this one.
#include "core/child_process.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::TemporaryFolder;

constexpr auto patience = std::chrono::seconds(20);

int status_of(ChildProcess& process) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < end) {
    if (const auto status = process.exit_status()) return *status;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ADD_FAILURE() << "it did not end";
  return -1;
}

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::vector<std::string> shell(const std::string& commands) { return {"/bin/sh", "-c", commands}; }

TEST(ChildProcess_behaviour, runs_in_its_folder_and_appends_output_and_errors_to_the_log) {
  const TemporaryFolder folder;
  const auto log = folder.write("log", "before\n");
  std::filesystem::create_directory(folder.path / "inside");
  ChildProcess process(shell("basename \"$PWD\"; echo wrong >&2; exit 3"), log, {}, folder.path / "inside");
  EXPECT_EQ(status_of(process), 3);
  EXPECT_EQ(content(log), "before\ninside\nwrong\n");
}

TEST(ChildProcess_behaviour, gets_the_replaced_environment_without_what_an_mpi_launcher_left) {
  const TemporaryFolder folder;
  ::setenv("OMPI_COMM_WORLD_RANK", "1", 1);
  ::setenv("ASPERITY_TEST_ENTRY", "old", 1);
  ChildProcess process(shell("echo \"$ASPERITY_TEST_ENTRY,$OMPI_COMM_WORLD_RANK,\""), folder.path / "log",
                       {"ASPERITY_TEST_ENTRY=new"});
  EXPECT_EQ(status_of(process), 0);
  EXPECT_EQ(content(folder.path / "log"), "new,,\n");
  ::unsetenv("OMPI_COMM_WORLD_RANK");
  ::unsetenv("ASPERITY_TEST_ENTRY");
}

TEST(ChildProcess_behaviour, tells_a_signal_and_a_program_that_cannot_be_started) {
  const TemporaryFolder folder;
  ChildProcess killed(shell("kill -SEGV $$"), folder.path / "log");
  EXPECT_EQ(status_of(killed), 128 + SIGSEGV);
  ChildProcess missing({"/no/such/program"}, folder.path / "missing");
  EXPECT_EQ(status_of(missing), 127);
  EXPECT_EQ(content(folder.path / "missing"), "cannot start the program\n");
  EXPECT_THROW(ChildProcess(shell("true"), folder.path / "no" / "log"), WorkError);
}

TEST(ChildProcess_behaviour, is_asked_to_stop_together_with_what_it_started) {
  const TemporaryFolder folder;
  ChildProcess process(shell("sleep 60 & wait"), folder.path / "log");
  process.ask_to_stop();
  EXPECT_EQ(status_of(process), 128 + SIGTERM);
}

TEST(ChildProcess_behaviour, does_not_outlive_its_owner) {
  const TemporaryFolder folder;
  const auto began = std::chrono::steady_clock::now();
  { const ChildProcess process(shell("sleep 60"), folder.path / "log"); }
  EXPECT_LT(std::chrono::steady_clock::now() - began, patience);
}

}  // namespace
}  // namespace asperity
