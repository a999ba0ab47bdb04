// The program `asperity`: one subcommand per hop. Exit status 0 done, 1 the work failed, 2 the input was refused.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

#include "app/case_command.h"
#include "app/study_command.h"
#include "core/error.h"

int main(int argc, char** argv) {
  CLI::App app(
      "asperity: rough, yielding contact of a micro-particle with a plane, from its topography to what a discrete "
      "element simulation needs.");
  app.name("asperity");
  app.set_version_flag("--version", "asperity " ASPERITY_VERSION);
  app.require_subcommand(1);
  app.footer("Start with: asperity case-template > case.prm; asperity solve case.prm --output result\n"
             "Exit status: 0 done, 1 the work failed (what was accepted is kept), 2 the input was refused.");
  asperity::add_study_command(app);
  asperity::add_case_commands(app);

  constexpr int failed = 1, refused = 2;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : refused;
  } catch (const asperity::InputError& error) {
    std::fprintf(stderr, "asperity: %s\n", error.what());
    return refused;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "asperity: %s\n", error.what());
    return failed;
  }
  return 0;
}
