#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/number_check.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/joined.h"
#include "core/printable.h"
#include "core/quantity.h"
#include "engines/engine.h"
#include "engines/engine_input.h"
#include "engines/many_particles/material_matrix.h"
#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/particle_box.h"
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
  std::vector<std::string> parameters;
  std::string engine, output, load, radii, normal_law = "hertz";
  std::optional<double> restitution;
  std::optional<int> box;
  bool many_particles = false;
};

void put(const std::string& text, const std::string& file) {
  if (file.empty())
    std::cout << text << std::flush;
  else
    write_file_atomically(file, text);
}

/// "5 um to 10 um", or one radius.
LoadRange parse_radii(const std::string& text) {
  const std::string between = " to ";
  const auto at = text.find(between);
  const double low = parse_quantity(text.substr(0, at), Dimension::length);
  return {low, at == std::string::npos ? low
                                       : parse_quantity(text.substr(at + between.size()), Dimension::length)};
}

void write_matrix(const InputArguments& arguments, const std::vector<ContactParameters>& records) {
  MatrixOptions options;
  if (!arguments.load.empty()) options.load = parse_quantity(arguments.load, Dimension::force);
  if (!arguments.radii.empty()) options.radii = parse_radii(arguments.radii);
  options.restitution = arguments.restitution;
  options.normal_law = arguments.normal_law;
  const WrittenEngine& engine = written_engine_of(arguments.engine);
  const MaterialMatrix matrix = material_matrix(records, options);
  if (arguments.box) {
    if (arguments.output.empty())
      throw InputError("--box writes several files: name their folder with --output");
    std::cout << write_box(engine, matrix, *arguments.box, arguments.output) << "\n";
  } else {
    put(matrix_input_of(engine, matrix), arguments.output);
  }
  for (std::size_t i = 0; i < matrix.materials.size(); ++i)
    for (std::size_t j = i; j < matrix.materials.size(); ++j)
      if (matrix.pair(i, j).is_mixed)
        std::cerr << "asperity: " << printable(pair_name(matrix, i, j))
                  << ": no record has this pair; its law is mixed as the file's header says\n";
}

void write_input(const InputArguments& arguments) {
  std::vector<ContactParameters> records;
  for (const auto& file : arguments.parameters) records.push_back(read_contact_parameters(file));
  if (records.size() > 1 || arguments.many_particles || arguments.box) {
    write_matrix(arguments, records);
  } else {
    if (arguments.restitution || !arguments.radii.empty())
      throw InputError("--restitution and --radii are for many particles: add --many-particles");
    EngineInputOptions options;
    if (!arguments.load.empty()) options.load = parse_quantity(arguments.load, Dimension::force);
    options.normal_law = arguments.normal_law;
    put(engine_input(arguments.engine, records.front(), options), arguments.output);
  }
  for (const ContactParameters& record : records)
    for (const auto& missing : needed_cases(record))
      std::cerr << "asperity: " << (records.size() > 1 ? printable(record.file) + ": " : "")
                << "the record lacks " << to_text(missing) << "; that resistance is left out\n";
}

void add_run_command(CLI::App& app) {
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
      ->check(positive_number());
  engine->add_option(
      "--program", run_arguments->program,
      "The engine's executable (default: " + list_runnable_engines(&Engine::executable, ", ") + ")");
  engine->add_option("--time-limit", run_arguments->time_limit, "Seconds after which the engine is stopped")
      ->capture_default_str()
      ->check(positive_number());
  engine->add_flag("--json", run_arguments->json, "Print JSON instead of a table");
  engine->footer(
      "Example: asperity engine runs/paper/parameters_silicon.json --indenter "
      "runs/paper/parameters_diamond.json"
      " --engine lammps --experiment rolling --amplitude '50 nm' --output output/rolling");
  engine->callback([run_arguments] { run_engine(*run_arguments); });
}

void add_input_command(CLI::App& app) {
  const auto input_arguments = std::make_shared<InputArguments>();
  CLI::App* input = app.add_subcommand("engine-input",
                                       "Write contacts as what a user pastes into a discrete element engine");
  input
      ->add_option("PARAMETERS.json", input_arguments->parameters,
                   "Contact as asperity derived it; several of them, one for each pair of materials, for "
                   "many particles")
      ->required();
  input->add_option("--engine", input_arguments->engine, joined(engine_input_names(), ", "))->required();
  input->add_option("--output", input_arguments->output,
                    "File to write (default: print); with --box a folder");
  input->add_option("--load", input_arguments->load,
                    "Normal load at which limits that depend on it are right (default: balanced over the "
                    "fitted loads); with "
                    "many particles also the highest load that the time step is for");
  input
      ->add_option(
          "--normal-law", input_arguments->normal_law,
          "hertz, or of a contact that yielded luding (liggghts, mercurydpm, yade) or, one contact at a "
          "time, mdr (lammps)")
      ->capture_default_str();
  input->add_flag("--many-particles", input_arguments->many_particles,
                  "All pairs of all materials with time step and damping (implied by several records)");
  input->add_option("--restitution", input_arguments->restitution,
                    "Of a normal impact, for the damping between many particles (default: 0.5; with "
                    "luding 0.99, for yielding dissipates besides)");
  input->add_option(
      "--radii", input_arguments->radii,
      "'5 um to 10 um': smallest and largest of many particles (default: those of the records)");
  input->add_option(
      "--box", input_arguments->box,
      "Write a box of so many particles beside the contacts, which the engine runs (lammps, liggghts, yade)");
  input->footer(
      "Example: asperity engine-input glass_on_silicon.json glass_on_glass.json --engine lammps "
      "--restitution 0.8 "
      "--box 1000 --output output/box");
  input->callback([input_arguments] { write_input(*input_arguments); });
}

}  // namespace

void add_engine_commands(CLI::App& app) {
  add_run_command(app);
  add_input_command(app);
}

}  // namespace asperity
