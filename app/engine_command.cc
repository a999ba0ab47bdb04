#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/joined.h"
#include "core/quantity.h"
#include "engines/engine.h"
#include "engines/engine_input.h"
#include "engines/needed_cases.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::string engine, experiment, parameters, indenter, output, program;
  std::string load = "100 uN", amplitude = "1 um", rail_angle = "45 deg";
  double haste = 1;
  int time_limit = 600;
  bool json = false;
};

void run_engine(const RunArguments& arguments) {
  const Engine& engine = engine_of(arguments.engine);
  EngineExperiment experiment;
  experiment.type = engine_experiment_type(arguments.experiment);
  experiment.substrate = read_contact_parameters(arguments.parameters);
  experiment.indenter =
      arguments.indenter.empty() ? experiment.substrate : read_contact_parameters(arguments.indenter);
  for (const ContactParameters* contact : {&experiment.substrate, &experiment.indenter})
    if (!contact->target.is_plane())
      throw InputError(contact->file + ": these experiments are with planes; its target is a sphere");
  if (experiment.indenter.particle.radius != experiment.substrate.particle.radius)
    throw InputError(arguments.indenter + ": its particle has another radius than that of " +
                     arguments.parameters);
  experiment.load = parse_quantity(arguments.load, Dimension::force);
  experiment.amplitude = parse_quantity(arguments.amplitude, Dimension::length);
  experiment.rail_angle = parse_quantity(arguments.rail_angle, Dimension::angle);
  const double quarter_turn = parse_quantity("90 deg", Dimension::angle);
  if (!(experiment.rail_angle > 0 && experiment.rail_angle < quarter_turn))
    throw InputError("--rail-angle must lie between 0 and 90 deg");
  experiment.haste = arguments.haste;
  EngineRunOptions options;
  options.program = arguments.program;
  options.time_limit = std::chrono::seconds(arguments.time_limit);
  const fs::path output = arguments.output;
  const EngineRun result = run_engine(engine, experiment, output, options);
  const std::string json = to_json(result, experiment).dump(1) + "\n";
  write_file_atomically(output / "engine.json", json);
  std::cout << (arguments.json ? json : to_text(result, experiment)) << std::flush;
}

struct InputArguments {
  std::string engine, parameters, output, load;
};

void write_input(const InputArguments& arguments) {
  EngineInputOptions options;
  if (!arguments.load.empty()) options.load = parse_quantity(arguments.load, Dimension::force);
  const ContactParameters parameters = read_contact_parameters(arguments.parameters);
  const std::string text = engine_input(arguments.engine, parameters, options);
  if (arguments.output.empty())
    std::cout << text << std::flush;
  else
    write_file_atomically(arguments.output, text);
  for (const auto& missing : needed_cases(parameters))
    std::cerr << "asperity: the record lacks " << to_text(missing) << "; that resistance is left out\n";
}

}  // namespace

void add_engine_commands(CLI::App& app) {
  const auto run_arguments = std::make_shared<RunArguments>();
  CLI::App* engine = app.add_subcommand("engine", "Run one of the paper's experiments with one particle in " +
                                                      list_runnable_engines(&Engine::name, " or "));
  engine->add_option("PARAMETERS.json", run_arguments->parameters, "Contact of particle and substrate")
      ->required();
  engine->add_option("--engine", run_arguments->engine, list_runnable_engines(&Engine::key, " or "))
      ->required();
  engine
      ->add_option("--experiment", run_arguments->experiment,
                   "glued (sliding loop), rolling (under a plate), rail (V-rail under a plate) or twisting")
      ->required();
  engine
      ->add_option("--output", run_arguments->output,
                   "Folder for the engine's input, its log, trace.csv and engine.json")
      ->required();
  engine->add_option("--indenter", run_arguments->indenter,
                     "Contact of particle and plate (default: as with the substrate)");
  engine->add_option("--load", run_arguments->load, "Normal load on the substrate, in a rail on each slope")
      ->capture_default_str();
  engine->add_option("--amplitude", run_arguments->amplitude, "Of the loop; of the path in a rail")
      ->capture_default_str();
  engine->add_option("--rail-angle", run_arguments->rail_angle, "Inclination of the rail's slopes")
      ->capture_default_str();
  engine->add_option("--haste", run_arguments->haste, "Factor on the speed that asperity chooses")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  engine->add_option(
      "--program", run_arguments->program,
      "The engine's executable (default: " + list_runnable_engines(&Engine::executable, ", ") + ")");
  engine->add_option("--time-limit", run_arguments->time_limit, "Seconds after which the engine is stopped")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  engine->add_flag("--json", run_arguments->json, "Print JSON instead of a table");
  engine->footer(
      "Example: asperity engine runs/paper/parameters_silicon.json --indenter "
      "runs/paper/parameters_diamond.json"
      " --engine lammps --experiment rolling --amplitude '50 nm' --output output/rolling");
  engine->callback([run_arguments] { run_engine(*run_arguments); });

  const auto input_arguments = std::make_shared<InputArguments>();
  CLI::App* input = app.add_subcommand(
      "engine-input", "Write a contact as what a user pastes into a discrete element engine");
  input->add_option("PARAMETERS.json", input_arguments->parameters, "Contact as asperity derived it")
      ->required();
  input->add_option("--engine", input_arguments->engine, joined(engine_input_names(), ", "))->required();
  input->add_option("--output", input_arguments->output, "File to write (default: print)");
  input->add_option(
      "--load", input_arguments->load,
      "Normal load at which limits that depend on it are right (default: balanced over the fitted loads)");
  input->callback([input_arguments] { write_input(*input_arguments); });
}

}  // namespace asperity
