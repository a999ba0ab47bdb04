#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/equations_option.h"
#include "app/number_check.h"
#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "core/quantity.h"
#include "dem_compare/experiments/dynamic.h"
#include "dem_compare/experiments/from_parameters.h"
#include "dem_compare/experiments/particle_experiment.h"
#include "dem_compare/experiments/quasi_static.h"
#include "dem_compare/laws/law_curve.h"
#include "dem_compare/laws/viscous.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct ExperimentArguments {
  std::string type, substrate, indenter, output;
  std::string load = "100 uN", amplitude = "1 um", rail_angle = "45 deg", speed;
  std::vector<std::string> laws;
  int cycles = 1;
  double damping = 1;
  bool partial_slip = false, normal_adhesion = false, json = false;
};

nlohmann::ordered_json experiment_json(const ExperimentArguments& arguments, const FrictionLoop& loop,
                                       const LoopNumbers& numbers, double load) {
  const auto quantity = [](double value, const char* unit) {
    return nlohmann::ordered_json{{"value", value}, {"unit", unit}};
  };
  nlohmann::ordered_json json{{"format", "asperity-experiment/1"},
                              {"experiment", arguments.type},
                              {"normal_load", quantity(load, "N")},
                              {"initial_slope", quantity(numbers.initial_slope, "N/m")},
                              {"reversal_slope", quantity(numbers.reversal_slope, "N/m")},
                              {"plateau", quantity(numbers.plateau, "N")},
                              {"offset", quantity(numbers.offset, "N")},
                              {"reversal_travel", quantity(numbers.reversal_travel, "m")},
                              {"plateau_travel", quantity(numbers.plateau_travel, "m")},
                              {"dissipation", quantity(numbers.dissipation, "J")}};
  if (loop.speed > 0) {
    json["speed"] = quantity(loop.speed, "m/s");
    json["speed_over_laboratory"] = loop.speed / laboratory_speed;
  }
  return json;
}

std::string experiment_text(const LoopNumbers& numbers, double load) {
  const auto line = [](const char* name, double value, Dimension dimension) {
    return std::string(name) + format_quantity(value, dimension, 5) + "\n";
  };
  return line("normal load at the indenter        ", load, Dimension::force) +
         line("slope from rest                    ", numbers.initial_slope, Dimension::stiffness) +
         line("slope after a reversal             ", numbers.reversal_slope, Dimension::stiffness) +
         line("plateau of the lateral force       ", numbers.plateau, Dimension::force) +
         line("path from a reversal to the plateau", numbers.plateau_travel, Dimension::length) +
         "plateau over normal load           " + format_quantity(numbers.plateau / load, Dimension::none, 5) +
         "\n";
}

bool has_viscous_law(const ReducedLawOptions& options) {
  return std::any_of(options.laws.begin(), options.laws.end(),
                     [](const WrittenLaw& law) { return law.description.mode == ViscousMode::name; });
}

void run_experiment(const ExperimentArguments& arguments) {
  ReducedLawOptions options;
  options.partial_slip = arguments.partial_slip;
  options.normal_adhesion = arguments.normal_adhesion;
  for (const auto& law : arguments.laws) options.laws.push_back(parse_law(law));
  ContactModel substrate = contact_model(read_contact_parameters(arguments.substrate), options),
               indenter = substrate;
  if (!arguments.indenter.empty())
    indenter = contact_model(read_contact_parameters(arguments.indenter), options);
  if (indenter.normal->radius() != substrate.normal->radius())
    throw InputError(arguments.indenter + ": its particle has another radius than that of " +
                     arguments.substrate);
  if (!has_viscous_law(options)) substrate.damping = indenter.damping = ViscousDamping{arguments.damping};
  const SingleParticle particle = make_particle(
      arguments.type, {substrate, indenter, parse_quantity(arguments.rail_angle, Dimension::angle)});

  LoopProgram program;
  // As `asperity engine` has it, the load is the substrate's: in a rail that of each flank.
  program.normal_load = parse_quantity(arguments.load, Dimension::force) / particle.contacts.front().share;
  program.amplitude = parse_quantity(arguments.amplitude, Dimension::length);
  program.cycles = arguments.cycles;
  FrictionLoop loop;
  if (arguments.speed.empty()) {
    loop = simulate_quasi_static(particle, program);
  } else {
    DynamicOptions dynamic;
    dynamic.speed = parse_quantity(arguments.speed, Dimension::speed);
    loop = simulate_dynamic(particle, program, dynamic);
  }
  const LoopNumbers numbers = measure(loop);
  const std::string json = experiment_json(arguments, loop, numbers, program.normal_load).dump(1) + "\n";
  if (!arguments.output.empty()) {
    const fs::path output = arguments.output;
    make_folder(output);
    write_file_atomically(output / "loop.csv", to_csv(loop));
    write_file_atomically(output / "experiment.json", json);
  }
  std::cout << (arguments.json ? json : experiment_text(numbers, program.normal_load)) << std::flush;
}

struct CurveArguments {
  std::string parameters, law, load = "100 uN", output;
  double reach = 0;
  int points = 50;
};

void write_curve(const CurveArguments& arguments) {
  const ContactParameters parameters = read_contact_parameters(arguments.parameters);
  const WrittenLaw law = parse_law(arguments.law);
  const NormalLaw normal = contact_model(parameters).normal;
  LawCurveOptions options;
  options.normal = normal->advance({}, normal->approach(parse_quantity(arguments.load, Dimension::force)));
  options.lever = parameters.particle.radius;
  options.reach = arguments.reach;
  options.points = arguments.points;
  if (law.description.mode == ViscousMode::name) options.mass = parameters.particle_mass();
  const LawCurve curve = curve_of(law_of_contact(law, parameters), options);
  const std::string csv = format_csv(curve.names, curve.columns);
  if (arguments.output.empty())
    std::cout << csv << std::flush;
  else
    write_file_atomically(arguments.output, csv);
}

void add_law_commands(CLI::App& app) {
  CLI::App* laws = app.add_subcommand("laws", "Print the manual of the reduced laws");
  const auto is_typeset = std::make_shared<bool>(false);
  add_typeset(*laws, *is_typeset);
  laws->callback([is_typeset] { std::cout << reduced_laws_manual(equations_of(*is_typeset)) << std::flush; });

  const auto arguments = std::make_shared<CurveArguments>();
  CLI::App* curve = app.add_subcommand(
      "law-curve", "Write what a reduced law says of a contact that is loaded monotonically, as CSV");
  curve->add_option("PARAMETERS.json", arguments->parameters, "Contact of particle and substrate")
      ->required();
  curve
      ->add_option("--law", arguments->law,
                   "Law and parameters that the contact does not know ('asperity laws' names them)")
      ->required();
  curve->add_option("--load", arguments->load, "Normal load, but for normal laws")->capture_default_str();
  curve
      ->add_option("--reach", arguments->reach,
                   "How far, in the unit of the first column: m of approach or shift, rad, m/s, or a ratio "
                   "of velocities")
      ->required()
      ->check(positive_number());
  curve->add_option("--points", arguments->points, "Of the curve behind the first")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  curve->add_option("--output", arguments->output, "File to write (default: print)");
  curve->footer(
      "Example: asperity law-curve runs/paper/parameters_silicon.json --law 'jkr, work_of_adhesion = 50 "
      "mJ/m^2' --reach 10e-9");
  curve->callback([arguments] { write_curve(*arguments); });
}

}  // namespace

void add_experiment_commands(CLI::App& app) {
  const auto arguments = std::make_shared<ExperimentArguments>();
  CLI::App* command = app.add_subcommand(
      "experiment", "Run one of the paper's experiments with one particle by the reduced laws");
  command->add_option("PARAMETERS.json", arguments->substrate, "Contact of particle and substrate")
      ->required();
  std::string types;
  std::vector<std::string> names;
  for (const auto& experiment : particle_experiments()) {
    types += (types.empty() ? "" : ", ") + experiment.name + " (" + experiment.meaning + ")";
    names.push_back(experiment.name);
  }
  command->add_option("--type", arguments->type, types)->required()->check(CLI::IsMember(names));
  command->add_option("--output", arguments->output,
                      "Folder for loop.csv and experiment.json (default: print the numbers alone)");
  command->add_option("--indenter", arguments->indenter,
                      "Contact of particle and plate (default: as with the substrate)");
  command->add_option("--load", arguments->load, "Normal load on the substrate, in a rail on each flank")
      ->capture_default_str();
  command->add_option("--amplitude", arguments->amplitude, "Of the loop")->capture_default_str();
  command->add_option("--cycles", arguments->cycles, "Full cycles of the loop")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--rail-angle", arguments->rail_angle, "Inclination of the rail's flanks")
      ->capture_default_str();
  command->add_flag("--partial-slip", arguments->partial_slip, "Mindlin and Deresiewicz in place of Mindlin");
  command
      ->add_option("--law", arguments->laws,
                   "In place of the law of its mode, such as 'jkr, work_of_adhesion = 50 mJ/m^2'; once for "
                   "each mode ('asperity laws' names them all)")
      ->allow_extra_args(false);
  command->add_flag("--normal-adhesion", arguments->normal_adhesion,
                    "The pull-off force presses with the load");
  command->add_option("--speed", arguments->speed,
                      "With inertia, at this speed of the indenter (default: quasi-static)");
  command->add_option("--damping", arguments->damping, "Viscous coefficient c of (m k)^(1/2), with --speed")
      ->capture_default_str()
      ->check(number_not_below_zero());
  command->add_flag("--json", arguments->json, "Print JSON instead of a table");
  command->footer(
      "Example: asperity experiment runs/paper/parameters_silicon.json --indenter "
      "runs/paper/parameters_diamond.json --type rail --rail-angle '25 deg' --load '500 uN' --output "
      "output/rail");
  command->callback([arguments] { run_experiment(*arguments); });
  add_law_commands(app);
}

}  // namespace asperity
