#include "app/commands.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/diagnosed_case.h"
#include "app/equations_option.h"
#include "app/finite_element_model.h"
#include "app/number_check.h"
#include "app/solver_commands.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "core/printed.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/simulated_file.h"
#include "report/diagnosis/diagnosis_page.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

struct DiagnoseArguments {
  std::string recording, output = "diagnosis", case_file, study;
  std::vector<std::string> overrides;
  double minutes = 30;
  bool json = false, catalogue = false, is_typeset = false;
};

std::string summary(const Diagnosis& d, const fs::path& output) {
  std::string text = name_of(d.verdict) + ": " + d.in_words + "\n";
  for (const auto& effect : d.left_out) {
    text += "  " + effect.id + " (" + (effect.kind == EffectKind::contact ? "contact" : "instrument") +
            "): " + effect.equation + "\n";
    for (const auto& p : effect.parameters)
      text += printed("    %s = %.4g %s (95 %%: %.4g to %.4g)\n", p.name.c_str(), p.value, p.unit.c_str(),
                      p.low, p.high);
  }
  for (const auto& a : d.alternatives) {
    std::string names;
    for (const auto& effect : a.effects) names += (names.empty() ? "" : " + ") + effect.id;
    const std::string how = d.left_out.empty() ? "not confirmed" : printed("probability %.2g", a.probability);
    text += "  or: " + names + " (" + how + "); " + a.told_apart_by + "\n";
  }
  if (d.simulation.by_finite_elements) {
    text += printed("  simulation: the case, %d solutions; %s (mesh, load steps)\n", d.simulation.solves,
                    d.simulation.off_by().c_str());
    for (const auto& e : d.corrected())
      text += "  corrected.prm: " + e.entry + " = " + e.written() + " (" + e.interval() + ")\n";
  }
  for (const auto& remark : d.remarks) text += "  note: " + remark + "\n";
  return text + "wrote " + (output / "diagnosis.json").string() + " and " +
         (output / "report.html").string() + "\n";
}

/// The case that is the simulation, and what was solved of it before.
struct CaseOfRecording {
  fs::path file;  ///< empty: reduced laws are the simulation
  std::vector<std::string> overrides;
  SolvedCases earlier;
};

/// As the command line says; where it says nothing of a case, as the recording does.
CaseOfRecording case_of(const DiagnoseArguments& arguments, const Recording& recording) {
  CaseOfRecording of{arguments.case_file, {}, {}};
  fs::path study = arguments.study;
  const SimulationChoice& given = recording.simulation;
  if (of.file.empty() && study.empty() && given.by_finite_elements()) {
    if (!given.case_file.empty()) of.file = recording.folder / given.case_file;
    if (!given.study.empty()) study = recording.folder / given.study;
    for (const auto& [entry, value] : given.case_entries) of.overrides.push_back(entry + "=" + value);
  }
  of.overrides.insert(of.overrides.end(), arguments.overrides.begin(), arguments.overrides.end());
  if (!study.empty()) {
    of.earlier = SolvedCases(study);
    if (of.file.empty()) of.file = of.earlier.the_contact(recording.mode);
  }
  if (of.file.empty() && !of.overrides.empty())
    throw InputError("--set is about a case of finite elements; name it with --case CASE.prm");
  return of;
}

void run_diagnose(const DiagnoseArguments& arguments) {
  if (arguments.catalogue) {
    std::cout << effects_manual(equations_of(arguments.is_typeset)) << std::flush;
    return;
  }
  if (arguments.recording.empty()) throw InputError("it needs a recording: a folder with recording.json");
  const Recording recording = read_recording(arguments.recording);
  DiagnoseOptions options;
  options.progress = [](const std::string& step) { std::fprintf(stderr, "%s\n", step.c_str()); };
  const fs::path output = arguments.output;
  const CaseOfRecording of = case_of(arguments, recording);
  std::unique_ptr<FiniteElementModel> model;
  if (!of.file.empty()) {
    FiniteElementModelOptions how;
    how.solver = solver_program();
    let_threads_sleep();
    how.folder = output / "solves";
    how.earlier = of.earlier;
    how.cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    how.seconds = 60 * arguments.minutes;
    how.say = options.progress;
    model = std::make_unique<FiniteElementModel>(of.file, of.overrides, how);
    options.simulation = model.get();
  }
  Diagnosis diagnosis = diagnose(recording, options);
  diagnosis.simulation.case_file = of.file.string();
  make_folder(output);
  write_diagnosed_case(model ? &model->settings() : nullptr, diagnosis, output);
  write_file_atomically(output / "before.csv", simulated_csv(recording, diagnosis, SimulatedState::before));
  write_file_atomically(output / "after.csv", simulated_csv(recording, diagnosis, SimulatedState::after));
  const std::string json = diagnosis_json(diagnosis);
  write_file_atomically(output / "diagnosis.json", json);
  write_file_atomically(output / "report.html", report::diagnosis_page(recording, diagnosis));
  std::cout << (arguments.json ? json : summary(diagnosis, output)) << std::flush;
}

}  // namespace

void add_diagnose_command(CLI::App& app) {
  const auto arguments = std::make_shared<DiagnoseArguments>();
  CLI::App* command = app.add_subcommand(
      "diagnose", "Locate where a recording and its simulation part, and name the physics that was left out");
  command->add_option("RECORDING", arguments->recording, "Folder with recording.json and its tables")
      ->check(CLI::ExistingPath);
  command->add_option("--output", arguments->output, "Folder for diagnosis.json and report.html")
      ->capture_default_str();
  command->add_option(
      "--case", arguments->case_file,
      "Case file that is the simulation in place of reduced laws: solved under the recording's "
      "loads, and again with what was left out (normal contact, sliding)");
  command
      ->add_option("--set", arguments->overrides,
                   "\"Section/Entry=value\": replaces an entry of the case file")
      ->expected(1)
      ->take_all();
  command->add_option("--study", arguments->study,
                      "Folder of solved cases, which are taken as they are; without --case their contact is "
                      "the simulation");
  command
      ->add_option(
          "--minutes", arguments->minutes,
          "Wall time for solutions of the case with what was left out; what is not solved by then is "
          "judged by what was")
      ->check(positive_number())
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print diagnosis.json instead of a summary");
  command->add_flag("--catalogue", arguments->catalogue, "Print the manual page of all effects instead");
  add_typeset(*command, arguments->is_typeset);
  command->footer(
      "Example: asperity diagnose runs/paper/recordings/sliding_offset_untreated --output output/diagnosis");
  command->callback([arguments] { run_diagnose(*arguments); });
}

}  // namespace asperity
