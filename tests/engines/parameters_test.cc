#include "engines/parameters/contact_parameters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/atomic_file.h"
#include "core/error.h"
#include "paper/published.h"
#include "tests/engines/canonical_contact.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;
using test::message_of;

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

Json shipped() { return Json::parse(read_file(test::paper_run("parameters_silicon.json"))); }

std::string refusal(const Json& json) {
  return message_of<InputError>([&] { parse_contact_parameters(json, "p.json"); });
}

TEST(ContactParameters_behaviour, of_the_paper_are_read_with_their_uncertainty_and_load_range) {
  const ContactParameters p = read_contact_parameters(test::paper_run("parameters_silicon.json"));
  EXPECT_DOUBLE_EQ(p.particle.radius, 8.5e-6);
  EXPECT_TRUE(p.target.is_plane());
  EXPECT_DOUBLE_EQ(p.sliding_friction->value, 0.23);
  EXPECT_DOUBLE_EQ(p.sliding_friction->sd, 0.005);
  EXPECT_DOUBLE_EQ(p.rolling_friction->load_range->high, 3e-3);
  EXPECT_EQ(p.rolling_friction->length_scale, LengthScale::particle_radius);
  EXPECT_FALSE(p.torsion_offset);
  EXPECT_DOUBLE_EQ(
      p.load_range(&ContactParameters::sliding_friction, &ContactParameters::sliding_offset)->low, 3e-6);
}

TEST(ContactParameters_other_code, shipped_for_each_surface_are_those_of_table_2) {
  const Published published = read_published(test::paper_run("published"));
  const std::vector<std::string> files{"parameters_silicon.json", "parameters_silicon_1600W.json",
                                       "parameters_silicon_1800W.json"};
  ASSERT_EQ(published.surfaces.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    SCOPED_TRACE(files[i]);
    const ContactParameters p = read_contact_parameters(test::paper_run(files[i]));
    const PublishedSurface& surface = published.surfaces[i];
    const auto expect_same = [](const std::optional<EffectiveQuantity>& given, const Uncertain& measured) {
      ASSERT_TRUE(given);
      EXPECT_NEAR(given->value / measured.value, 1, 1e-9);
      EXPECT_NEAR(given->sd / measured.sd, 1, 1e-9);
    };
    EXPECT_NEAR(p.target.rms / surface.rms.value, 1, 1e-9);
    expect_same(p.sliding_friction, surface.sliding);
    expect_same(p.sliding_offset, surface.sliding_offset);
    expect_same(p.rolling_friction, surface.rolling_r);
    expect_same(p.rolling_offset, surface.rolling_r_offset);
    expect_same(p.pull_off_force, surface.pull_off);
    expect_same(p.torsion_friction, published.quoted("torsion_r"));
  }
}

TEST(ContactParameters_behaviour, survive_writing_and_reading) {
  const test::TemporaryFolder folder;
  const ContactParameters p = read_contact_parameters(test::paper_run("parameters_diamond.json"));
  write_contact_parameters(p, folder.path / "parameters.json");
  const ContactParameters again = read_contact_parameters(folder.path / "parameters.json");
  EXPECT_EQ(to_json(p).dump(), to_json(again).dump());
  EXPECT_DOUBLE_EQ(again.rolling_stiffness->at_load, 1e-4);
}

TEST(ContactParameters_analytic, limits_and_stiffnesses_follow_their_laws) {
  ContactParameters p = test::canonical_contact();
  EXPECT_NEAR(p.contact_radius(1e-4), 0.22931e-6, 0.5e-11);
  EXPECT_NEAR(p.lateral_stiffness_at(1e-4), 21645.1, 0.5);
  p.sliding_offset = EffectiveQuantity{12e-6};
  EXPECT_DOUBLE_EQ(p.sliding_limit(1e-4), 0.23 * 112e-6);
  p.rolling_offset = EffectiveQuantity{571.4e-6};
  EXPECT_DOUBLE_EQ(p.rolling_limit(1e-4), p.rolling_friction->value * 8.5e-6 * 671.4e-6);
  p.torsion_friction->length_scale = LengthScale::contact_radius;
  EXPECT_DOUBLE_EQ(p.torsion_limit(1e-4), p.torsion_friction->value * p.contact_radius(1e-4) * 1e-4);
  EXPECT_NEAR(p.rolling_stiffness_at(8e-4) / p.rolling_stiffness_at(1e-4), 2,
              1e-12);  // a grows with the load's cube root
  p.target.radius = p.particle.radius;
  EXPECT_DOUBLE_EQ(p.effective_radius(), p.particle.radius / 2);
}

TEST(ContactParameters_behaviour, refuse_an_unknown_key_and_name_the_right_one) {
  Json json = shipped();
  json["quantities"]["rolling_fricton"] = json["quantities"]["rolling_friction"];
  EXPECT_EQ(refusal(json),
            "p.json: there is no 'rolling_fricton' in 'quantities'; did you mean 'rolling_friction'?");
  json = shipped();
  json["particle"]["radus"] = 1;
  EXPECT_CONTAINS(refusal(json), "did you mean 'radius'?");
}

TEST(ContactParameters_behaviour, refuse_what_cannot_be_meant) {
  Json json = shipped();
  json["format"] = "asperity-parameters/2";
  EXPECT_CONTAINS(refusal(json), "reads 'asperity-parameters/1'");
  json = shipped();
  json["quantities"]["reduced_modulus"]["unit"] = "GPa";
  EXPECT_CONTAINS(refusal(json), "quantities/reduced_modulus' has the unit 'GPa'; it must be in SI: 'Pa'");
  json = shipped();
  json["quantities"]["rolling_friction"].erase("length_scale");
  EXPECT_CONTAINS(refusal(json), "no length_scale");
  json = shipped();
  json["quantities"]["rolling_stiffness"].erase("at_load");
  EXPECT_CONTAINS(refusal(json), "no at_load");
  json = shipped();
  json["quantities"]["sliding_friction"]["value"] = "much";
  EXPECT_CONTAINS(refusal(json), "quantities/sliding_friction/value' is not a number");
  json = shipped();
  json["quantities"]["sliding_friction"]["load_range"] = {2, 1};
  EXPECT_CONTAINS(refusal(json), "the lowest first");
  json = shipped();
  json["target"]["geometry"] = "cone";
  EXPECT_CONTAINS(refusal(json), "plane or sphere");
  json = shipped();
  json["quantities"].erase("reduced_shear_modulus");
  EXPECT_CONTAINS(refusal(json), "no 'reduced_shear_modulus'");
}

TEST(ContactParameters_behaviour, say_which_line_is_not_JSON) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("p.json", "{\n\"format\": \"asperity-parameters/1\",\n oops\n}");
  EXPECT_EQ(message_of<InputError>([&] { read_contact_parameters(file); }),
            file.string() +
                ":3: this is not JSON here: invalid literal, expected string literal; correct it or write it "
                "again");
}

TEST(ContactParameters_behaviour, say_which_quantity_a_law_lacks) {
  ContactParameters p = test::canonical_contact();
  p.rolling_stiffness.reset();
  EXPECT_CONTAINS(message_of<InputError>([&] { p.rolling_stiffness_at(1e-4); }),
                  "'quantities' has no 'rolling_stiffness'");
}

}  // namespace
}  // namespace asperity
