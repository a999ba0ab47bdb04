#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/case_file.h"
#include "app/case_previews.h"
#include "app/characterise_plan.h"
#include "app/characterise_request.h"
#include "app/commands.h"
#include "app/mpi_session.h"
#include "app/scanned_surface.h"
#include "app/solver_commands.h"
#include "app/study_folders.h"
#include "app/study_preview.h"
#include "app/study_runner.h"
#include "core/atomic_file.h"
#include "core/build_commit.h"
#include "core/error.h"
#include "core/joined.h"
#include "core/output_folder.h"
#include "core/quantity.h"
#include "dem_compare/characterise/characterisation.h"
#include "engines/engine_input.h"
#include "engines/many_particles/material_matrix.h"
#include "engines/many_particles/particle_box.h"
#include "fem/output/checkpoint.h"
#include "fem/preview_case.h"
#include "report/characterisation/characterisation_page.h"
#include "report/report.h"
#include "report/sentences/derivation_sentences.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// All that is known before the first case is solved.
struct Prepared {
  CharacteriseRequest request;
  CharacterisePlan plan;
  std::vector<std::string> sentences;
};

Prepared prepared(const CharacteriseArguments& arguments) {
  Prepared work;
  work.request = request_of(arguments);
  const auto engines = engine_input_names();
  if (std::find(engines.begin(), engines.end(), arguments.engine) == engines.end())
    throw InputError("there is no input for an engine '" + arguments.engine + "'; --engine is one of " +
                     joined(engines, ", "));
  const MeasuredScan substrate = measured_scan(work.request.substrate_scan);
  std::optional<MeasuredScan> particle;
  if (work.request.particle_scan) particle = measured_scan(*work.request.particle_scan);
  work.plan = plan_of(work.request, substrate, particle);
  const auto add = [&](const std::vector<std::string>& sentences) {
    work.sentences.insert(work.sentences.end(), sentences.begin(), sentences.end());
  };
  add(scan_sentences("substrate", substrate, work.request.surface, work.plan.cutoff));
  if (particle)
    add(scan_sentences("particle", *particle, work.request.surface, work.plan.cutoff));
  else
    add({"particle: no scan of it is given (a second file): it is taken as smooth"});
  add(plan_sentences(work.request, work.plan));
  return work;
}

/// Solves the study, or goes on with it. True if all cases are solved.
bool solve(const Study& study, const fs::path& folder, bool overwrite) {
  StudyRunOptions options;
  options.output = folder;
  options.resume = fs::exists(folder / "study.json");
  options.overwrite = overwrite;
  options.cores = std::max(1u, std::thread::hardware_concurrency());
  options.program = fs::read_symlink("/proc/self/exe");
  options.objection_to_resume = [](const fs::path& case_folder, const std::string& inputs) {
    return fem::objection_to_resume(case_folder / "checkpoint", {inputs, build_commit()});
  };
  options.expected_seconds = [&](const StudyCase& item) {
    return preview_mesh(case_from_settings(item.settings, study.file)).seconds_on_one_core;
  };
  options.say = say;
  const auto progress = run_study(study, options);
  bool failed = false;
  for (const auto& item : progress) {
    if (item.state != CaseProgress::State::done && item.state != CaseProgress::State::failed)
      throw WorkError("stopped; the same command goes on with what is solved");
    failed = failed || item.state == CaseProgress::State::failed;
  }
  return !failed;
}

/// Relative standard deviation of E*, the ranges of Young's moduli taken for two on either side.
double modulus_spread(const CharacteriseRequest& request) {
  const auto compliance = [](const Material& material) {
    return (1 - material.poisson_ratio * material.poisson_ratio) / material.youngs_modulus.value;
  };
  const double one = compliance(request.particle.material), other = compliance(request.substrate);
  return std::hypot(one * request.particle.material.youngs_modulus.relative_spread(),
                    other * request.substrate.youngs_modulus.relative_spread()) /
         (2 * (one + other));
}

/// What solved cases do not say of their bodies: the particle simulation moves masses.
void name_materials(ContactParameters& parameters, const CharacteriseRequest& request) {
  const auto name = [](ContactBody& body, const Material& material) {
    body.material = material.name;
    if (material.density > 0) body.density = material.density;
  };
  name(parameters.particle, request.particle.material);
  name(parameters.target, request.substrate);
}

/// A first run of many particles, where the engine's box is written and the particle's density is known.
void write_first_box(const ContactParameters& parameters, const std::string& engine, const fs::path& folder) {
  const WrittenEngine& written = written_engine_of(engine);
  if (!written.writes_boxes()) return;
  if (!(parameters.particle.density > 0)) {
    say("no box of particles is written: the particle's density is not known; name it, as in \"E=71 GPa, "
        "nu=0.17, "
        "density=2230 kg/m^3\"");
    return;
  }
  constexpr int particles = 1000;
  say(write_box(written, material_matrix({parameters}, {}), particles, folder));
}

/// parameters.json, the engine's input and a box of particles, of one set. Returns the files' names.
std::vector<std::string> write_set(Derivation& derivation, const std::string& suffix,
                                   const std::string& engine, const fs::path& output) {
  report::write_words(derivation);
  const std::string parameters = "parameters" + suffix + ".json", input = "contact" + suffix + "." + engine;
  write_contact_parameters(derivation.parameters, output / parameters);
  write_file_atomically(output / input, engine_input(engine, derivation.parameters));
  ContactParameters named = derivation.parameters;
  named.file = parameters;
  write_first_box(named, engine, output / ("box" + suffix));
  return {parameters, input};
}

void write_answer(const CharacteriseArguments& arguments, const Prepared& work, const Study& study,
                  const fs::path& solved_in) {
  const fs::path output = arguments.output;
  std::vector<fs::path> folders;
  const StudyFolders cases(study, solved_in);
  for (std::size_t i = 0; i < study.cases.size(); ++i)
    if (cases.has_result(i)) folders.push_back(cases.folder(i));
  if (folders.empty()) throw WorkError("no case was solved; solve.log in the folder of each says why");
  const ParameterSets found = collect_parameter_sets(folders);
  for (const auto& remark : found.remarks) say(remark);
  report::CharacterisationText text;
  text.title = arguments.particle + " on " + arguments.substrate;
  text.accuracy = work.request.accuracy;
  text.sentences = work.sentences;
  std::vector<Characterisation> tables;
  nlohmann::ordered_json json{{"format", "asperity-characterisation/1"}, {"title", text.title}, {"sets", {}}};
  const double spread = modulus_spread(work.request);
  // Each end of a bracket is a table of its own, which says for which coefficient it holds.
  const bool friction_is_said = work.request.friction_is_known || found.sets.size() > 1;
  for (const auto& set : found.sets) {
    Derivation derivation = derive_parameters(reduced_set(set));
    name_materials(derivation.parameters, work.request);
    const std::string friction = set.inputs.at("Interface/Friction coefficient");
    const std::string suffix = found.sets.size() > 1 ? "_friction_" + friction : "";
    const auto files = write_set(derivation, suffix, arguments.engine, output);
    text.files.insert(text.files.end(), files.begin(), files.end());
    tables.push_back(characterised(set, derivation, spread, friction_is_said));
    if (found.sets.size() > 1) tables.back().label = "local friction " + friction;
    json["sets"].push_back(to_json(tables.back()));
    say("\n" + report::characterisation_text(tables.back(), text.accuracy));
  }
  json["sentences"] = work.sentences;
  write_report(solved_in);
  text.files.push_back("study/report.html");
  write_file_atomically(output / "characterisation.json", json.dump(1) + "\n");
  write_file_atomically(output / "characterisation.html", report::characterisation_page(tables, text));
  say("wrote characterisation.html, characterisation.json, " + joined(text.files, ", ") + " to " +
      output.string());
}

/// Refuses to replace another plan, which somebody may have edited.
void write_study(const CharacterisePlan& plan, const fs::path& file, bool overwrite) {
  const std::string text = study_text(plan);
  if (fs::exists(file) && !overwrite && read_file(file) != text)
    throw InputError(file.string() +
                     " is another plan than that of these arguments; solve it by 'asperity study " +
                     file.string() + "', choose another --output, or pass --overwrite to replace it");
  write_file_atomically(file, text);
}

/// More surfaces by half-spaces, which `derive` takes along. Where they fail, what is solved still counts.
void preview_more_surfaces(const CharacterisePlan& plan, const fs::path& output) {
  const std::string text = preview_text(plan);
  if (text.empty()) return;
  write_file_atomically(output / "previews.prm", text);
  const Study study = read_study(output / "previews.prm");
  const auto every = [](const std::string&) { return true; };
  try {
    preview_study(study, {output / "study", every, previews_of_cases(study), say});
  } catch (const InputError& error) {
    say(std::string("no surfaces by half-spaces: ") + error.what());
  } catch (const WorkError& error) {
    say(std::string("no surfaces by half-spaces: ") + error.what());
  }
}

void run_characterise(const CharacteriseArguments& arguments) {
  const Prepared work = prepared(arguments);
  for (const auto& sentence : work.sentences) say(sentence);
  if (arguments.plan) return;
  if (arguments.output.empty()) throw InputError("characterise needs --output DIR (or --plan)");
  const fs::path output = arguments.output;
  make_folder(output);
  write_study(work.plan, output / "study.prm", arguments.overwrite);
  const Study study = read_study(output / "study.prm");
  const bool all_solved = solve(study, output / "study", arguments.overwrite);
  preview_more_surfaces(work.plan, output);
  write_answer(arguments, work, study, output / "study");
  if (!all_solved)
    throw WorkError(
        "some cases failed, and the numbers are without them; solve.log in their folders says why");
}

}  // namespace

void add_characterise_command(CLI::App& app) {
  const auto arguments = std::make_shared<CharacteriseArguments>();
  CLI::App* command =
      app.add_subcommand(solver_commands::characterise.name, solver_commands::characterise.says);
  command
      ->add_option("SCAN", arguments->scans, "Scan of the substrate, and one of the particle if there is one")
      ->required()
      ->expected(1, 2);
  command
      ->add_option("--particle", arguments->particle, "Material and radius, such as \"borosilicate, 8.5 um\"")
      ->required();
  command
      ->add_option("--substrate", arguments->substrate,
                   "Material (asperity materials), or \"E=71 GPa, nu=0.17, hardness=9 GPa\"")
      ->required();
  command->add_option("--loads", arguments->loads, "Normal loads, such as \"30 uN to 300 uN\"")->required();
  command->add_option("--engine", arguments->engine, joined(engine_input_names(), ", "))
      ->capture_default_str();
  command->add_option("--output", arguments->output, "Folder for the answer and the solved cases");
  command->add_option("--friction", arguments->friction,
                      "Local friction coefficient or its range (default: 0.1 to 0.5, both solved)");
  command->add_option(
      "--adhesion", arguments->adhesion,
      "Work of adhesion and range of attraction, such as \"77 mJ/m^2, 1 nm\" (default: none)");
  command->add_option("--time", arguments->time, "To spend on solving, on two cores")->capture_default_str();
  command->add_option("--accuracy", arguments->accuracy, "Asked for: half of a 95 % interval over the value")
      ->capture_default_str();
  command->add_flag("--quick", arguments->quick, "An order of magnitude in some two minutes");
  command
      ->add_option("--surface", arguments->surface,
                   "auto: realisations of the scan's spectrum where its heights are Gaussian, else the scan; "
                   "scan; spectrum")
      ->capture_default_str();
  command->add_option("--level", arguments->level, "mean, plane, quadratic, rows0, rows1 or rows2")
      ->capture_default_str();
  command->add_option("--size", arguments->size, "Physical width of the scans where their files lack it");
  command->add_option("--height-unit", arguments->height_unit,
                      "Unit of heights in text files that name none");
  command->add_option("--channel", arguments->channel, "Name or number of the channel (default: heights)");
  command->add_flag("--plan", arguments->plan, "Say what would be done and how long it takes; solve nothing");
  command->add_flag("--overwrite", arguments->overwrite, "Solve anew what is there of other inputs");
  command->footer(
      "Example: asperity characterise scan.spm --particle \"borosilicate, 8.5 um\" --substrate silicon "
      "--loads "
      "\"30 uN to 300 uN\" --engine lammps --output characterised\nThe same command goes on after an "
      "interruption.");
  command->callback([arguments] { run_characterise(*arguments); });
}

}  // namespace asperity
