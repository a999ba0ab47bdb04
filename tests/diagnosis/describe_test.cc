// The sentence of a diagnosis, of numbers set by hand.
#include "diagnosis/describe.h"
#include "diagnosis/remarks.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

std::string sentence(double chi2, double held_out, int effects) {
  Diagnosis d;
  d.verdict = Verdict::explained;
  d.baseline.chi2_reduced = d.baseline.held_out_chi2_reduced = 790;
  d.improved.chi2_reduced = chi2;
  d.improved.samples = 1000;
  d.improved.held_out_chi2_reduced = held_out;
  for (int i = 0; i < effects; ++i) {
    d.left_out.emplace_back();
    d.left_out.back().id = "effect_" + std::to_string(i);
  }
  return in_words(d);
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(InWords_behaviour, says_where_data_kept_out_are_predicted_worse_than_noise) {
  const std::string well = sentence(1.04, 1.06, 1), badly = sentence(1.04, 3912, 1);
  EXPECT_TRUE(says(well, "to 1.06), which is noise.")) << well;
  EXPECT_TRUE(
      says(badly, "to 3.91e+03), which is noise where it was fitted and more than noise where it was not."))
      << badly;
  EXPECT_FALSE(says(sentence(2, 3912, 1), "which is noise"));
}

TEST(InWords_behaviour, says_what_an_unexplained_mismatch_lacks) {
  Diagnosis d;
  d.verdict = Verdict::unexplained;
  EXPECT_TRUE(says(in_words(d), "No part of the data stands out; what it is remains open.")) << in_words(d);
  d.mismatch.emplace_back();
  EXPECT_TRUE(says(in_words(d), "The mismatch is located; what it is remains open.")) << in_words(d);
  d.baseline.chi2_reduced = 790;
  d.with_nearest.samples = 1000;
  d.with_nearest.chi2_reduced = 189;
  EXPECT_TRUE(says(remarks_on_nearest(d)[0], "takes away only part of the mismatch"));
  d.with_nearest.chi2_reduced = 1.04;
  EXPECT_TRUE(says(remarks_on_nearest(d)[0],
                   "leaves no more than noise (chi-square per sample falls from 790 to 1.04)"));
}

TEST(InWords_behaviour, counts_its_effects) {
  EXPECT_TRUE(says(sentence(1, 1, 1), "left out effect_0. With it chi-square"));
  EXPECT_TRUE(says(sentence(1, 1, 2), "left out effect_0 and effect_1. With them chi-square"));
}

}  // namespace
}  // namespace asperity
