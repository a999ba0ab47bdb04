#include "dem_compare/laws/law_registry.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "core/atomic_file.h"
#include "core/error.h"
#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/law_text.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;

TEST(LawRegistry_behaviour, every_law_states_equation_source_validity_and_its_parameters_with_bounds) {
  std::set<std::string> names;
  for (const LawDescription& law : reduced_laws()) {
    EXPECT_TRUE(names.insert(law.name).second) << law.name;
    for (const auto& text : {law.mode, law.equation, law.source, law.validity})
      EXPECT_FALSE(text.empty()) << law.name;
    EXPECT_FALSE(law.parameters.empty()) << law.name;
    for (const auto& parameter : law.parameters) EXPECT_LT(parameter.low, parameter.high) << law.name;
  }
  for (const char* name :
       {"hertz", "linear", "dmt", "jkr", "maugis_dugdale", "mindlin", "mindlin_deresiewicz", "linear_sliding",
        "rolling_resistance", "hysteresis_rolling", "adhesive_rolling", "plastic_rolling",
        "torsion_resistance", "lubkin_torsion", "creep_force", "sliding_with_spin", "viscous"})
    EXPECT_TRUE(names.count(name)) << name;
}

TEST(LawRegistry_behaviour, manual_page_names_every_law_and_parameter) {
  const std::string page = reduced_laws_manual();
  for (const LawDescription& law : reduced_laws()) {
    EXPECT_NE(page.find("`" + law.name + "`"), std::string::npos);
    for (const auto& parameter : law.parameters)
      EXPECT_NE(page.find("| `" + parameter.name + "`"), std::string::npos);
  }
}

TEST(LawRegistry_behaviour, the_shipped_manual_page_is_the_present_one) {
  const auto root = std::filesystem::path(__FILE__).parent_path().parent_path().parent_path().parent_path();
  EXPECT_EQ(read_file(root / "docs" / "reduced_laws.md"), reduced_laws_manual(Equations::typeset))
      << "write it anew: asperity laws --typeset > docs/reduced_laws.md";
}

TEST(LawRegistry_analytic, a_law_that_is_made_by_its_name_is_the_law_with_these_parameters) {
  const Jkr jkr{50e9, 8.5e-6, 0.08};
  const NormalLaw made = make_law<NormalMode>(
      "jkr", {{"reduced_modulus", 50e9}, {"radius", 8.5e-6}, {"work_of_adhesion", 0.08}});
  EXPECT_EQ(made->approach(1e-4), jkr.approach(1e-4));
  EXPECT_EQ(made->radius(), 8.5e-6);
}

TEST(LawRegistry_behaviour, every_law_is_made_from_values_of_one_and_its_defaults) {
  for (const LawDescription& law : reduced_laws()) {
    LawValues ones;
    for (const auto& parameter : law.parameters)
      if (parameter.is_needed()) ones[parameter.name] = 1;
    EXPECT_NO_THROW(make_reduced_law(law.name, ones)) << law.name;
  }
}

TEST(LawRegistry_behaviour, values_that_are_missing_unknown_or_out_of_bounds_are_refused) {
  const auto refusal = [](const LawValues& values) {
    return message_of<InputError>([&] { make_reduced_law("jkr", values); });
  };
  EXPECT_EQ(refusal({{"reduced_modulus", 1}, {"radius", 1}}),
            "the law 'jkr' needs 'work_of_adhesion' [J/m^2], w of both surfaces together; give it as in "
            "'jkr, work_of_adhesion = ...'");
  EXPECT_EQ(refusal({{"radios", 1}}), "no parameter of the law 'jkr' named 'radios'; did you mean 'radius'?");
  for (const double radius : {-1.0, std::nan("")})
    EXPECT_NE(refusal({{"reduced_modulus", 1}, {"radius", radius}, {"work_of_adhesion", 1}})
                  .find("give a value from 0 to inf"),
              std::string::npos);
  EXPECT_EQ(message_of<InputError>([] { make_law<SlidingMode>("jkr", {}); }),
            "the law 'jkr' is one of normal, not of sliding");
  EXPECT_EQ(message_of<InputError>([] { reduced_law("mindlinn"); }),
            "no reduced law 'mindlinn'; did you mean 'mindlin'?");
}

TEST(LawText_behaviour, name_and_parameters_with_units_and_choices_are_read) {
  const WrittenLaw jkr = parse_law(" jkr , work_of_adhesion = 50 mJ/m^2,radius=8.5 um");
  EXPECT_EQ(jkr.description.name, "jkr");
  EXPECT_EQ(jkr.values, (LawValues{{"work_of_adhesion", 0.05}, {"radius", 8.5e-6}}));
  const WrittenLaw rolling = parse_law("rolling_resistance, length = contact_radius, stiffness = 1e-9");
  EXPECT_EQ(rolling.values,
            (LawValues{{"length", static_cast<double>(LengthScale::contact_radius)}, {"stiffness", 1e-9}}));
}

TEST(LawText_behaviour, what_is_written_wrongly_is_named) {
  const auto refusal = [](const char* text) { return message_of<InputError>([&] { parse_law(text); }); };
  EXPECT_EQ(refusal("jkr, 5"), "in 'jkr, 5' the part '5' is not 'parameter = value'");
  EXPECT_EQ(refusal("jkr, radius = 5 N"),
            "in '5 N' the unit 'N' does not fit; use one of m, mm, um, µm, μm, nm, pm, A, Å, cm, km");
  EXPECT_EQ(refusal("rolling_resistance, length = a"),
            "there is no length 'a'; there are none, particle_radius, contact_radius");
  EXPECT_NE(refusal("").find("no reduced law ''"), std::string::npos);
}

}  // namespace
}  // namespace asperity
