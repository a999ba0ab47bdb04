#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <regex>
#include <string>
#include <thread>

#include "app/case_file.h"
#include "app/case_previews.h"
#include "app/mpi_session.h"
#include "app/number_check.h"
#include "app/solver_commands.h"
#include "app/study_plan.h"
#include "app/study_preview.h"
#include "app/study_runner.h"
#include "core/build_commit.h"
#include "core/error.h"
#include "fem/output/checkpoint.h"
#include "fem/preview_case.h"
#include "fem/solve_case.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct StudyArguments {
  std::string file, output, solver, only;
  std::vector<std::string> overrides;
  bool resume = false, overwrite = false, check = false, plan = false, gather = false, preview = false;
  int parallel = 0;
};

/// Chooses the cases whose names contain what a regular expression describes.
std::function<bool(const std::string&)> names_with(const std::string& expression, const Study& study) {
  std::regex wanted;
  try {
    wanted = std::regex(expression, std::regex::ECMAScript | std::regex::icase);
  } catch (const std::regex_error&) {
    throw InputError("--only '" + expression +
                     "' is not a regular expression; write part of a case's name, such as '" +
                     study.cases.front().name + "'");
  }
  const auto chosen = [wanted](const std::string& name) { return std::regex_search(name, wanted); };
  if (std::none_of(study.cases.begin(), study.cases.end(),
                   [&](const StudyCase& item) { return chosen(item.name); }))
    throw InputError("--only '" + expression + "' chooses none of the study's " +
                     std::to_string(study.cases.size()) + " cases; their names are like '" +
                     study.cases.front().name + "'");
  return chosen;
}

/// Before the first case is solved rather than when its turn comes: contacts and paths that the bodies have
/// no room for, scans that are too small.
void check_cases(const Study& study) {
  for (const StudyCase& item : study.cases) {
    try {
      const CaseInput input = case_from_settings(item.settings, study.file);
      naming_lines_of_scans(item.settings, input, [&] { check_case(input); });
    } catch (const InputError& error) {
      throw InputError(std::string(error.what()) + " (case " + item.name + ")");
    }
  }
}

/// The program that was called; this one may be its solver.
fs::path called_program() {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  return fs::exists(self.parent_path() / "asperity") ? self.parent_path() / "asperity" : self;
}

MeshPreview previewed_mesh(const StudyCase& item, const std::string& file) {
  return preview_mesh(case_from_settings(item.settings, file));
}

void plan_study(const Study& study, const StudyArguments& arguments) {
  const auto cost = [&](const StudyCase& item) {
    const MeshPreview mesh = previewed_mesh(item, study.file);
    return PlannedCase{"", mesh.seconds_on_one_core, mesh.memory};
  };
  const auto cases = prepare_planned_cases(study, arguments.output, cost);
  const StudyPlanOptions options{arguments.output, called_program(), arguments.overrides};
  for (const auto& line : write_study_plan(study, cases, options)) std::cout << line << std::endl;
}

void gather(const Study& study, const StudyArguments& arguments) {
  if (!fs::exists(fs::path(arguments.output) / "study.json"))
    throw InputError("'" + arguments.output + "' holds no study; --plan or a run of it makes one");
  const std::size_t solved = gather_study(study, arguments.output);
  std::cout << solved << " of " << study.cases.size()
            << " cases are solved; summary: " << (fs::path(arguments.output) / "study.csv").string()
            << std::endl;
}

void run_study(const StudyArguments& arguments) {
  Study study = read_study(arguments.file, arguments.overrides);
  std::function<bool(const std::string&)> chosen_name = [](const std::string&) { return true; };
  if (!arguments.only.empty()) chosen_name = names_with(arguments.only, study);
  Settings all_settings;
  for (const StudyCase& item : study.cases)
    all_settings.insert(all_settings.end(), item.settings.begin(), item.settings.end());
  warn_of_former_names(all_settings);
  check_cases(study);
  if (arguments.check) {
    std::cout << "all " << study.cases.size() << " cases of '" << arguments.file
              << "' are accepted; nothing was solved" << std::endl;
    return;
  }
  if (arguments.output.empty())
    throw InputError("study needs --output DIR, the folder for the results (or --check)");
  if (arguments.parallel > 0) study.parallel_cases = arguments.parallel;
  if (arguments.preview)
    return preview_study(
        study, {arguments.output, chosen_name, previews_of_cases(study), say, study.parallel_cases});
  if (arguments.plan) return plan_study(study, arguments);
  if (arguments.gather) return gather(study, arguments);
  StudyRunOptions options;
  options.output = arguments.output;
  options.resume = arguments.resume;
  options.cores = std::max(1u, std::thread::hardware_concurrency());
  options.program =
      arguments.solver.empty() ? fs::read_symlink("/proc/self/exe") : fs::absolute(arguments.solver);
  options.overwrite = arguments.overwrite;
  options.objection_to_resume = [](const fs::path& folder, const std::string& inputs) {
    return fem::objection_to_resume(folder / "checkpoint", {inputs, build_commit()});
  };
  options.say = say;
  options.chosen = chosen_name;
  options.expected_seconds = [&](const StudyCase& item) {
    return previewed_mesh(item, study.file).seconds_on_one_core;
  };
  const auto progress = run_study(study, options);

  const auto count = [&](CaseProgress::State state) {
    long number = 0;
    for (std::size_t i = 0; i < progress.size(); ++i)
      if (progress[i].state == state && options.chosen(study.cases[i].name)) ++number;
    return number;
  };
  const auto chosen = std::count_if(study.cases.begin(), study.cases.end(),
                                    [&](const StudyCase& item) { return options.chosen(item.name); });
  const auto done = count(CaseProgress::State::done), failed = count(CaseProgress::State::failed);
  const std::string all = std::to_string(chosen) + (arguments.only.empty() ? "" : " chosen");
  std::cout << done << " of " << all << " cases done; summary: " << (options.output / "study.csv").string()
            << std::endl;
  std::string again = "asperity study " + arguments.file + " --output " + arguments.output + " --resume" +
                      (arguments.only.empty() ? "" : " --only '" + arguments.only + "'");
  for (const auto& text : arguments.overrides) again += " --set '" + text + "'";
  if (done + failed < chosen) throw WorkError("the study was stopped; '" + again + "' goes on with it");
  if (failed > 0)
    throw WorkError(std::to_string(failed) + " of " + all +
                    " cases failed; solve.log in the folder of each says why, and '" + again +
                    "' tries them again");
}

}  // namespace

void add_study_command(CLI::App& app) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand(solver_commands::study.name, solver_commands::study.says);
  command->add_option("STUDY.prm", arguments->file, "Study file: a base case and what is varied")->required();
  command->add_option("--output", arguments->output, "Folder for the results, a folder in it for each case");
  command->add_flag(
      "--resume", arguments->resume,
      "Go on with an earlier run: complete cases are kept; refused if one of them is of other inputs");
  command->add_flag(
      "--overwrite", arguments->overwrite,
      "Go on, and solve complete cases of other inputs anew; what was there is kept in the folder 'earlier'");
  command
      ->add_option(
          "--set", arguments->overrides,
          "\"Section/Entry=value\": replaces an entry of every case, or the values of one that is varied")
      ->expected(1)
      ->take_all();
  command->add_flag("--check", arguments->check,
                    "Read all cases and their scans and refuse what would be refused before meshing; solve "
                    "and write nothing");
  command->add_option("--only", arguments->only,
                      "Solve only cases whose names contain this (regular expression); the others wait. "
                      "Machines may share a study: "
                      "bring the case folders together, and --resume collects them");
  const auto plan = command->add_flag(
      "--plan", arguments->plan,
      "Solve nothing: write each case with its cost, a Snakemake workflow and Slurm jobs into "
      "DIR/plan, for a cluster");
  command
      ->add_flag(
          "--preview", arguments->preview,
          "Solve each case's normal contact by half-spaces instead, in seconds, into DIR/previews, and "
          "write means over surfaces; what is solved in DIR corrects them")
      ->excludes(plan);
  command
      ->add_flag("--gather", arguments->gather,
                 "Solve nothing: collect what other machines solved in DIR into study.csv")
      ->excludes(plan);
  command
      ->add_option("--parallel", arguments->parallel,
                   "Cases at the same time (default: the study's, else one per core)")
      ->check(positive_number());
  command->add_option("--solver", arguments->solver, "Program called in place of this one")->group("");
  command->footer(std::string("A study file is a case file with one more subsection:\n\n") + study_example);
  command->callback([arguments] { run_study(*arguments); });
}

}  // namespace asperity
