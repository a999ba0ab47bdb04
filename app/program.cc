#include "app/program.h"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <streambuf>
#include <string>
#include <vector>

#include "core/build_commit.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "core/printable.h"
#include "core/thread_limit.h"

namespace asperity {
namespace {

constexpr int failed = 1, refused = 2;

int say(const std::exception& error, int status) {
  std::fprintf(stderr, "asperity: %s\n", printable_lines(error.what()).c_str());
  return status;
}

/// A subcommand that does not exist; CLI11's own message does not say what was meant.
void check_subcommand_exists(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  for (const auto& name : names)
    if (name == argv[1]) return;
  throw InputError("there is no subcommand '" + std::string(argv[1]) + "'; " +
                   did_you_mean(argv[1], names, "asperity --help lists them"));
}

/// A program started without one of its standard streams would open its results in their place, and print
/// into them.
void open_missing_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) != stream) std::exit(failed);
}

/// What was printed must have arrived: a full disk shows when the stream is flushed, or even closed.
int with_printed_output(int status) {
  std::cout.flush();
  const bool printed = std::cout.good() && std::fflush(stdout) == 0 && !std::ferror(stdout);
  if (std::fclose(stdout) == 0 && printed) return status;
  std::fprintf(stderr,
               "asperity: cannot write to standard output, and what it should have said is cut off; is its "
               "disk full?\n");
  return status == 0 ? failed : status;
}

/// A stream's buffer that takes all and keeps nothing.
class Nothing : public std::streambuf {
  int overflow(int character) override { return traits_type::not_eof(character); }
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

/// --quiet for each command that writes files: with --output nothing is printed but errors, and what --json
/// asks for.
void add_quiet(CLI::App& app) {
  static Nothing nothing;
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    add_quiet(*command);
    const CLI::Option* output = command->get_option_no_throw("--output");
    if (!output) continue;
    const CLI::Option* json = command->get_option_no_throw("--json");
    const std::string says = json ? "With --output: print nothing but errors, and what --json asks for"
                                  : "With --output: print nothing but errors";
    const CLI::Option* quiet = command->add_flag("--quiet", says);
    command->parse_complete_callback([quiet, output, json] {
      if (quiet->count() > 0 && output->count() > 0 && !(json && json->count() > 0))
        std::cout.rdbuf(&nothing);
    });
  }
}

int run(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands) {
  CLI::App app(
      "asperity: rough, yielding contact of a micro-particle with a plane, from its topography to what a "
      "discrete element simulation needs.");
  app.name("asperity");
  app.set_version_flag("--version", std::string("asperity " ASPERITY_VERSION ", commit ") + build_commit() +
                                        "\nbuilt with " ASPERITY_PACKAGES);
  app.require_subcommand(1);
  app.footer(
      "Start with: asperity case-template > case.prm; asperity solve case.prm --output result\n"
      "Exit status: 0 done, 1 the work failed (what was accepted is kept), 2 the input was refused.");
  add_commands(app);
  add_quiet(app);

  try {
    check_subcommand_exists(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : refused;
  } catch (const InputError& error) {
    return say(error, refused);
  } catch (const std::exception& error) {
    return say(error, failed);
  }
  return 0;
}

}  // namespace

int run_program(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands) {
  open_missing_streams();
  limit_threads_by_environment();  // a case's own Solver/Threads goes before it
  return with_printed_output(run(argc, argv, add_commands));
}

}  // namespace asperity
