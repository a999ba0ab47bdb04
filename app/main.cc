// The program `asperity`: one subcommand per hop. Exit status 0 done, 1 the work failed, 2 the input was
// refused.
#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/program.h"
#include "app/solver_commands.h"

int main(int argc, char** argv) {
  using namespace asperity;
  return run_program(argc, argv, [argv](CLI::App& app) {
    add_surface_command(app);
    add_solver_command(app, solver_commands::characterise, argv);
    add_materials_command(app);
    add_solver_command(app, solver_commands::preview, argv);
    add_solver_command(app, solver_commands::mesh, argv);
    add_solver_command(app, solver_commands::solve, argv);
    add_solver_command(app, solver_commands::study, argv);
    add_derive_command(app);
    add_compare_command(app);
    add_import_command(app);
    add_diagnose_command(app);
    add_conceal_command(app);
    add_challenge_command(app);
    add_experiment_commands(app);
    add_engine_commands(app);
    add_paper_command(app);
    add_solver_command(app, solver_commands::report, argv);
    add_case_commands(app);
  });
}
