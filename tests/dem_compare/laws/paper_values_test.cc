// Numbers of the paper's contacts, recomputed from its Table 1 (borosilicate sphere of 8.5 um on silicon,
// diamond, quartz).
#include <gtest/gtest.h>

#include "core/shear_moduli.h"
#include "dem_compare/laws/hertz_offset.h"
#include "dem_compare/laws/mindlin.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"

namespace asperity {
namespace {

constexpr double radius = 8.5e-6;
const ElasticBody borosilicate{71e9, 0.17}, silicon{179e9, 0.25}, diamond{1140e9, 0.07}, quartz{71e9, 0.17};

TEST(PaperValues_other_code, moduli_contact_radii_and_approaches_are_those_of_Table_1) {
  struct Pair {
    ElasticBody plane;
    double normal_modulus, shear_modulus, radius_100uN, approach_100uN, radius_3mN;
  };
  for (const Pair& pair : {Pair{silicon, 52.8684, 11.7989, 0.2293, 6.186, 0.7125},
                           Pair{diamond, 68.7268, 15.6407, 0.2101, 5.194, 0.6529},
                           Pair{quartz, 36.5565, 8.2901, 0.2593, 7.912, 0.8058}}) {
    const Hertz hertz{reduced_modulus(borosilicate, pair.plane), radius};
    EXPECT_NEAR(hertz.reduced_modulus / 1e9, pair.normal_modulus, 5.1e-5);
    EXPECT_NEAR(reduced_shear_modulus(borosilicate, pair.plane) / 1e9, pair.shear_modulus, 5.1e-5);
    EXPECT_NEAR(hertz.contact_radius(1e-4) * 1e6, pair.radius_100uN, 5.1e-5);
    EXPECT_NEAR(hertz.approach(1e-4) * 1e9, pair.approach_100uN, 1e-3);  // a unit of the last digit
    EXPECT_NEAR(hertz.contact_radius(3e-3) * 1e6, pair.radius_3mN, 5.1e-5);
  }
}

TEST(PaperValues_other_code,
     yield_shifts_at_100uN_are_1063_and_1594_pm_and_ten_times_that_with_the_fitted_stiffness) {
  const HertzOffset hertz{reduced_modulus(borosilicate, silicon), radius, 0};
  const NormalState normal = hertz.advance({}, hertz.approach(1e-4));
  const CoulombLimit friction{0.23, 0};
  const double shear = reduced_shear_modulus(borosilicate, silicon),
               k = Mindlin{shear, friction}.stiffness(normal.contact_radius);
  EXPECT_NEAR(k / 2.1645e4, 1, 2e-5);
  EXPECT_NEAR(friction.limit(1e-4) / k * 1e9, 1.063, 5.1e-4);
  const MindlinDeresiewicz partial_slip{shear, radius, friction};
  EXPECT_NEAR(partial_slip.gross_slip_shift(normal) * 1e9, 1.594, 5.1e-4);
  // The fit k = 2.219 kN/m means G* = 1.2096 GPa.
  const double fitted = Mindlin{1.2096e9, friction}.stiffness(normal.contact_radius);
  EXPECT_NEAR(fitted / 2219, 1, 1e-4);
  EXPECT_NEAR(friction.limit(1e-4) / fitted * 1e9, 10.37, 6e-3);
  EXPECT_NEAR((CoulombLimit{0.23, 12e-6}.limit(1e-4)) / fitted * 1e9, 11.61, 6e-3);
}

}  // namespace
}  // namespace asperity
