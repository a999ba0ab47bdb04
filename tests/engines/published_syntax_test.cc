// Inputs of engines that are not run here, against what the engines publish: MUSEN's "Example 7 - Modified
// material parameters" with the words its ScriptAnalyzer knows (2020), MaterialsDEM.json of Kratos' example
// a_simple_3D_DEM_case.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "engines/engine_input.h"
#include "engines/many_particles/material_matrix.h"
#include "engines/many_particles/matrix_inputs.h"
#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

MaterialMatrix matrix() {
  ContactParameters contact = test::canonical_contact();
  contact.sliding_friction->load_range = LoadRange{1e-5, 1e-4};
  return material_matrix({contact}, {});
}

/// Lines that are no comment.
int lines_that_musen_reads(const std::string& text) {
  const std::set<std::string> of_material{"DENSITY", "YOUNG_MODULUS", "POISSON_RATIO"},
      of_interaction{"RESTITUTION_COEFFICIENT", "SLIDING_FRICTION", "ROLLING_FRICTION"};
  std::istringstream lines(text);
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string command, property, one, other, rest;
    double value = 0;
    words >> command >> property >> one;
    if (command == "INTERACTION_PROPERTY") words >> other;
    words >> value;
    EXPECT_FALSE(words.fail() || words >> rest) << line;
    EXPECT_EQ((command == "MATERIAL_PROPERTY" ? of_material : of_interaction).count(property), 1U) << line;
    EXPECT_EQ(one.rfind("KEY_", 0), 0U) << line;
    EXPECT_EQ(other.empty(), command == "MATERIAL_PROPERTY") << line;
    ++count;
  }
  return count;
}

TEST(PublishedSyntax_other_code, musen_reads_every_line_of_a_pair_and_of_all_pairs) {
  EXPECT_GE(lines_that_musen_reads(engine_input("musen", test::canonical_contact(), {})), 6);
  // Three numbers of each of two materials and of each of three pairs.
  const MaterialMatrix all = matrix();
  const std::string text = musen_matrix(all);
  EXPECT_GE(lines_that_musen_reads(text), 14);
  // |M| <= mu R F there; of two equal spheres R_e is R/2.
  const PairLaw& law = all.pair(0, 1).law;
  EXPECT_NEAR(test::number_after(text, "SLIDING_FRICTION KEY_1 KEY_2 "), law.sliding, 1e-12);
  EXPECT_NEAR(test::number_after(text, "ROLLING_FRICTION KEY_1 KEY_2 "), law.rolling / 2, 1e-12);
}

TEST(PublishedSyntax_other_code, kratos_finds_its_keys_and_no_others) {
  const std::set<std::string> of_material{"PARTICLE_DENSITY", "YOUNG_MODULUS", "POISSON_RATIO"},
      of_relation{"DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME",
                  "STATIC_FRICTION",
                  "DYNAMIC_FRICTION",
                  "FRICTION_DECAY",
                  "COEFFICIENT_OF_RESTITUTION",
                  "DEM_ROLLING_FRICTION_MODEL_NAME",
                  "ROLLING_FRICTION",
                  "ROLLING_FRICTION_WITH_WALLS"};
  for (const std::string& text :
       {engine_input("kratos", test::canonical_contact(), {}), kratos_matrix(matrix())}) {
    const auto json = nlohmann::json::parse(text);
    ASSERT_FALSE(json["materials"].empty());
    ASSERT_FALSE(json["material_relations"].empty());
    for (const auto& material : json["materials"]) {
      EXPECT_TRUE(material["material_name"].is_string() && material["material_id"].is_number_integer());
      for (const auto& [key, value] : material["Variables"].items())
        EXPECT_EQ(of_material.count(key), 1U) << key;
    }
    for (const auto& relation : json["material_relations"]) {
      EXPECT_EQ(relation["material_names_list"].size(), 2U);
      EXPECT_EQ(relation["material_ids_list"].size(), 2U);
      for (const auto& [key, value] : relation["Variables"].items())
        EXPECT_EQ(of_relation.count(key), 1U) << key;
    }
  }
}

}  // namespace
}  // namespace asperity
