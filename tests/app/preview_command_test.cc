// asperity preview as a person calls it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/hertz.h"
#include "core/shear_moduli.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::smooth_case;
using test::TemporaryFolder;

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Preview_analytic, of_smooth_bodies_says_what_Hertz_says_and_writes_it) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "preview";
  const Outcome outcome = call("preview " + file.string() + " --output " + output.string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_CONTAINS(outcome.output, "real contact area");
  EXPECT_CONTAINS(outcome.output, "unknowns");
  const auto said = nlohmann::json::parse(read_file(output / "preview.json"));
  EXPECT_EQ(said["format"], "asperity-preview/1");
  const Hertz hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  const auto value = [&](const char* name) { return said["elastic"][name]["value"].get<double>(); };
  EXPECT_NEAR(value("contact_area") / hertz.contact_area(1e-3), 1, 0.01);
  EXPECT_NEAR(value("max_pressure") / hertz.peak_pressure(1e-3), 1, 0.01);
  EXPECT_NEAR(value("normal_stiffness") / hertz.normal_stiffness(1e-3), 1, 0.01);
  EXPECT_NEAR(value("approach") / hertz.approach(1e-3), 1, 0.01);
  EXPECT_GT(said["mesh"]["dofs"], 1000);
  EXPECT_FALSE(said.contains("capped"));
  const std::string picture = read_file(output / "pressure.svg");
  EXPECT_CONTAINS(picture, "xmlns");
  EXPECT_CONTAINS(picture, ".frame{fill:none");  // else a black rectangle hides the map
  EXPECT_CONTAINS(picture, "x [nm]");
  EXPECT_CONTAINS(picture, "contact pressure [GPa]");
}

TEST(Preview_behaviour, caps_the_pressures_of_bodies_that_yield_and_says_what_is_left_out) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "preview";
  const std::string arguments =
      "preview " + file.string() + " --output " + output.string() +
      " --set 'Substrate/Yield stress=2 GPa' --set 'Particle/Yield stress=0.8 GPa' --set "
      "'Interface/Work of adhesion=50 mJ/m^2' --set 'Interface/Adhesion range=1 nm' --set "
      "'Interface/Friction coefficient=0.3' --set 'Substrate/Topography=generated(rms=1.5 "
      "nm, rolloff=300 nm, cutoff=100 nm, seed=3)'";
  const Outcome outcome = call(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_CONTAINS(outcome.output, "pull-off force");
  EXPECT_CONTAINS(outcome.output, "hardness of 2.4 GPa");
  EXPECT_CONTAINS(outcome.output, "asperities do from about");
  const auto said = nlohmann::json::parse(read_file(output / "preview.json"));
  EXPECT_GT(said["capped"]["contact_area"]["value"], said["elastic"]["contact_area"]["value"]);
  EXPECT_DOUBLE_EQ(said["capped"]["hardness"]["value"].get<double>(), 2.4e9);
  EXPECT_TRUE(said["capped"]["contact_area"]["sd"].is_null());  // one grid tells no error
  EXPECT_GT(said["elastic"]["contact_area"]["sd"], 0);
  EXPECT_TRUE(said["left_out"].empty());
  EXPECT_GT(said["capped"]["pull_off_force"]["value"], said["elastic"]["pull_off_force"]["value"]);
  const auto elastic = [&](const char* name) { return said["elastic"][name]["value"].get<double>(); };
  EXPECT_NEAR(elastic("slipping_force") / (0.3 * (elastic("normal_force") + elastic("attraction"))), 1, 1e-6);
  EXPECT_GT(elastic("slipping_moment"), 0);
  EXPECT_CONTAINS(outcome.output, "stuck together: lateral stiffness");
  const Outcome harder = call(arguments + " --hardness '3 GPa'");
  EXPECT_EQ(harder.status, 0) << harder.output;
  EXPECT_CONTAINS(harder.output, "hardness of 3 GPa");
}

TEST(Preview_behaviour, a_film_softens_the_contact_and_leaves_its_shear_out) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "preview";
  const Outcome outcome = call("preview " + file.string() + " --output " + output.string() +
                               " --set 'Substrate/Film thickness=100 nm' --set 'Substrate/Film Young "
                               "modulus=10 GPa' --set 'Substrate/Film Poisson ratio=0.3'");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_CONTAINS(outcome.output, "lateral and torsion stiffness are left out: half-spaces with films");
  EXPECT_EQ(outcome.output.find("stuck together"), std::string::npos) << outcome.output;
  const auto said = nlohmann::json::parse(read_file(output / "preview.json"));
  const Hertz hertz{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  EXPECT_GT(said["elastic"]["approach"]["value"].get<double>(), 1.1 * hertz.approach(1e-3));
  EXPECT_LT(said["elastic"]["max_pressure"]["value"].get<double>(), 0.95 * hertz.peak_pressure(1e-3));
  EXPECT_FALSE(said["elastic"].contains("lateral_stiffness"));
}

TEST(Preview_analytic, a_smooth_case_that_slides_slips_as_Mindlin_found) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "preview";
  const Outcome outcome = call("preview " + file.string() + " --output " + output.string() +
                               " --set Experiment/Type=sliding --set 'Interface/Friction coefficient=0.3'");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto said = nlohmann::json::parse(read_file(output / "preview.json"));
  const ElasticBody particle{71e9, 0.17}, substrate{179e9, 0.25};
  const double full = 0.3e-3, stiffness = said["elastic"]["lateral_stiffness"]["value"],
               a = Hertz{reduced_modulus(particle, substrate), 8.5e-6}.contact_radius(1e-3);
  // Mindlin (1949), Reissner & Sagoci (1944), and Hertz' pressure about its middle.
  EXPECT_NEAR(stiffness / (mindlin_factor * a * reduced_shear_modulus(particle, substrate)), 1, 0.01);
  EXPECT_NEAR(said["elastic"]["torsion_stiffness"]["value"].get<double>() /
                  (16.0 / 3 * a * a * a * torsion_modulus(particle, substrate)),
              1, 0.02);
  EXPECT_NEAR(said["elastic"]["slipping_moment"]["value"].get<double>() / (3 * M_PI / 16 * full * a), 1,
              0.005);
  ASSERT_EQ(said["partial_slip"].size(), 7u);
  for (const auto& point : said["partial_slip"]) {
    const double share = point["shift"].get<double>() * stiffness / (1.5 * full);
    EXPECT_NEAR(point["lateral_force"].get<double>() / full, 1 - std::pow(std::max(0.0, 1 - share), 1.5),
                0.01);
  }
  EXPECT_EQ(said["partial_slip"].back()["slipping"], 1);
}

TEST(Preview_analytic, smooth_bodies_that_adhere_part_under_the_force_of_Maugis) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const auto output = folder.path / "preview";
  const Outcome outcome = call(
      "preview " + file.string() + " --output " + output.string() +
      " --set 'Experiment/Normal load=10 uN' --set 'Interface/Adhesion law=dugdale' --set 'Interface/Work of "
      "adhesion=100 mJ/m^2' --set 'Interface/Adhesion range=1 nm'");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto said = nlohmann::json::parse(read_file(output / "preview.json"));
  const MaugisDugdale maugis{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6, 0.1, 0.1 / 1e-9};
  EXPECT_NEAR(said["elastic"]["pull_off_force"]["value"].get<double>() / maugis.pull_off_force(), 1, 0.01);
  EXPECT_NEAR(said["elastic"]["approach"]["value"].get<double>() / maugis.approach(10e-6), 1, 0.01);
  EXPECT_NEAR(said["elastic"]["normal_force"]["value"].get<double>() / 10e-6, 1, 1e-6);
}

TEST(Preview_behaviour, an_attraction_told_as_a_force_is_carried_beside_the_load) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const Outcome outcome = call("preview " + file.string() + " --set 'Interface/Attraction force=0.5 mN'");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_CONTAINS(outcome.output, "normal force 1 mN;");
  EXPECT_CONTAINS(outcome.output,
                  "attraction of 500 uN, which the contact carries beside the load; pull-off force 500 uN");
}

TEST(Preview_behaviour, says_of_adhesion_in_too_small_a_zone_that_it_is_left_out) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const Outcome outcome =
      call("preview " + file.string() +
           " --set 'Particle/Young modulus=10 MPa' --set 'Interface/Work of adhesion=100 mJ/m^2' --set "
           "'Interface/Adhesion range=1 nm' --set 'Experiment/Normal load=1 uN'");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_CONTAINS(outcome.output, "adhesion is left out");
  EXPECT_EQ(outcome.output.find("pull-off force 1"), std::string::npos);
}

TEST(Preview_behaviour, says_what_solve_would_refuse_and_refuses_what_cannot_be_meant) {
  const TemporaryFolder folder;
  const auto file = folder.write("case.prm", smooth_case());
  const Outcome spun = call("preview " + file.string() + " --set 'Experiment/Type=torsion'");
  EXPECT_EQ(spun.status, 0) << spun.output;
  EXPECT_CONTAINS(spun.output, "of torsion the pressing down is previewed");
  EXPECT_CONTAINS(spun.output, "asperity solve would refuse it: ");
  EXPECT_EQ(call("preview " + file.string() + " --hardness '-1 GPa'").status, 2);
  EXPECT_EQ(call("preview " + file.string() + " --hardness soft").status, 2);
  EXPECT_EQ(
      call("preview " + file.string() + " --hardness '1 MPa' --set 'Substrate/Yield stress=4 GPa'").status,
      2);
  EXPECT_EQ(call("preview " + (folder.path / "none.prm").string()).status, 2);
  EXPECT_EQ(call("preview").status, 2);
}

}  // namespace
}  // namespace asperity
