// asperity characterise as a person calls it: plans of scans whose spectrum is known, refusals, and from scan
// to engine in one command (nightly).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "app/materials.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/hertz.h"
#include "engines/parameters/contact_parameters.h"
#include "tests/app/called_program.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::TemporaryFolder;

std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// A Gaussian scan of 2.5 um, Hurst exponent 0.8, roll-off 500 nm.
std::string scan_in(const TemporaryFolder& folder) {
  const std::string file = (folder.path / "scan.gsf").string();
  const Outcome made = call(
      "surface generate --rms '1.5 nm' --size '2.5 um' --pixels 256 --hurst 0.8 --rolloff "
      "'500 nm' --cutoff '40 nm' --seed 5 --window --output " +
      file);
  EXPECT_EQ(made.status, 0) << made.output;
  return file;
}

std::string command(const std::string& scan, const std::string& more) {
  return "characterise " + scan +
         " --particle 'borosilicate, 8.5 um' --substrate silicon --loads '30 uN to 300 uN' " + more;
}

TEST(CharacteriseCommand_behaviour, says_before_it_solves_what_it_will_do_and_not_know) {
  const TemporaryFolder folder;
  const Outcome planned = call(command(scan_in(folder), "--plan --quick"));
  ASSERT_EQ(planned.status, 0) << planned.output;
  for (const char* said : {"drawn from the scan's spectrum", "cases by finite elements", "on two cores",
                           "local friction is not known", "pull-off force", "one realisation", "one load"})
    EXPECT_NE(planned.output.find(said), std::string::npos) << said << "\n" << planned.output;
}

TEST(CharacteriseCommand_behaviour, says_where_the_planned_cells_do_not_resolve_the_attraction) {
  const TemporaryFolder folder;
  const std::string scan = scan_in(folder), said = "acts in a zone of ", remedy = "; a range of ";
  const auto planned = [&](const std::string& range) {
    const Outcome plan = call(command(scan, "--plan --quick --adhesion '77 mJ/m^2, " + range + "'"));
    EXPECT_EQ(plan.status, 0) << plan.output;
    return plan.output;
  };
  EXPECT_EQ(planned("1 nm").find(said), std::string::npos);
  const std::string text = planned("0.1 nm");
  // pi E* h0^2 / (4 w), E* 52.87 GPa.
  EXPECT_NE(text.find(said + "5.39 nm"), std::string::npos) << text;
  const std::size_t begin = text.find(remedy) + remedy.size();
  EXPECT_EQ(
      planned(std::to_string(1.05 * std::stod(text.substr(begin))) + text.substr(text.find(' ', begin), 3))
          .find(said),
      std::string::npos)
      << text;
}

/// Three cells over the radius of a sphere that is drawn on by 2 pi w R more than its load (Derjaguin, Muller
/// & Toporov 1975): 79 nm, where Hertz' contact has 11.
TEST(CharacteriseCommand_analytic, counts_its_cells_over_the_contact_that_attraction_makes) {
  const TemporaryFolder folder;
  const Outcome planned =
      call("characterise " + scan_in(folder) +
           " --particle 'borosilicate, 8.5 um' --substrate silicon --loads '10 nN' --plan --quick --adhesion "
           "'77 mJ/m^2, 1 nm'");
  ASSERT_EQ(planned.status, 0) << planned.output;
  const double modulus = reduced_modulus({71e9, 0.17}, {179e9, 0.25}),
               force = 10e-9 + 2 * std::acos(-1) * 77e-3 * 8.5e-6,
               radius = std::cbrt(0.75 * 8.5e-6 * force / modulus);
  const std::string said = "nodes every ";
  const std::size_t at = planned.output.find(said);
  ASSERT_NE(at, std::string::npos) << planned.output;
  EXPECT_NEAR(std::stod(planned.output.substr(at + said.size())) / (1e9 * radius / 3), 1, 0.01)
      << planned.output;
}

TEST(CharacteriseCommand_behaviour,
     more_time_buys_more_loads_and_realisations_and_known_friction_fewer_cases) {
  const TemporaryFolder folder;
  const std::string scan = scan_in(folder);
  const auto cases = [&](const std::string& more) {
    const Outcome planned = call(command(scan, "--plan " + more));
    EXPECT_EQ(planned.status, 0) << planned.output;
    const std::size_t at = planned.output.find(" cases by finite elements");
    const std::size_t begin = planned.output.rfind('\n', at);
    return std::stoi(planned.output.substr(begin + 1, at - begin - 1));
  };
  const int least = cases("--friction 0.3 --time '1 s'"), usual = cases("--friction 0.3 --time '1 h'"),
            bracketed = cases("--time '1 s'");
  EXPECT_EQ(least, 4);
  EXPECT_EQ(bracketed, 7);  // normal load once, the three motions at both ends
  EXPECT_GE(usual, 3 * least);
}

TEST(CharacteriseCommand_behaviour, time_that_is_left_goes_into_surfaces_that_roll_and_then_are_pressed) {
  const TemporaryFolder folder;
  const std::string scan = scan_in(folder);
  const std::regex said(
      "(\\d+) cases by finite elements.*; (\\d) loads, (\\d) realisations \\((\\d+) that roll, (\\d+) under");
  int rolled = 0;
  for (const int minutes : {10, 20, 30, 40}) {
    const Outcome planned =
        call(command(scan, "--plan --friction 0.3 --time '" + std::to_string(minutes) + " min'"));
    std::smatch found;
    if (!std::regex_search(planned.output, found, said)) continue;
    const auto number = [&](std::size_t k) { return std::stoi(found[k]); };
    const int more = number(4) - number(3) + number(5) - number(3);  // normal, sliding, rolling, torsion
    EXPECT_EQ(number(1), number(2) * (4 * number(3) + more)) << planned.output;
    rolled = std::max(rolled, number(4));
  }
  EXPECT_GT(rolled, 0) << "no plan has time for more surfaces that roll";
  EXPECT_LE(rolled, 6);
}

TEST(CharacteriseCommand_behaviour, refuses_what_cannot_be_meant_with_status_2_and_the_remedy) {
  const TemporaryFolder folder;
  const std::string scan = scan_in(folder), bodies = " --particle 'borosilicate, 8.5 um' --substrate ";
  const auto refused = [&](const std::string& arguments, const std::string& remedy) {
    const Outcome outcome = call("characterise " + arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_NE(outcome.output.find(remedy), std::string::npos) << outcome.output;
  };
  refused(scan + bodies + "silicium --loads '30 uN'", "did you mean 'silicon'");
  refused(scan + bodies + "silicon --loads '300 uN to 30 uN'", "rising range");
  refused(scan + " --particle borosilicate --substrate silicon --loads '30 uN'", "radius");
  refused(scan + bodies + "'E=70 GPa, nu=0.6' --loads '30 uN'", "0 to 0.5");
  refused(scan + bodies + "silicon --loads '30 uN' --adhesion '77 mJ/m^2'", "1 nm");
  refused(scan + bodies + "silicon --loads '30 uN' --engine lamps", "lammps");
  refused(scan + bodies + "silicon --loads '30 uN'", "--output");
  refused(quoted((folder.path / "none.spm").string()) + bodies + "silicon --loads '30 uN' --plan",
          "none.spm");
}

TEST(Materials_behaviour, are_named_or_given_by_their_numbers_and_stand_in_the_docs) {
  const ParticleText particle = particle_of("E=71 GPa, nu=0.17, hardness=9 GPa, R=8.5 um");
  EXPECT_DOUBLE_EQ(particle.radius, 8.5e-6);
  EXPECT_DOUBLE_EQ(particle.material.youngs_modulus.value, 71e9);
  EXPECT_DOUBLE_EQ(particle.material.yield_stress(), 3e9);  // Tabor: a third of the hardness
  EXPECT_FALSE(material_of("E=71 GPa, nu=0.17").yields());
  EXPECT_DOUBLE_EQ(material_of("E=71 GPa, nu=0.17, density=2230 kg/m^3").density, 2230);
  EXPECT_DOUBLE_EQ(material_of("density=2230, E=71 GPa, nu=0.17").density, 2230);
  EXPECT_EQ(material_of("E=71 GPa, nu=0.17").density, 0);
  EXPECT_THROW(material_of("E=71 GPa, nu=0.17, density=-1"), InputError);
  EXPECT_THROW(material_of("E=71 GPa"), InputError);
  EXPECT_THROW(material_of("E=71 GPa, nu=0.17, E=1 GPa"), InputError);
  EXPECT_THROW(particle_of("silicon, -1 um"), InputError);
  for (const auto& material : named_materials()) {
    EXPECT_LE(material.youngs_modulus.low, material.youngs_modulus.value) << material.name;
    EXPECT_GE(material.youngs_modulus.high, material.youngs_modulus.value) << material.name;
    EXPECT_LE(material.hardness.low, material.hardness.value) << material.name;
    EXPECT_GE(material.hardness.high, material.hardness.value) << material.name;
    EXPECT_GT(material.density, 1000) << material.name;
    EXPECT_LT(material.density, 20000) << material.name;
    EXPECT_FALSE(material.source.empty()) << material.name;
  }
  EXPECT_EQ(read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/materials.md"), materials_page());
}

// The friction that went in is what comes out where nothing yields much; stiffnesses are Hertz' and Mindlin's
// within what roughness takes.
TEST(NightlyCharacterise_analytic, goes_from_a_scan_to_numbers_an_engine_and_a_page_in_one_command) {
  const TemporaryFolder folder;
  const std::string scan = scan_in(folder), output = (folder.path / "out").string();
  const std::string line = command(scan, "--quick --friction 0.3 --engine lammps --output " + output);
  const Outcome done = call(line);
  ASSERT_EQ(done.status, 0) << done.output;
  const ContactParameters parameters = read_contact_parameters(output + "/parameters.json");
  EXPECT_NEAR(parameters.sliding_friction->value, 0.3, 0.01);
  EXPECT_EQ(parameters.particle.material, "borosilicate");
  EXPECT_NEAR(parameters.particle_mass(), 4.0 / 3 * std::acos(-1) * std::pow(8.5e-6, 3) * 2230, 1e-18);
  // An engine runs with it as it is.
  const Outcome slid =
      call("engine " + output + "/parameters.json --engine lammps --experiment glued --output " + output +
           "/engine");
  EXPECT_EQ(slid.status, 0) << slid.output;
  // And a box of particles, which it has written beside it.
  EXPECT_EQ(std::system(("cd " + output + "/box && lmp -in in.box > log 2>&1").c_str()), 0);
  EXPECT_GT(read_file(output + "/box/energy.csv").size(), 1000U);
  const Hertz smooth{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  const double load = std::sqrt(30e-6 * 300e-6);
  EXPECT_NEAR(parameters.normal_stiffness_at(load) / smooth.normal_stiffness(load), 1, 0.25);
  EXPECT_NE(read_file(output + "/contact.lammps").find("pair_style"), 0U);
  EXPECT_NE(read_file(output + "/characterisation.html").find("95 % interval"), std::string::npos);
  const auto json = nlohmann::json::parse(read_file(output + "/characterisation.json"));
  EXPECT_EQ(json["format"], "asperity-characterisation/1");
  EXPECT_EQ(json["sets"].size(), 1U);
  // Again: nothing is solved anew.
  const Outcome again = call(line);
  EXPECT_EQ(again.status, 0) << again.output;
  EXPECT_EQ(again.output.find(": started"), std::string::npos) << again.output;
}

}  // namespace
}  // namespace asperity
