#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "diagnosis/conceal/concealed_recording.h"

namespace asperity {
namespace {

struct ConcealArguments {
  std::vector<std::string> effects;
  std::string mode = "normal", output, setting, from_case;
  double noise = 0.01;
  unsigned seed = 1;
};

void run_conceal(const ConcealArguments& arguments) {
  ConcealOptions options;
  options.mode = mode_of(arguments.mode);
  for (const auto& effect : arguments.effects)
    if (effect != "none") options.effects.push_back(effect);
  options.noise = arguments.noise;
  options.seed = arguments.seed;
  options.setting = arguments.setting;
  const ConcealedRecording concealed =
      arguments.from_case.empty() ? conceal(options) : conceal_case(arguments.from_case, options);
  write_concealed(concealed, arguments.output);
  std::cout << arguments.output << ": " << concealed.recording.tables[0].rows()
            << " rows; the truth is in truth.json, which 'asperity diagnose' does not read\n";
}

std::string list_of_effects() {
  std::string text =
      "Effects by mode (outside of the catalogue in round brackets, for diagnose --case alone in square "
      "ones, with --setting other_code alone in braces):\n";
  for (const Motion mode : all_modes()) {
    text += "  " + name_of(mode) + ":";
    for (const auto& effect : concealable_effects(mode)) text += " " + effect;
    for (const auto& effect : out_of_catalogue_effects(mode)) text += " (" + effect + ")";
    for (const auto& effect : effects_beside_a_case(mode)) text += " [" + effect + "]";
    for (const auto& effect : effects_by_other_code_alone(mode)) text += " {" + effect + "}";
    text += "\n";
  }
  return text;
}

}  // namespace

void add_conceal_command(CLI::App& app) {
  const auto arguments = std::make_shared<ConcealArguments>();
  CLI::App* command = app.add_subcommand(
      "conceal", "Write a recording in which effects are hidden, from other models than those that diagnose");
  command
      ->add_option("--effect", arguments->effects,
                   "Name, or names separated by commas; none: an experiment without mismatch")
      ->delimiter(',');
  command->add_option("--mode", arguments->mode, "normal, sliding, rolling, rail or torsion")->required();
  command->add_option("--noise", arguments->noise, "Standard deviation of a sample over the largest response")
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "Of everything that is drawn: experiment, parameters, noise")
      ->capture_default_str();
  command->add_option("--setting", arguments->setting,
                      "one_load, ramp_only: experiments in which some effects are not distinguishable; "
                      "long_hold, small_loops: in which one looks like another; other_code: yielding, "
                      "roughness and films by other codes' solutions");
  command->add_option("--from-case", arguments->from_case,
                      "Take the history of this solved case as truth (modes normal and sliding); --effect "
                      "then only says what it shows");
  command->add_option("--output", arguments->output, "Folder for recording.json, its CSV and truth.json")
      ->required();
  command->footer(list_of_effects() +
                  "Example: asperity conceal --effect lateral_compliance --mode sliding --noise 0.02 --seed "
                  "3 --output output/hidden");
  command->callback([arguments] { run_conceal(*arguments); });
}

}  // namespace asperity
