#include "app/case_file.h"

#include <cmath>

#include "app/case_declaration.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;
using test::smooth_case;
using test::TemporaryFolder;

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

/// The accepted case with one piece of text replaced.
std::string refusal(const std::string& replaced, const std::string& by,
                    const std::vector<std::string>& overrides = {}) {
  const TemporaryFolder folder;
  std::string text = smooth_case();
  const auto at = text.find(replaced);
  EXPECT_NE(at, std::string::npos);
  text.replace(at, replaced.size(), by);
  const auto file = folder.write("case.prm", text);
  return message_of<InputError>([&] { read_case(file, overrides); });
}

std::string refusal_of_override(const std::vector<std::string>& overrides) {
  return refusal("set", "set", overrides);
}

}  // namespace

TEST(CaseFile_analytic, is_read_into_SI_units) {
  const TemporaryFolder folder;
  const auto input = read_case(folder.write("case.prm", smooth_case()));
  EXPECT_DOUBLE_EQ(input.radius, 8.5e-6);
  EXPECT_DOUBLE_EQ(input.particle.youngs_modulus, 71e9);
  EXPECT_DOUBLE_EQ(input.particle.poisson_ratio, 0.17);
  EXPECT_DOUBLE_EQ(input.substrate.youngs_modulus, 179e9);
  EXPECT_DOUBLE_EQ(input.experiment.normal_load, 1e-3);
}

TEST(CaseFile_behaviour, has_the_defaults_of_the_type_it_is_read_into) {
  const TemporaryFolder folder;
  const auto input = read_case(folder.write("case.prm", smooth_case()));
  const CaseInput fresh;
  EXPECT_TRUE(std::isinf(input.particle.parameters.at("Yield stress")));
  EXPECT_EQ(input.title, fresh.title);
  EXPECT_EQ(input.particle.topography.text(), fresh.particle.topography.text());
  EXPECT_EQ(input.experiment.load_steps, fresh.experiment.load_steps);
  EXPECT_EQ(input.experiment.unload, fresh.experiment.unload);
  EXPECT_EQ(input.experiment.cycles, fresh.experiment.cycles);
  EXPECT_EQ(input.mesh.layers, fresh.mesh.layers);
  EXPECT_EQ(input.solver.backend, fresh.solver.backend);
  EXPECT_EQ(input.solver.tolerance, fresh.solver.tolerance);
  EXPECT_EQ(input.output.fields, fresh.output.fields);
}

TEST(CaseFile_behaviour, overrides_replace_entries_and_add_them) {
  const TemporaryFolder folder;
  const auto input = read_case(
      folder.write("case.prm", smooth_case()),
      {"Experiment/Normal load=300 uN", "Particle/Yield stress=3 GPa", "Particle/Hardening=kinematic"});
  EXPECT_DOUBLE_EQ(input.experiment.normal_load, 3e-4);
  EXPECT_DOUBLE_EQ(input.particle.parameters.at("Yield stress"), 3e9);
  EXPECT_EQ(input.particle.parameters.at("Hardening"), 1);
}

TEST(CaseFile_behaviour, a_wrong_name_is_refused_with_its_line_and_the_nearest_right_one) {
  const std::string wrong_entry = refusal("set Radius", "set Radus");
  EXPECT_CONTAINS(wrong_entry, "case.prm:2:");
  EXPECT_CONTAINS(wrong_entry, "did you mean 'Radius'?");
  EXPECT_CONTAINS(refusal("set Young modulus", "set Youngs modulus"), "case.prm:3:");
  EXPECT_CONTAINS(refusal("set Young modulus", "set Youngs modulus"), "did you mean 'Young modulus'?");
  EXPECT_CONTAINS(refusal("subsection Substrate", "subsection Substrat"), "did you mean 'Substrate'?");
  EXPECT_CONTAINS(refusal("set Normal load", "set Friction coefficient = 1\n set Normal load"),
                  "it belongs in subsection Interface");
  EXPECT_CONTAINS(refusal_of_override({"Experiment/Normal laod=1 mN"}), "did you mean 'Normal load'?");
  EXPECT_CONTAINS(refusal_of_override({"Experiment/Normal laod=1 mN"}),
                  "--set \"Experiment/Normal laod=1 mN\"");
}

TEST(CaseFile_behaviour, a_wrong_unit_or_value_is_refused_with_its_line) {
  const std::string unit = refusal("8.5 um", "8.5 GPa");
  EXPECT_CONTAINS(unit, "case.prm:2: Particle/Radius:");
  EXPECT_CONTAINS(unit, "um");
  EXPECT_CONTAINS(refusal("0.17", "0.5"), "case.prm:4: Particle/Poisson ratio: '0.5' is not admissible");
  EXPECT_CONTAINS(refusal("71 GPa", "-71 GPa"), "case.prm:3:");
  EXPECT_CONTAINS(refusal("71 GPa", "inf"), "above 0");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Hardening=isotrop"}), "did you mean 'isotropic'?");
  EXPECT_CONTAINS(refusal_of_override({"Experiment/Load steps=2.5"}), "whole number");
  EXPECT_CONTAINS(refusal_of_override({"Experiment/Unload=yes"}), "true | false");
}

TEST(CaseFile_behaviour, a_missing_entry_is_named_with_an_example) {
  EXPECT_CONTAINS(refusal("  set Radius = 8.5 um\n", ""),
                  "Particle/Radius is missing; add 'set Radius = 8.5 um'");
}

TEST(CaseFile_behaviour, what_contradicts_physics_is_refused_in_a_sentence) {
  EXPECT_CONTAINS(refusal("1 mN", "0 N"), "case.prm:11: Experiment/Normal load must be above 0");
  EXPECT_CONTAINS(refusal("1 mN", "10 N"), "more than half its radius");
  EXPECT_CONTAINS(refusal_of_override({"Experiment/Control=displacement"}),
                  "Normal approach must be above 0");
  EXPECT_CONTAINS(refusal_of_override({"Experiment/Cycles=2", "Experiment/Unload=false"}),
                  "set Unload = true");
  EXPECT_CONTAINS(refusal_of_override({"Mesh/Contact region=5 um"}), "less than half the Radius");
  // Hertz: a(1 mN) = 0.494 um for borosilicate on silicon.
  EXPECT_CONTAINS(refusal_of_override({"Mesh/Contact region=0.4 um"}), "contact radius of 494 nm");
  EXPECT_CONTAINS(refusal_of_override({"Mesh/Interface spacing=0.4 um"}), "less than two cells");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Voce rate=3"}), "set both or neither");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Relaxing share=0.3"}), "set both or neither");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Topography=generated(rms=1 nm, seed=4)",
                                       "Substrate/Topography=generated(rms=2 nm, seed=4)"}),
                  "another seed");
}

TEST(CaseFile_behaviour, a_topography_that_cannot_be_meant_is_refused) {
  EXPECT_CONTAINS(refusal_of_override({"Particle/Topography=smoth"}), "did you mean smooth?");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Topography=scan.gsf"}), "there is no file");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Topography=generatd(rms=1 nm)"}), "did you mean generated(");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Topography=generated(rms=1 GPa)"}), "GPa");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Topography=generated(hurst=0.8)"}), "rms");
  EXPECT_CONTAINS(refusal_of_override({"Particle/Topography=generated(rms=1 nm, rollof=2 nm)"}), "rollof");
}

TEST(CaseFile_behaviour, a_scan_is_looked_for_beside_the_case_file) {
  const TemporaryFolder folder;
  folder.write("scan.gsf", "x");
  const auto file = folder.write("case.prm", smooth_case());
  EXPECT_EQ(read_case(file, {"Substrate/Topography=scan.gsf"}).substrate.topography.text(),
            (folder.path / "scan.gsf").string());
}

TEST(CaseFile_behaviour, completed_it_says_the_same_from_any_folder) {
  const TemporaryFolder folder;
  folder.write("cases/scan.gsf", "x");
  const auto file = folder.write("cases/case.prm", smooth_case() + "subsection Mesh\n set Layers = 6\nend\n");
  Settings settings = read_settings(file);
  override_setting(settings, parse_override("Substrate/Topography=scan.gsf"));
  const Settings complete = complete_settings(settings, file);
  EXPECT_EQ(complete.size(), case_entries().size());
  const auto again = read_case(folder.write("elsewhere/case.prm", format_settings(complete)));
  EXPECT_EQ(again.substrate.topography.text(), (folder.path / "cases/scan.gsf").string());
  EXPECT_DOUBLE_EQ(again.radius, 8.5e-6);
  EXPECT_EQ(again.mesh.layers, 6);
  EXPECT_EQ(again.title, "");
}

TEST(CaseFile_behaviour, the_template_is_a_case_file_and_holds_the_defaults) {
  const TemporaryFolder folder;
  const auto settings = read_settings(folder.write("case.prm", case_template()));
  const auto& entries = case_entries();
  ASSERT_EQ(settings.size(), entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(settings[i].section, entries[i].section);
    EXPECT_EQ(settings[i].entry, entries[i].name);
    EXPECT_EQ(settings[i].value, entries[i].example.empty() ? entries[i].default_text : entries[i].example);
  }
  EXPECT_DOUBLE_EQ(case_from_settings(settings, "case.prm").radius, 8.5e-6);
}

TEST(CaseFile_behaviour, the_manual_in_the_repository_is_the_one_the_program_prints) {
  EXPECT_EQ(read_file(ASPERITY_SOURCE_DIR "/docs/case_reference.md"), case_reference(Equations::typeset))
      << "run: asperity case-reference --typeset > docs/case_reference.md";
}

TEST(NearestName_behaviour, counts_a_swap_of_neighbours_as_one_edit) {
  EXPECT_EQ(edit_distance("load", "laod"), 1);
  EXPECT_EQ(edit_distance("Radius", "radius"), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(nearest_name("Hardning", {"Hardening", "Radius"}), "Hardening");
  EXPECT_EQ(nearest_name("xyz", {"Hardening", "Radius"}), "");
}

TEST(CaseFile_behaviour, a_film_is_read_with_all_that_it_needs_and_refused_without) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const std::vector<std::string> film{"Substrate/Film thickness=5 nm", "Substrate/Film Young modulus=70 GPa",
                                      "Substrate/Film Poisson ratio=0.17",
                                      "Substrate/Film yield stress=2 GPa"};
  const CaseInput input = read_case(file, film);
  EXPECT_FALSE(input.particle.film.is_there());
  EXPECT_DOUBLE_EQ(input.substrate.film.thickness, 5e-9);
  EXPECT_DOUBLE_EQ(input.substrate.film.youngs_modulus, 70e9);
  EXPECT_DOUBLE_EQ(input.substrate.film.poisson_ratio, 0.17);
  EXPECT_DOUBLE_EQ(input.substrate.film.yield_stress, 2e9);
  EXPECT_EQ(input.physical_entries.at("Substrate/Film thickness"), "5 nm");
  // A case without films is of the same contact as before there were any.
  EXPECT_EQ(read_case(file).physical_entries.count("Substrate/Film thickness"), 0u);
  EXPECT_CONTAINS(refusal_of_override({film[0], film[2]}),
                  "Substrate/Film thickness is given and Film Young modulus is not; give it");
  EXPECT_CONTAINS(refusal_of_override({film[0], film[1]}), "and Film Poisson ratio is not; give it");
  EXPECT_CONTAINS(refusal_of_override({"Substrate/Film thickness=5 um", film[1], film[2]}),
                  "Film thickness of 5 um is more than half the Radius, 4.25 um");
  EXPECT_CONTAINS(refusal_of_override({film[1]}),
                  "Substrate/Film Young modulus is given and Film thickness is not; give it");
  EXPECT_CONTAINS(refusal_of_override({film[0], "Substrate/Film Young modulus=0 Pa", film[2]}), "above 0");
}

}  // namespace asperity
