// The answer of characterise as text and page: names, intervals, what no interval holds, and hostile names.
#include "report/characterisation/characterisation_page.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Characterisation answer() {
  Characterisation table;
  CharacterisedNumber stiffness{"normal_stiffness", "k_n at its at_load", "N/m", 20e3, 1e-4, 1e3, 0};
  stiffness.from = "elastic stiffness";
  CharacterisedNumber friction{"sliding_friction", "mu_l", "", 0.22};
  friction.fit_sd = 0.001, friction.local_friction = 0.22, friction.input_is_known = false;
  CharacterisedNumber offset{"sliding_offset", "h_l", "N", 0};
  offset.is_assumed = true;
  table.numbers = {stiffness, friction, offset};
  table.not_known = {"rolling_stiffness"};
  return table;
}

TEST(CharacterisationPage_analytic, two_realisations_have_the_interval_of_student) {
  CharacterisedNumber number{"normal_stiffness", "k_n", "N/m", 20e3, 1e-4, 1e3};
  number.holds_scatter = true;
  EXPECT_NEAR(number.half_width(), 1.96e3, 1);
  number.degrees_of_freedom = 1;
  EXPECT_NEAR(number.half_width(), 12.706e3, 1) << "tables of Student's t";
  number.degrees_of_freedom = 2, number.mesh_sd = 1e3;
  EXPECT_NEAR(number.half_width(), std::hypot(4.303e3, 1.96e3), 1);
}

TEST(CharacterisationPage_analytic, states_1p96_standard_deviations_and_whether_they_are_what_was_asked) {
  // 20 +- 1.96 kN/m: 9.8 %
  const std::string good = report::characterisation_text(answer(), 0.15);
  EXPECT_TRUE(holds(good, "normal stiffness at 100 uN")) << good;
  EXPECT_TRUE(holds(good, "18 kN/m to 22 kN/m")) << good;
  EXPECT_FALSE(holds(good, "more than")) << good;
  EXPECT_TRUE(holds(report::characterisation_text(answer(), 0.05), "±9.8 %, more than the 5 % asked"));
}

TEST(CharacterisationPage_behaviour, gives_no_interval_to_what_follows_a_guess_or_is_assumed) {
  const std::string text = report::characterisation_text(answer(), 0.15);
  EXPECT_TRUE(holds(text, "follows the local friction of 0.22 that went in, a guess")) << text;
  EXPECT_TRUE(holds(text, "assumed: one load does not tell it")) << text;
  EXPECT_TRUE(holds(text, "not known: rolling stiffness")) << text;
}

TEST(CharacterisationPage_behaviour, is_a_page_in_which_names_from_outside_are_text) {
  report::CharacterisationText text;
  text.title = "<script>alert(1)</script>";
  text.sentences = {"substrate: <b>scan</b>.gsf"};
  text.files = {"parameters.json"};
  const std::string page = report::characterisation_page({answer()}, text);
  EXPECT_FALSE(holds(page, "<script>alert"));
  EXPECT_FALSE(holds(page, "<b>scan"));
  EXPECT_TRUE(holds(page, "href='parameters.json'"));
  EXPECT_TRUE(holds(page, "elastic stiffness"));
}

}  // namespace
}  // namespace asperity
