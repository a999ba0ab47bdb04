#include "app/compare_command.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "dem_compare/comparison.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::vector<std::string> folders;
  std::string output;
  double tolerance = 0.05;
  bool json = false;
};

void run(const Arguments& arguments) {
  const CaseCollection collection = collect_cases({arguments.folders.begin(), arguments.folders.end()});
  const Comparison comparison = compare_with_hertz(collection, arguments.tolerance);
  const std::string json = to_json(comparison).dump(1) + "\n", markdown = to_markdown(comparison);
  const fs::path output = arguments.output.empty() ? arguments.folders.front() : arguments.output;
  fs::create_directories(output);
  write_file_atomically(output / "comparison.json", json);
  write_file_atomically(output / "comparison.md", markdown);
  write_file_atomically(output / "comparison.csv", to_csv(comparison));
  std::cout << (arguments.json ? json : markdown) << std::flush;
}

}  // namespace

void add_compare_command(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("compare", "Compare solved cases with Hertz: where rough, yielding contact departs");
  command->add_option("DIR", arguments->folders, "Folders that solve or study wrote")->required()->check(CLI::ExistingDirectory);
  command->add_option("--tolerance", arguments->tolerance, "Departure that counts as one")->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_option("--output", arguments->output, "Folder for comparison.json, .csv and .md (default: the first DIR)");
  command->add_flag("--json", arguments->json, "Print JSON instead of tables");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace asperity
