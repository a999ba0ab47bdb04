#include "core/topography_spec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace asperity {
namespace {

TEST(TopographySpec_behaviour, realisations_of_one_surface_are_of_one_family_however_they_are_written) {
  const auto family = [](const char* text) { return TopographySpec(text).family(); };
  EXPECT_EQ(family("generated(rms=0.7 nm, window=2.5 um, seed=1)"),
            family("generated( window=2500 nm,rms=700 pm,  seed = 1001)"));
  EXPECT_EQ(family("generated(rms=0.7 nm)"),
            family("generated(rms=0.7 nm, hurst=0.8, rolloff=200 nm, cutoff=20 nm)"));
  EXPECT_NE(family("generated(rms=0.7 nm, seed=1)"), family("generated(rms=0.8 nm, seed=1)"));
  EXPECT_EQ(family("generated(rms=0.7 nm, seed=3, amplitudes=fixed)").find("seed"), std::string::npos);
  EXPECT_EQ(family(" smooth "), "smooth");
  EXPECT_EQ(family("scan(a.gsf, level=plane, cutoff=0.08 um)"), family("scan(a.gsf, cutoff=80 nm)"));
}

TEST(TopographySpec_behaviour, is_smooth_a_scan_or_generated_and_keeps_its_text) {
  const TopographySpec smooth, scan("scan(afm 1.txt, unit=nm, cutoff=80 nm)"),
      generated("generated(rms=1.5 nm, seed=42)");
  EXPECT_TRUE(smooth.is_smooth());
  EXPECT_FALSE(smooth.scan() || smooth.generator());
  EXPECT_EQ(smooth.text(), "smooth");
  ASSERT_TRUE(scan.scan());
  EXPECT_EQ(scan.scan()->file, "afm 1.txt");
  EXPECT_EQ(scan.scan()->options.height_unit, "nm");
  ASSERT_TRUE(generated.generator());
  EXPECT_EQ(generated.generator()->seed, 42u);
  EXPECT_EQ(generated.text(), "generated(rms=1.5 nm, seed=42)");
  EXPECT_NE(TopographySpec("generated(rms=1.5 nm, seed=42)").canonical(),
            TopographySpec("generated(rms=1.5 nm, seed=43)").canonical());
}

TEST(TopographySpec_analytic, knows_the_rms_that_it_was_given) {
  EXPECT_EQ(TopographySpec().rms(), 0);
  EXPECT_DOUBLE_EQ(TopographySpec("generated(rms=1500 pm)").rms(), 1.5e-9);
  EXPECT_TRUE(std::isnan(TopographySpec("scan.gsf").rms()));
}

TEST(TopographySpec_behaviour, refuses_what_it_cannot_read) {
  EXPECT_THROW(TopographySpec("generated(hurst=0.8)"), InputError);
  EXPECT_THROW(TopographySpec("scan(a.gsf, levels=plane)"), InputError);
}

}  // namespace
}  // namespace asperity
