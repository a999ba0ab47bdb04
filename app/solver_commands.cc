#include "app/solver_commands.h"

#include <unistd.h>

#include <CLI/CLI.hpp>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "core/error.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void go_on_as_solver(char** argv) {
  const fs::path program = solver_program();
  let_threads_sleep();
  ::execv(program.c_str(), argv);
  throw WorkError("cannot start '" + program.string() + "': " + std::generic_category().message(errno));
}

}  // namespace

void let_threads_sleep() {
  constexpr int unless_set = 0;
  ::setenv("OMP_WAIT_POLICY", "passive", unless_set);
}

fs::path solver_program() {
  constexpr auto name = "asperity-solver";
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& program : {here / name, here.parent_path() / "libexec" / "asperity" / name})
    if (fs::exists(program)) return program;
  throw WorkError("the program " + std::string(name) + " is missing in '" + here.string() +
                  "'; build or install asperity anew, with all of its programs");
}

void add_solver_command(CLI::App& app, const SolverCommand& command, char** argv) {
  CLI::App* added = app.add_subcommand(command.name, command.says);
  // What follows, --help too, is that program's to read.
  added->set_help_flag();
  added->prefix_command();
  added->callback([argv] { go_on_as_solver(argv); });
}

}  // namespace asperity
