#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <thread>

#include "app/finite_element_model.h"
#include "app/number_check.h"
#include "app/solver_commands.h"
#include "core/atomic_file.h"
#include "core/output_folder.h"
#include "diagnosis/challenge/challenge.h"
#include "diagnosis/diagnose.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct ChallengeArguments {
  std::string output, only;
  unsigned seed = 0;
  bool quick = false, by_case = false;
  int jobs = 0;
  double minutes = 30;
};

/// Changes with every build.
std::string program_mark() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  return std::to_string(fs::file_size(program)) + "-" +
         std::to_string(fs::last_write_time(program).time_since_epoch().count());
}

/// Diagnoses as `asperity diagnose --case` does, on as many cores as are left for each job.
Diagnosis diagnose_by_case(const Recording& recording, const FiniteElementModelOptions& how,
                           const fs::path& case_file, const std::vector<std::string>& entries) {
  FiniteElementModel model(case_file, entries, how);
  DiagnoseOptions options;
  options.simulation = &model;
  return diagnose(recording, options);
}

void run_challenge(const ChallengeArguments& arguments) {
  ChallengeOptions options;
  options.output = arguments.output;
  options.quick = arguments.quick;
  options.only = arguments.only;
  options.seed = arguments.seed;
  options.jobs = arguments.jobs > 0 ? arguments.jobs
                                    : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.program = program_mark() + "-" + std::to_string(arguments.seed);
  options.progress = [](const std::string& line) { std::cerr << line << std::endl; };
  if (arguments.by_case) {
    FiniteElementModelOptions how;
    how.solver = solver_program();
    let_threads_sleep();
    how.cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / options.jobs);
    how.seconds = 60 * arguments.minutes;
    how.say = [](const std::string&) {};
    options.diagnose_by_case = [how](const Recording& recording, const fs::path& case_file,
                                     const std::vector<std::string>& entries, const fs::path& folder) {
      FiniteElementModelOptions own = how;
      own.folder = folder;
      return diagnose_by_case(recording, own, case_file, entries);
    };
  }
  make_folder(options.output);
  const auto scores = run_challenge(options);
  const std::string text = challenge_text(scores);
  write_file_atomically(options.output / "challenge.md", text);
  write_file_atomically(options.output / "challenge.json", challenge_json(scores));
  std::cout << text << std::flush;
}

}  // namespace

void add_challenge_command(CLI::App& app) {
  const auto arguments = std::make_shared<ChallengeArguments>();
  CLI::App* command = app.add_subcommand(
      "challenge", "Conceal effects in some 200 recordings, diagnose them, and say what was found out");
  command
      ->add_option("--output", arguments->output,
                   "Folder for challenge.md, challenge.json and a folder for each recording; "
                   "recordings that this program has scored already are not diagnosed again")
      ->required();
  command->add_flag("--quick", arguments->quick, "One of most kinds, at the middle level of noise");
  command->add_flag(
      "--case", arguments->by_case,
      "The simulation of each recording is a case, solved by finite elements: another matrix, of "
      "some 60 recordings (--quick: a dozen), in hours");
  command
      ->add_option("--minutes", arguments->minutes,
                   "With --case: wall time for each recording's solutions of the case with what was left out")
      ->check(positive_number())
      ->capture_default_str();
  command->add_option("--only", arguments->only,
                      "Only recordings whose name holds this text: an effect, a family, a mode");
  command
      ->add_option("--seed", arguments->seed,
                   "Added to the seeds of all recordings: another matrix of the same kind")
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "Recordings side by side (default: one for each core)")
      ->check(positive_number());
  command->callback([arguments] { run_challenge(*arguments); });
}

}  // namespace asperity
