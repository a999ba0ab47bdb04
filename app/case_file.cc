#include "app/case_file.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

#include "app/case_declaration.h"
#include "app/case_film.h"
#include "core/attraction_zone.h"
#include "core/error.h"
#include "core/experiment_declaration.h"
#include "core/motion_program.h"
#include "core/nearest_name.h"
#include "core/quantity.h"
#include "core/renamed_entries.h"
#include "core/written_apart.h"
#include "fem/interface/adhesion_law.h"
#include "fem/materials/material_law.h"
#include "surfaces/scan_spec.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

const CaseEntry* find_entry(const std::string& section, const std::string& name) {
  for (const auto& entry : case_entries())
    if (entry.section == section && entry.name == name) return &entry;
  return nullptr;
}

bool is_section(const std::string& name) {
  const auto& sections = case_sections();
  return std::any_of(sections.begin(), sections.end(), [&](const auto& s) { return s.name == name; });
}

std::string place(const std::string& section) {
  return section.empty() ? "outside of subsections" : "in subsection " + section;
}

/// "case.prm:12", or the file where the entry is not set.
std::string where_set(const Settings& settings, const std::string& path, const fs::path& file) {
  for (const auto& setting : settings)
    if (setting.path() == path) return setting.where;
  return file.string();
}

/// Settings by path, for the checks that concern several entries at once.
class Checker {
 public:
  Checker(const CaseInput& input, const Settings& settings, const fs::path& file)
      : input_(input), settings_(settings), file_(file) {}

  void check() const {
    check_load();
    check_program();
    check_mesh();
    check_material("Particle", input_.particle);
    check_material("Substrate", input_.substrate);
    check_seeds();
  }

 private:
  [[noreturn]] void refuse(const std::string& path, const std::string& sentence) const {
    throw InputError(where_set(settings_, path, file_) + ": " + sentence);
  }

  /// Radius of the contact of smooth elastic bodies.
  double hertz_radius() const { return std::sqrt(input_.radius * hertz_approach_of(input_)); }

  void check_program() const {
    const std::string objection = objection_to_program(input_.experiment);
    if (!objection.empty()) refuse("Experiment/Program", objection);
  }

  void check_load() const {
    const auto& experiment = input_.experiment;
    const bool by_force = experiment.control == ExperimentInput::Control::force;
    if (by_force && !(experiment.normal_load > 0))
      refuse("Experiment/Normal load",
             experiment.normal_approach > 0
                 ? "Experiment/Normal approach is given but Control is force; set Control = displacement"
                 : "Experiment/Normal load must be above 0 under control by force; set for example 1 mN");
    if (!by_force && !(experiment.normal_approach > 0))
      refuse(
          "Experiment/Normal approach",
          "Experiment/Normal approach must be above 0 under control by displacement; set for example 10 nm");
    if (!by_force && experiment.normal_load > 0)
      refuse("Experiment/Normal load",
             "Experiment/Normal load is given but Control is displacement; remove it or set Control = force");
    if (experiment.cycles > 1 && !experiment.unload)
      refuse("Experiment/Cycles", "Experiment/Cycles above 1 needs unloading; set Unload = true");
    const auto [contact, half] = quantities_apart(hertz_radius(), input_.radius / 2, Dimension::length);
    if (hertz_radius() > input_.radius / 2)
      refuse(by_force ? "Experiment/Normal load" : "Experiment/Normal approach",
             "this load would press the sphere flat over a contact radius of " + contact +
                 " (Hertz), more than half its radius, " + half +
                 "; small strain does not hold there: lower it");
  }

  void check_mesh() const {
    const auto& mesh = input_.mesh;
    if (mesh.contact_region > 0 && !(mesh.contact_region < input_.radius / 2))
      refuse("Mesh/Contact region",
             "Mesh/Contact region, " + format_quantity(mesh.contact_region, Dimension::length) +
                 ", must be less than half the Radius of " +
                 format_quantity(input_.radius, Dimension::length) + "; lower it, or 0 derives it");
    if (mesh.contact_region > 0 && mesh.contact_region < hertz_radius())
      refuse("Mesh/Contact region",
             "Mesh/Contact region, " +
                 quantities_apart(mesh.contact_region, hertz_radius(), Dimension::length).first +
                 ", does not hold the contact radius of " +
                 quantities_apart(mesh.contact_region, hertz_radius(), Dimension::length).second +
                 " (Hertz); raise it, or 0 derives it");
    double extent = mesh.contact_region > 0 ? mesh.contact_region : hertz_radius();
    const double load = input_.experiment.normal_load;
    if (mesh.interface_spacing > extent / 2 && mesh.contact_region == 0 && load > 0)  // attraction widens it
      extent = radius_least_by_attraction(hertz_of(input_).reduced_modulus, input_.radius,
                                          fem::work_of_adhesion(input_.interface).closing, load);
    if (mesh.interface_spacing > extent / 2)
      refuse("Mesh/Interface spacing",
             "Mesh/Interface spacing, " + format_quantity(mesh.interface_spacing, Dimension::length) +
                 ", leaves less than two cells in the " +
                 (mesh.contact_region > 0 ? "contact region" : "contact radius") + " of " +
                 format_quantity(extent, Dimension::length) + "; lower it, or 0 derives it");
  }

  void check_material(const std::string& section, const BodyInput& body) const {
    const fem::MaterialObjection objection = fem::objection_to(body);
    if (!objection.sentence.empty()) refuse(section + "/" + objection.entry, section + objection.sentence);
    if (const FilmObjection film = objection_to_film(section, body.film, input_.radius, settings_);
        !film.entry.empty())
      refuse(section + "/" + film.entry, film.sentence);
  }

  void check_seeds() const {
    const auto *on_particle = input_.particle.topography.generator(),
               *on_substrate = input_.substrate.topography.generator();
    if (on_particle && on_substrate && on_particle->seed == on_substrate->seed)
      refuse("Substrate/Topography",
             "both surfaces are generated with the same seed, so that their heights are correlated; give one "
             "another seed");
  }

  const CaseInput& input_;
  const Settings& settings_;
  const fs::path& file_;
};

/// The entry with its scan named in full, relative to the folder of the case file.
void find_scan(TopographySpec& topography, const std::string& section, const Settings& settings,
               const fs::path& file) {
  if (!topography.scan()) return;
  ScanParameters scan = *topography.scan();
  const fs::path beside = (file.parent_path() / scan.file).lexically_normal();
  if (fs::is_regular_file(beside)) {
    scan.file = beside.string();
    topography = scan;
    return;
  }
  const std::string meant =
      nearest_name(topography.text().substr(0, topography.text().find('(')), {"smooth", "generated"});
  throw InputError(where_set(settings, section + "/Topography", file) + ": " + section +
                   "/Topography: there is no file '" + beside.string() + "'" +
                   (meant.empty() ? "; write smooth, a file, or generated(rms=1.5 nm, rolloff=200 nm, seed=3)"
                    : meant == "smooth" ? "; did you mean smooth?"
                                        : "; did you mean generated(rms=1.5 nm, rolloff=200 nm, seed=3)?"));
}

/// Text of an entry: the last one given, or its default.
Setting setting_of(const CaseEntry& entry, const Settings& settings, const fs::path& file) {
  Setting setting{entry.section, entry.name, entry.default_text, file.string()};
  for (const auto& given : settings)
    if (given.section == entry.section && given.entry == entry.name) setting = given;
  return setting;
}

/// Of the entries that decide the answer, scans named in full.
void remember_physical_entries(const Settings& settings, const fs::path& file, CaseInput& input) {
  for (const auto& entry : case_entries())
    if (entry.is_physical) {
      const Setting setting = setting_of(entry, settings, file);
      if (!entry.counts_if_given || setting.value != entry.default_text)
        input.physical_entries[setting.path()] = setting.value;
    }
  for (const auto& [section, body] :
       {std::pair{"Particle/", &input.particle}, std::pair{"Substrate/", &input.substrate}})
    if (const auto* scan = body->topography.scan())
      input.physical_entries[std::string(section) + "Topography"] = with_absolute_file(*scan, {}).text();
  for (const auto& [path, text] : fem::work_entries_of_law(input.interface))
    input.physical_entries[path] = text;
  if (!input.experiment.declared.empty())
    input.physical_entries["Experiment/Program"] = input.experiment.program;
}

}  // namespace

ScanParameters with_absolute_file(ScanParameters scan, const fs::path& folder) {
  scan.file = fs::absolute(folder / scan.file).lexically_normal().string();
  return scan;
}

void naming_lines_of_scans(const Settings& settings, const CaseInput& input,
                           const std::function<void()>& work) {
  try {
    work();
  } catch (const ScanError& error) {
    const std::string path =
        std::string(error.spec == input.particle.topography.canonical() ? "Particle" : "Substrate") +
        "/Topography";
    throw InputError(where_set(settings, path, input.file) + ": " + path + ": " + error.what());
  }
}

void warn_of_former_names(const Settings& settings) {
  std::set<std::string> said;
  for (const auto& hint : hints_of_former_names(settings))
    if (said.insert(hint).second) std::cerr << "asperity: " << hint << std::endl;
}

void check_entry_exists(const Setting& setting) {
  if (find_entry(setting.section, setting.entry)) return;
  if (!is_section(setting.section)) {
    std::vector<std::string> names;
    for (const auto& section : case_sections()) names.push_back(section.name);
    const std::string meant = nearest_name(setting.section, names);
    throw InputError(
        setting.where + ": there is no subsection '" + setting.section + "'" +
        (meant.empty() ? "; `asperity case-reference` lists them" : "; did you mean '" + meant + "'?"));
  }
  std::vector<std::string> here;
  for (const auto& entry : case_entries())
    if (entry.section == setting.section) here.push_back(entry.name);
  const std::string meant = nearest_name(setting.entry, here);
  std::string remedy = "; did you mean '" + meant + "'?";
  if (meant.empty()) {
    remedy = "; `asperity case-reference` lists what there is";
    for (const auto& entry : case_entries())
      if (entry.name == setting.entry) remedy = "; it belongs " + place(entry.section);
  }
  throw InputError(setting.where + ": there is no entry '" + setting.entry + "' " + place(setting.section) +
                   remedy);
}

CaseInput case_from_settings(const Settings& settings, const fs::path& file) {
  CaseInput input;
  input.file = file.string();
  for (const auto& entry : case_entries())
    if (!entry.required()) entry.store(input, entry.default_text);
  for (const auto& setting : settings) {
    check_entry_exists(setting);
    try {
      find_entry(setting.section, setting.entry)->store(input, setting.value);
    } catch (const InputError& error) {
      throw InputError(setting.where + ": " + setting.path() + ": " + error.what());
    }
  }
  for (const auto& entry : case_entries()) {
    const bool given = std::any_of(settings.begin(), settings.end(), [&](const Setting& s) {
      return s.section == entry.section && s.entry == entry.name;
    });
    if (entry.required() && !given)
      throw InputError(file.string() + ": " + entry.section + "/" + entry.name + " is missing; add 'set " +
                       entry.name + " = " + entry.example + "' (with your value) to subsection " +
                       entry.section);
  }
  try {
    write_declared_program(input.experiment);
  } catch (const InputError& error) {
    throw InputError(where_set(settings, "Experiment/Type", file) + ": " + error.what());
  }
  find_scan(input.particle.topography, "Particle", settings, file);
  find_scan(input.substrate.topography, "Substrate", settings, file);
  Checker(input, settings, file).check();
  remember_physical_entries(settings, file, input);
  return input;
}

Settings complete_settings(const Settings& settings, const fs::path& file) {
  const CaseInput input = case_from_settings(settings, file);
  Settings complete;
  for (const auto& entry : case_entries()) {
    Setting setting = setting_of(entry, settings, file);
    if (entry.name == "Topography") {
      const TopographySpec& found =
          (entry.section == "Particle" ? input.particle : input.substrate).topography;
      if (found.scan()) setting.value = with_absolute_file(*found.scan(), {}).text();
    }
    complete.push_back(setting);
  }
  return complete;
}

CaseInput read_case(const fs::path& file, const std::vector<std::string>& overrides) {
  return case_from_settings(read_settings(file, overrides), file);
}

}  // namespace asperity
