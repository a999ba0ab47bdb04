#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/data_folder.h"
#include "core/output_folder.h"
#include "paper/analysis.h"
#include "report/paper/paper_files.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct PaperArguments {
  std::string data = data_folder("runs", ASPERITY_RUNS) / "paper/published", output, series;
  bool json = false;
};

void run_paper(const PaperArguments& arguments) {
  const Published published = read_published(arguments.data);
  const PaperAnalysis analysis =
      arguments.series.empty()
          ? analyse_paper(published)
          : PaperAnalysis{{series_section(published, read_friction_series(arguments.series))}, {}};
  const std::string text = report::paper_text(analysis), json = report::paper_json(analysis);
  if (!arguments.output.empty()) {
    const fs::path output = arguments.output;
    make_folder(output);
    write_file_atomically(output / "paper.txt", text);
    write_file_atomically(output / "paper.json", json);
    for (std::size_t i = 0; i < analysis.sections.size(); ++i)
      write_file_atomically(output / ("numbers_" + std::to_string(i + 1) + ".csv"),
                            report::paper_csv(analysis.sections[i]));
    for (const auto& curve : analysis.curves)
      write_file_atomically(output / (curve.name + ".csv"), format_csv(curve.columns, curve.values));
  }
  std::cout << (arguments.json ? json : text) << std::flush;
}

}  // namespace

void add_paper_command(CLI::App& app) {
  const auto arguments = std::make_shared<PaperArguments>();
  CLI::App* command = app.add_subcommand(
      "paper", "The paper's tables, fits and figures from its published numbers, with deviations in sigma");
  command->add_option("--output", arguments->output,
                      "Folder for paper.txt, paper.json, the numbers and each figure's curves as CSV");
  command->add_option("--data", arguments->data, "Folder of the published numbers")->capture_default_str();
  command->add_option("--series", arguments->series,
                      "Only fit this series (CSV: normal_force [uN], lateral_force [uN], lateral_force_sd "
                      "[uN]) as the paper does its own");
  command->add_flag("--json", arguments->json, "Print JSON instead of tables");
  command->callback([arguments] { run_paper(*arguments); });
}

}  // namespace asperity
