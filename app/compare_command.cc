#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/number_check.h"
#include "core/atomic_file.h"
#include "core/data_folder.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "dem_compare/compare/comparison.h"
#include "dem_compare/compare/side_by_side.h"
#include "paper/published_column.h"
#include "report/comparison/comparison_file.h"
#include "report/comparison/comparison_page.h"
#include "results/energy_balance.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  std::vector<std::string> folders;
  std::vector<std::string> parameters;
  std::string output, engine, indenter, program;
  std::string published = data_folder("runs", ASPERITY_RUNS) / "paper/published";
  double tolerance = 0.05;
  int time_limit = 600;
  bool json = false;
};

void run_compare(const CompareArguments& arguments) {
  if (!arguments.indenter.empty() && arguments.parameters.empty())
    throw InputError(
        "--indenter is the contact with the moving plate beside that with the substrate: name that with "
        "--parameters");
  for (const auto& folder : arguments.folders)
    if (is_case_folder(folder) && !is_study_folder(folder)) refuse_open_energy(read_solved_case(folder));
  const CaseCollection collection = collect_cases({arguments.folders.begin(), arguments.folders.end()});
  const Comparison comparison = compare_with_hertz(collection, arguments.tolerance);
  const fs::path output = arguments.output.empty() ? arguments.folders.front() : arguments.output;

  SideBySideInput input{collection, comparison};
  for (const auto& file : arguments.parameters) input.parameters.push_back(read_contact_parameters(file));
  if (!arguments.indenter.empty()) input.indenter = read_contact_parameters(arguments.indenter);
  EngineRunOptions options;
  options.program = arguments.program;
  options.time_limit = std::chrono::seconds(arguments.time_limit);
  EngineColumn engine(arguments.engine, output / "engine", options);
  const SideBySide columns = compare_side_by_side(input, PublishedColumn(read_published(arguments.published)),
                                                  engine, arguments.tolerance);

  auto object = report::comparison_json(comparison);
  object["side_by_side"] = report::side_by_side_json(columns);
  const std::string json = object.dump(1) + "\n", markdown = report::comparison_markdown(comparison) + "\n" +
                                                             report::side_by_side_markdown(columns);
  make_folder(output);
  write_file_atomically(output / "comparison.json", json);
  write_file_atomically(output / "comparison.md", markdown);
  write_file_atomically(output / "comparison.csv", report::comparison_csv(comparison));
  write_file_atomically(output / "side_by_side.csv", report::side_by_side_csv(columns));
  write_file_atomically(output / "comparison.html", report::comparison_page(columns));
  std::cout << (arguments.json ? json : markdown) << std::flush;
  // The other columns are worth having without it.
  if (!columns.engine_failure.empty()) throw WorkError(columns.engine_failure);
}

}  // namespace

void add_compare_command(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "Set solved cases beside Hertz, the reduced laws, a live engine and the published measurement");
  command->add_option("DIR", arguments->folders, "Folders that solve or study wrote")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--tolerance", arguments->tolerance, "Departure that counts as one")
      ->capture_default_str()
      ->check(positive_number());
  command
      ->add_option("--parameters", arguments->parameters,
                   "Contact's numbers for an engine: adds rolling, torsion and rails (as "
                   "runs/paper/parameters_silicon.json); once for each roughness")
      ->allow_extra_args(false);
  command->add_option("--indenter", arguments->indenter,
                      "The same for particle and moving plate (default: as with the substrate)");
  command->add_option("--engine", arguments->engine,
                      "Run " + list_runnable_engines(&Engine::key, " or ") + " with each law's numbers");
  command->add_option(
      "--program", arguments->program,
      "The engine's executable (default: " + list_runnable_engines(&Engine::executable, ", ") + ")");
  command
      ->add_option("--time-limit", arguments->time_limit,
                   "Seconds after which one run of the engine is stopped")
      ->capture_default_str()
      ->check(positive_number());
  command->add_option("--published", arguments->published, "Folder of the published numbers")
      ->capture_default_str();
  command->add_option("--output", arguments->output,
                      "Folder for comparison.html, .json, .csv and .md, side_by_side.csv and the engine's "
                      "runs (default: the first DIR)");
  command->add_flag("--json", arguments->json, "Print JSON instead of tables");
  command->footer(
      "Example: asperity compare output/paper --parameters runs/paper/parameters_silicon.json --engine "
      "lammps");
  command->callback([arguments] { run_compare(*arguments); });
}

}  // namespace asperity
