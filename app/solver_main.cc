// The program `asperity-solver`: the commands that need deal.II, CGAL or VTK. `asperity` starts it for them.
#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/program.h"

int main(int argc, char** argv) {
  using namespace asperity;
  return run_program(argc, argv, [](CLI::App& app) {
    add_characterise_command(app);
    add_preview_command(app);
    add_mesh_command(app);
    add_solve_command(app);
    add_study_command(app);
    add_report_command(app);
  });
}
