#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <thread>

#include "core/atomic_file.h"
#include "core/output_folder.h"
#include "diagnosis/challenge/challenge.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct ChallengeArguments {
  std::string output, only;
  unsigned seed = 0;
  bool quick = false;
  int jobs = 0;
};

/// Changes with every build.
std::string program_mark() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  return std::to_string(fs::file_size(program)) + "-" +
         std::to_string(fs::last_write_time(program).time_since_epoch().count());
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
  command->add_option("--only", arguments->only,
                      "Only recordings whose name holds this text: an effect, a family, a mode");
  command
      ->add_option("--seed", arguments->seed,
                   "Added to the seeds of all recordings: another matrix of the same kind")
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "Recordings side by side (default: one for each core)")
      ->check(CLI::PositiveNumber);
  command->callback([arguments] { run_challenge(*arguments); });
}

}  // namespace asperity
