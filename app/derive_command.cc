#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/output_folder.h"
#include "dem_compare/derive/derivation.h"
#include "engines/needed_cases.h"
#include "report/sentences/derivation_sentences.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct DeriveArguments {
  std::vector<std::string> folders;
  std::string output = "parameters.json";
  bool json = false;
};

/// parameters.json; parameters_1.json, parameters_2.json, ... of several sets.
fs::path file_of(const fs::path& output, std::size_t set, std::size_t sets) {
  if (sets == 1) return output;
  return output.parent_path() /
         (output.stem().string() + "_" + std::to_string(set + 1) + output.extension().string());
}

void run_derive(const DeriveArguments& arguments) {
  const ParameterSets found = collect_parameter_sets({arguments.folders.begin(), arguments.folders.end()});
  const fs::path output = arguments.output;
  if (output.has_parent_path()) make_folder(output.parent_path());
  std::string text;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& sentence : found.remarks) text += sentence + "\n";
  if (found.sets.size() > 1)
    text += std::to_string(found.sets.size()) + " parameter sets, one file each; they differ in " +
            differences(found.sets) + "\n";
  std::vector<Derivation> derivations;
  for (const auto& set : found.sets) derivations.push_back(derive_parameters(reduced_set(set)));
  const std::vector<LawFindings> over_radii = compare_radii(found.sets, derivations);
  for (std::size_t i = 0; i < derivations.size(); ++i) {
    report::write_words(derivations[i]);
    const fs::path file = file_of(output, i, derivations.size());
    write_contact_parameters(derivations[i].parameters, file);
    const std::string needed = needed_cases_text(derivations[i].parameters);
    text += (text.empty() ? "" : "\n") + report::derivation_text(derivations[i]) +
            (needed.empty() ? "" : "\n" + needed) + "\nwrote " + file.string() + "\n";
    all.push_back(to_json(derivations[i].parameters));
  }
  for (const auto& findings : over_radii) text += "\n" + report::law_text(findings);
  if (arguments.json)
    std::cout << (all.size() == 1 ? all[0] : all).dump(1) << "\n" << std::flush;
  else
    std::cout << text << std::flush;
}

}  // namespace

void add_derive_command(CLI::App& app) {
  const auto arguments = std::make_shared<DeriveArguments>();
  CLI::App* command = app.add_subcommand(
      "derive", "Derive the laws of a discrete element model from solved cases: parameters.json");
  command->add_option("DIR", arguments->folders, "Folders that solve or study wrote, or folders of such")
      ->required()
      ->check(CLI::ExistingDirectory);
  command
      ->add_option("--output", arguments->output,
                   "File to write; cases of different bodies, roughness or interface give parameters_1.json, "
                   "parameters_2.json, ...")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print what is written instead of a summary");
  command->footer(
      "Example: asperity derive output/sliding output/torsion --output parameters.json\n"
      "Cases of one set share bodies, roughness (but for its seed) and interface; they may differ by load, "
      "experiment, mesh. The order of the folders changes nothing.");
  command->callback([arguments] { run_derive(*arguments); });
}

}  // namespace asperity
