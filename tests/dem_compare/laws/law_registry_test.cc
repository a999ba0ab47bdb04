#include "dem_compare/laws/law_registry.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "core/atomic_file.h"
#include "core/error.h"
#include "dem_compare/laws/jkr.h"

namespace asperity {
namespace {

TEST(LawRegistry_behaviour, every_law_states_equation_source_validity_and_its_parameters_with_bounds) {
  std::set<std::string> names;
  for (const LawDescription& law : reduced_laws()) {
    EXPECT_TRUE(names.insert(law.name).second) << law.name;
    for (const auto& text : {law.mode, law.equation, law.source, law.validity}) EXPECT_FALSE(text.empty()) << law.name;
    EXPECT_FALSE(law.parameters.empty()) << law.name;
    for (const auto& parameter : law.parameters) EXPECT_LT(parameter.low, parameter.high) << law.name;
  }
  for (const char* name : {"hertz", "linear", "dmt", "jkr", "mindlin", "mindlin_deresiewicz", "coulomb", "rolling_resistance",
                           "torsion_resistance", "lubkin_torsion", "viscous"})
    EXPECT_TRUE(names.count(name)) << name;
}

TEST(LawRegistry_behaviour, manual_page_names_every_law_and_parameter) {
  const std::string page = reduced_laws_manual();
  for (const LawDescription& law : reduced_laws()) {
    EXPECT_NE(page.find("`" + law.name + "`"), std::string::npos);
    for (const auto& parameter : law.parameters) EXPECT_NE(page.find("| `" + parameter.name + "`"), std::string::npos);
  }
}

TEST(LawRegistry_behaviour, the_shipped_manual_page_is_the_present_one) {
  const auto root = std::filesystem::path(__FILE__).parent_path().parent_path().parent_path().parent_path();
  EXPECT_EQ(read_file(root / "docs" / "reduced_laws.md"), reduced_laws_manual())
      << "write it anew: asperity laws > docs/reduced_laws.md";
}

TEST(LawRegistry_behaviour, parameters_are_read_and_set_by_name_within_their_bounds) {
  Jkr law{50e9, 8.5e-6, 0.08};
  jkr_entry.set(law, "work_of_adhesion", 0.1);
  EXPECT_EQ(law.work_of_adhesion, 0.1);
  EXPECT_EQ(jkr_entry.get(law, "radius"), 8.5e-6);
  EXPECT_THROW(jkr_entry.set(law, "radius", -1), InputError);
  EXPECT_THROW(jkr_entry.set(law, "radius", std::nan("")), InputError);
  jkr_entry.check(law);
}

TEST(LawRegistry_behaviour, an_unknown_name_is_refused_with_the_nearest_one) {
  try {
    reduced_law("mindlinn");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'mindlin'"), std::string::npos) << error.what();
  }
  Jkr law;
  EXPECT_THROW(jkr_entry.set(law, "modulus of nothing", 1), InputError);
}

}  // namespace
}  // namespace asperity
