#include "app/solve_command.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/case_declaration.h"
#include "app/case_file.h"
#include "app/case_folder.h"
#include "app/mpi_session.h"
#include "fem/solve_case.h"

namespace asperity {
namespace {

struct SolveArguments {
  std::string file, output;
  std::vector<std::string> overrides;
  bool resume = false;
};

void run_solve(const SolveArguments& arguments) {
  const Settings settings = read_settings(arguments.file, arguments.overrides);
  const CaseInput input = case_from_settings(settings, arguments.file);
  if (is_speaking_rank()) remember_case(settings, arguments.file, arguments.output, arguments.resume);
  with_mpi(input.solver.threads, [&] {
    SolveOptions options;
    options.output = arguments.output;
    options.resume = arguments.resume;
    options.progress = [](const std::string& line) {
      if (is_speaking_rank()) std::cout << line << std::endl;
    };
    naming_lines_of_scans(settings, input, [&] { solve_case(input, options); });
  });
}

}  // namespace

void add_solve_command(CLI::App& app) {
  const auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command = app.add_subcommand("solve", "Solve one case: result.json, history.csv and fields");
  command->add_option("CASE.prm", arguments->file, "Case file (asperity case-template prints one)")->required();
  command->add_option("--output", arguments->output, "Folder for the results")->required();
  command->add_option("--set", arguments->overrides, "\"Section/Entry=value\": replaces an entry of the case file")
      ->expected(1)->take_all();
  command->add_flag("--resume", arguments->resume, "Go on after the last accepted step in the folder");
  command->add_flag_callback("--help-case", [] {
    std::cout << case_reference();
    throw CLI::Success();
  }, "Print the reference manual of case files");
  command->footer("On several processes: mpirun -np N asperity solve CASE.prm --output DIR");
  command->callback([arguments] { run_solve(*arguments); });
}

}  // namespace asperity
