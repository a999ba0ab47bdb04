#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/case_file.h"
#include "app/case_previews.h"
#include "app/mpi_session.h"
#include "app/solver_commands.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "core/quantity.h"
#include "fem/preview_case.h"
#include "report/preview/preview_report.h"

namespace asperity {
namespace {

struct PreviewArguments {
  std::string file, output, hardness;
  std::vector<std::string> overrides;
};

/// Says how far a separation has come where it takes long.
half_space::OnSeparation said_from_time_to_time() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds between{5};
  return [last = Clock::now(), between](double approach, double force) mutable {
    if (Clock::now() - last < between) return;
    last = Clock::now();
    say("separating: approach " + format_quantity(approach, Dimension::length) + ", force " +
        format_quantity(force, Dimension::force));
  };
}

void run_preview(const PreviewArguments& arguments) {
  double hardness = 0;
  if (!arguments.hardness.empty()) {
    hardness = parse_quantity(arguments.hardness, Dimension::pressure);
    if (!(hardness > 0)) throw InputError("--hardness must be above 0, such as \"9 GPa\"");
  }
  const Settings settings = read_settings(arguments.file, arguments.overrides);
  const CaseInput input = case_from_settings(settings, arguments.file);
  naming_lines_of_scans(settings, input, [&] {
    const PreviewedCase preview = preview_case(input, hardness, said_from_time_to_time());
    for (const auto& line : report::preview_lines(input, preview)) say(line);
    if (arguments.output.empty()) return;
    const std::filesystem::path folder = arguments.output;
    make_folder(folder);
    write_file_atomically(folder / "preview.json", report::preview_json(input, preview));
    write_file_atomically(folder / "pressure.svg", report::pressure_picture(preview.contact.fine));
    if (preview.contact.capped)
      write_file_atomically(folder / "pressure_capped.svg",
                            report::pressure_picture(*preview.contact.capped));
    say("wrote preview.json and pictures of the pressure to " + folder.string());
  });
}

}  // namespace

std::function<std::string(const StudyCase&)> previews_of_cases(const Study& study) {
  return [&study](const StudyCase& item) {
    const CaseInput input = case_from_settings(item.settings, study.file);
    std::string preview;
    naming_lines_of_scans(item.settings, input,
                          [&] { preview = report::preview_json(input, preview_case(input, 0)); });
    return preview;
  };
}

void add_preview_command(CLI::App& app) {
  const auto arguments = std::make_shared<PreviewArguments>();
  CLI::App* command = app.add_subcommand(solver_commands::preview.name, solver_commands::preview.says);
  command->add_option("CASE.prm", arguments->file, "Case file (asperity case-template prints one)")
      ->required();
  command->add_option("--output", arguments->output, "Folder for preview.json and pictures of the pressure");
  command->add_option("--hardness", arguments->hardness,
                      "Largest pressure of bodies that yield, such as \"9 GPa\" (default: three times the "
                      "lower yield stress)");
  command
      ->add_option("--set", arguments->overrides,
                   "\"Section/Entry=value\": replaces an entry of the case file")
      ->expected(1)
      ->take_all();
  command->footer(
      "Elastic half-spaces with the case's surfaces, attraction and friction: pressed, separated, stuck "
      "together "
      "and shifted; without rolling, and without what shear does to the gap.");
  command->callback([arguments] { run_preview(*arguments); });
}

}  // namespace asperity
