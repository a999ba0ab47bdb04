#include "results/surface_text.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(SurfaceText_behaviour, realisations_of_one_surface_are_the_same_however_they_are_written) {
  EXPECT_EQ(surface_without_seed("generated(rms=0.7 nm, window=2.5 um, seed=1)"), surface_without_seed("generated(rms=700 pm,  window=2500 nm, seed = 1001)"));
  EXPECT_EQ(surface_without_seed("generated(rms=0.7nm,window=2.5um,seed=1)"), surface_without_seed("generated(rms=700pm,window=2.5um,seed=12)"));
  EXPECT_NE(surface_without_seed("generated(rms=0.7 nm, seed=1)"), surface_without_seed("generated(rms=0.8 nm, seed=1)"));
  EXPECT_EQ(surface_without_seed("smooth"), "smooth");
}

}  // namespace
}  // namespace asperity
