#include "app/study_command.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <thread>

#include "app/study_runner.h"
#include "core/error.h"
#include "fem/output/checkpoint.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct StudyArguments {
  std::string file, output, solver;
  bool resume = false;
  int parallel = 0;
};

void run_study(const StudyArguments& arguments) {
  Study study = read_study(arguments.file);
  if (arguments.parallel > 0) study.parallel_cases = arguments.parallel;
  StudyRunOptions options;
  options.output = arguments.output;
  options.resume = arguments.resume;
  options.cores = std::max(1u, std::thread::hardware_concurrency());
  options.program = arguments.solver.empty() ? fs::read_symlink("/proc/self/exe") : fs::absolute(arguments.solver);
  options.can_resume = [](const fs::path& folder) { return fem::is_of_this_version(folder / "checkpoint"); };
  options.say = [](const std::string& line) { std::cout << line << std::endl; };
  const auto progress = run_study(study, options);

  const auto count = [&](CaseProgress::State state) {
    return std::count_if(progress.begin(), progress.end(), [&](const auto& p) { return p.state == state; });
  };
  const auto done = count(CaseProgress::State::done), failed = count(CaseProgress::State::failed);
  const std::string all = std::to_string(progress.size());
  std::cout << done << " of " << all << " cases done; summary: " << (options.output / "study.csv").string() << std::endl;
  const std::string again = "asperity study " + arguments.file + " --output " + arguments.output + " --resume";
  if (done + failed < static_cast<long>(progress.size()))
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
  command->add_option("--parallel", arguments->parallel, "Cases at the same time (default: the study's, else one per core)")
      ->check(CLI::PositiveNumber);
  command->add_option("--solver", arguments->solver, "Program called in place of this one")->group("");
  command->footer(std::string("A study file is a case file with one more subsection:\n\n") + study_example);
  command->callback([arguments] { run_study(*arguments); });
}

}  // namespace asperity
