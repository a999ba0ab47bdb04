#include "app/study_command.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <regex>
#include <string>
#include <thread>

#include "app/case_file.h"
#include "app/study_runner.h"
#include "core/error.h"
#include "fem/case_setup.h"
#include "fem/output/checkpoint.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct StudyArguments {
  std::string file, output, solver, only;
  bool resume = false;
  int parallel = 0;
};

/// Chooses the cases whose names contain what a regular expression describes.
std::function<bool(const std::string&)> names_with(const std::string& expression, const Study& study) {
  std::regex wanted;
  try {
    wanted = std::regex(expression, std::regex::ECMAScript | std::regex::icase);
  } catch (const std::regex_error&) {
    throw InputError("--only '" + expression + "' is not a regular expression; write part of a case's name, such as '" + study.cases.front().name + "'");
  }
  const auto chosen = [wanted](const std::string& name) { return std::regex_search(name, wanted); };
  if (std::none_of(study.cases.begin(), study.cases.end(), [&](const StudyCase& item) { return chosen(item.name); }))
    throw InputError("--only '" + expression + "' chooses none of the study's " + std::to_string(study.cases.size()) +
                     " cases; their names are like '" + study.cases.front().name + "'");
  return chosen;
}

/// Before the first case is solved rather than when its turn comes: contacts and ways that the bodies have no room for.
void check_extents(const Study& study) {
  for (const StudyCase& item : study.cases) {
    try {
      const CaseInput input = case_from_settings(item.settings, study.file);
      naming_lines_of_scans(item.settings, input, [&] { fem::check_extent(input); });
    } catch (const InputError& error) {
      throw InputError(std::string(error.what()) + " (case " + item.name + ")");
    }
  }
}

void run_study(const StudyArguments& arguments) {
  Study study = read_study(arguments.file);
  check_extents(study);
  if (arguments.parallel > 0) study.parallel_cases = arguments.parallel;
  StudyRunOptions options;
  options.output = arguments.output;
  options.resume = arguments.resume;
  options.cores = std::max(1u, std::thread::hardware_concurrency());
  options.program = arguments.solver.empty() ? fs::read_symlink("/proc/self/exe") : fs::absolute(arguments.solver);
  options.can_resume = [](const fs::path& folder) { return fem::is_of_this_version(folder / "checkpoint"); };
  options.say = [](const std::string& line) { std::cout << line << std::endl; };
  if (!arguments.only.empty()) options.chosen = names_with(arguments.only, study);
  const auto progress = run_study(study, options);

  const auto count = [&](CaseProgress::State state) {
    long number = 0;
    for (std::size_t i = 0; i < progress.size(); ++i)
      if (progress[i].state == state && options.chosen(study.cases[i].name)) ++number;
    return number;
  };
  const auto chosen = std::count_if(study.cases.begin(), study.cases.end(), [&](const StudyCase& item) { return options.chosen(item.name); });
  const auto done = count(CaseProgress::State::done), failed = count(CaseProgress::State::failed);
  const std::string all = std::to_string(chosen) + (arguments.only.empty() ? "" : " chosen");
  std::cout << done << " of " << all << " cases done; summary: " << (options.output / "study.csv").string() << std::endl;
  const std::string again = "asperity study " + arguments.file + " --output " + arguments.output + " --resume" +
                            (arguments.only.empty() ? "" : " --only '" + arguments.only + "'");
  if (done + failed < chosen)
    throw WorkError("the study was stopped; '" + again + "' goes on with it");
  if (failed > 0)
    throw WorkError(std::to_string(failed) + " of " + all + " cases failed; solve.log in the folder of each says why, and '" +
                    again + "' tries them again");
}

}  // namespace

void add_study_command(CLI::App& app) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand("study", "Solve a matrix of cases, several at a time");
  command->add_option("STUDY.prm", arguments->file, "Study file: a base case and what is varied")->required();
  command->add_option("--output", arguments->output, "Folder for the results, a folder in it for each case")->required();
  command->add_flag("--resume", arguments->resume, "Go on with an earlier run: complete cases are kept");
  command->add_option("--only", arguments->only,
                      "Solve only cases whose names contain this (regular expression); the others wait. Machines may share a study: "
                      "bring the case folders together, and --resume collects them");
  command->add_option("--parallel", arguments->parallel, "Cases at the same time (default: the study's, else one per core)")
      ->check(CLI::PositiveNumber);
  command->add_option("--solver", arguments->solver, "Program called in place of this one")->group("");
  command->footer(std::string("A study file is a case file with one more subsection:\n\n") + study_example);
  command->callback([arguments] { run_study(*arguments); });
}

}  // namespace asperity
