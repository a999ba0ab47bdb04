#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/quantity.h"
#include "diagnosis/import/import.h"

namespace asperity {
namespace {

struct ImportArguments {
  std::string file, output, mode = "normal", format, title, response;
  std::string radius, particle_modulus, substrate_modulus, spring_constant;
  std::optional<double> particle_poisson, substrate_poisson;
  std::optional<int> run;
  std::vector<std::string> columns, control;
};

std::optional<double> quantity(const std::string& text, Dimension dimension) {
  return text.empty() ? std::nullopt : std::optional<double>(parse_quantity(text, dimension));
}

void run_import(const ImportArguments& arguments) {
  ImportOptions options;
  options.format = arguments.format;
  options.title = arguments.title;
  options.mode = mode_of(arguments.mode);
  options.radius = quantity(arguments.radius, Dimension::length);
  options.particle_modulus = quantity(arguments.particle_modulus, Dimension::pressure);
  options.particle_poisson = arguments.particle_poisson;
  options.substrate_modulus = quantity(arguments.substrate_modulus, Dimension::pressure);
  options.substrate_poisson = arguments.substrate_poisson;
  options.spring_constant = quantity(arguments.spring_constant, Dimension::stiffness);
  options.run = arguments.run;
  options.control = arguments.control;
  options.response = arguments.response;
  options.columns = arguments.columns;
  const Recording recording = import_recording(arguments.file, options);
  write_recording(recording, arguments.output);
  const RecordingTable& table = recording.tables.front();
  std::map<std::string, std::size_t> segments;
  for (const auto& segment : table.segment) ++segments[segment];
  std::cout << arguments.output << ": " << recording.title << ", " << table.rows() << " samples, "
            << table.response << " driven by " << table.control.front();
  for (const auto& [segment, count] : segments) std::cout << ", " << segment << " " << count;
  std::cout << "\n";
}

}  // namespace

void add_import_command(CLI::App& app) {
  const auto a = std::make_shared<ImportArguments>();
  CLI::App* command = app.add_subcommand(
      "import", "Turn an instrument's own text (Hysitron, Optics11, Fischer, any CSV) into a recording");
  command
      ->add_option("FILE", a->file,
                   "Text as the instrument wrote it; UTF-8 or Latin-1, decimal points or commas")
      ->required();
  command->add_option("--output", a->output, "Folder for recording.json and its CSV")->required();
  command->add_option("--format", a->format,
                      "hysitron, optics11, fischer or csv (default: recognised from the text)");
  command->add_option("--mode", a->mode, "normal, sliding, rolling, rail or torsion")->capture_default_str();
  command->add_option("--title", a->title, "Of the recording");
  command->add_option("--radius", a->radius, "Of sphere or tip, where the file does not say it");
  command->add_option("--particle-modulus", a->particle_modulus,
                      "Young's modulus of sphere or tip (default: diamond, 1140 GPa)");
  command->add_option("--particle-poisson", a->particle_poisson, "Its Poisson's ratio");
  command->add_option("--substrate-modulus", a->substrate_modulus, "Young's modulus of the substrate");
  command->add_option("--substrate-poisson", a->substrate_poisson, "Its Poisson's ratio");
  command->add_option("--spring-constant", a->spring_constant,
                      "Of the cantilever, in place of the file's own");
  command->add_option("--run", a->run, "Only this experiment of the file, from 1");
  command->add_option(
      "--column", a->columns,
      "For tables that are not recognised: \"channel [unit] = factor * column\"; once for each channel; "
      "\"channel:forward\" and \"channel:backward\" for scans with both directions side by side");
  command->add_option("--control", a->control,
                      "Channel that drives the simulation (default: by format and mode)");
  command->add_option("--response", a->response, "Channel that is compared");
  command->footer(
      "Example: asperity import test.csv --column 'time [s]=t' --column 'normal_displacement [nm]=depth' "
      "--column 'normal_force [mN]=load'"
      " --radius '5 um' --substrate-modulus '72 GPa' --substrate-poisson 0.17 --output output/test");
  command->callback([a] { run_import(*a); });
}

}  // namespace asperity
