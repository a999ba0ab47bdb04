#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/case_file.h"
#include "app/mpi_session.h"
#include "app/solver_commands.h"
#include "fem/mesh_case.h"

namespace asperity {
namespace {

struct MeshArguments {
  std::string file, output;
  std::vector<std::string> overrides;
};

void run_mesh(const MeshArguments& arguments) {
  const Settings settings = read_settings(arguments.file, arguments.overrides);
  const CaseInput input = case_from_settings(settings, arguments.file);
  if (is_speaking_rank()) warn_of_former_names(settings);
  with_mpi(input.solver.threads, [&] {
    naming_lines_of_scans(settings, input, [&] {
      mesh_case(input, arguments.output, [](const std::string& line) {
        if (is_speaking_rank()) std::cout << line << std::endl;
      });
    });
  });
}

}  // namespace

void add_mesh_command(CLI::App& app) {
  const auto arguments = std::make_shared<MeshArguments>();
  CLI::App* command = app.add_subcommand(solver_commands::mesh.name, solver_commands::mesh.says);
  command->add_option("CASE.prm", arguments->file, "Case file (asperity case-template prints one)")
      ->required();
  command->add_option("--output", arguments->output, "Folder for the meshes")->required();
  command
      ->add_option("--set", arguments->overrides,
                   "\"Section/Entry=value\": replaces an entry of the case file")
      ->expected(1)
      ->take_all();
  command->callback([arguments] { run_mesh(*arguments); });
}

}  // namespace asperity
