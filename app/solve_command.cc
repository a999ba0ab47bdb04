#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/case_declaration.h"
#include "app/case_file.h"
#include "app/case_folder.h"
#include "app/inputs_hash.h"
#include "app/mpi_session.h"
#include "app/solver_commands.h"
#include "core/build_commit.h"
#include "core/error.h"
#include "fem/solve_case.h"

namespace asperity {
namespace {

struct SolveArguments {
  std::string file, output;
  std::vector<std::string> overrides;
  bool resume = false, overwrite = false, check = false, verbose = false;
};

void run_solve(const SolveArguments& arguments) {
  const Settings settings = read_settings(arguments.file, arguments.overrides);
  const CaseInput input = case_from_settings(settings, arguments.file);
  if (is_speaking_rank()) warn_of_former_names(settings);
  if (arguments.check) {
    naming_lines_of_scans(settings, input, [&] { check_case(input); });
    say("'" + arguments.file + "' is accepted; nothing was solved");
    return;
  }
  if (arguments.output.empty())
    throw InputError("solve needs --output DIR, the folder for the results (or --check)");
  const FolderedCase now{
      settings, arguments.file, arguments.output, {inputs_sha256(settings, arguments.file), build_commit()}};
  const SolveStart start = check_folder(now, arguments.overwrite ? IfSolved::overwrite
                                             : arguments.resume  ? IfSolved::resume
                                                                 : IfSolved::refuse);
  if (start == SolveStart::finished) {
    say("'" + arguments.output + "' holds the finished result of this case already");
    return;
  }
  with_mpi(input.solver.threads, [&] {
    SolveOptions options;
    options.output = arguments.output;
    options.resume = start == SolveStart::go_on;
    options.inputs_sha256 = now.provenance.inputs_sha256;
    options.before_writing = [&] { claim_folder(now, start); };
    options.progress = say;
    options.says_iterations = arguments.verbose;
    naming_lines_of_scans(settings, input, [&] { solve_case(input, options); });
  });
}

}  // namespace

void add_solve_command(CLI::App& app) {
  const auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command = app.add_subcommand(solver_commands::solve.name, solver_commands::solve.says);
  command->add_option("CASE.prm", arguments->file, "Case file (asperity case-template prints one)")
      ->required();
  command->add_option("--output", arguments->output, "Folder for the results");
  command
      ->add_option("--set", arguments->overrides,
                   "\"Section/Entry=value\": replaces an entry of the case file")
      ->expected(1)
      ->take_all();
  const auto resume = command->add_flag(
      "--resume", arguments->resume,
      "Go on after the last accepted step in the folder; refused if that is of other inputs");
  command
      ->add_flag("--overwrite", arguments->overwrite,
                 "Solve anew where the folder holds a solution; what is there is lost")
      ->excludes(resume);
  command->add_flag(
      "--check", arguments->check,
      "Read the case and its scans and refuse what would be refused before meshing; solve and write nothing");
  command->add_flag("--verbose", arguments->verbose,
                    "Say each Newton step and each update of the contact tractions as well");
  command->add_flag_callback(
      "--help-case",
      [] {
        std::cout << case_reference();
        throw CLI::Success();
      },
      "Print the reference manual of case files");
  command->footer("On several processes: mpirun -np N asperity solve CASE.prm --output DIR");
  command->callback([arguments] { run_solve(*arguments); });
}

}  // namespace asperity
