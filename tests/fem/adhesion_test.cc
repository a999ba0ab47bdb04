// What attraction does to the rolling and sliding of a smooth elastic sphere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "fem/interface/adhesion/dugdale.h"
#include "tests/fem/support/frictional_contact.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using test::FrictionalContact;
using test::FrictionalContactOptions;

/// Of the active contact nodes across the direction of rolling [m]; the contact is longer than wide.
double width_of_contact(const FrictionalContact& contact) {
  struct Column {
    int closed = 0;
    double low = 0, high = 0;
  };
  std::map<long, Column> columns;
  for (std::size_t r = 0; r < contact.state.multiplier.size(); ++r) {
    if (contact.state.multiplier[r] <= 0) continue;
    const auto& x = contact.system.interface_points()[contact.system.rows()[r].node];
    auto& c = columns[std::lround(x[0] * 1e12)];
    c.low = c.closed ? std::min(c.low, x[1]) : x[1], c.high = c.closed ? std::max(c.high, x[1]) : x[1];
    ++c.closed;
  }
  double widest = 0;
  for (const auto& [x, c] : columns)
    if (c.closed > 1) widest = std::max(widest, (c.high - c.low) * c.closed / (c.closed - 1));
  return widest;
}

/// Kendall (1975), Wear 33:351: the rim in front gives back the closing work, the rim behind takes the
/// work of adhesion on separation, over the width of contact: M = R 2a (w_opening - w_closing). Steady once
/// what was bonded at the start has left the attraction's range: after `transient` contact radii. Attraction
/// reaches over `region` contact radii.
void expect_hysteresis_resists(double closing, double opening, double range, double transient,
                               double region) {
  FrictionalContactOptions o;
  o.friction = 0;
  o.cells_per_radius = 8;
  o.region = region;
  o.path_length = 2 * (transient + 1) * 260e-9;
  o.adhesion = {std::make_shared<fem::Dugdale>(closing, range),
                std::make_shared<fem::Dugdale>(opening, range)};
  FrictionalContact contact(o);
  const double a = contact.contact_radius, h = a / o.cells_per_radius;
  double moment = 0, lost = 0, width = 0;
  int steps = 0;
  for (double x = h; x < (transient + 1) * a; x += h) {
    const auto r = contact.roll(x / o.radius);
    if (x < transient * a) continue;
    moment += r.rolling_moment, lost += contact.adhesion_loss, width += width_of_contact(contact);
    ++steps;
  }
  const double expected = o.radius * (opening - closing) * width / steps;
  std::printf("moment %.4g, lost per angle %.4g, R times width times dw %.4g N m\n", moment / steps,
              lost / (steps * h / o.radius), expected);
  char place[96];
  std::snprintf(place, sizeof place, "rolling, w %g closing and %g J/m2 opening over %g nm, a/h 8: ", closing,
                opening, 1e9 * range);
  const auto verified = [&](const std::string& what, const char* source) {
    return test::Verified{"Adhesion", place + what, source};
  };
  EXPECT_TRUE(
      verified("moment", "R times width times dw, Kendall (1975)").within(moment / steps, expected, 0.05));
  EXPECT_TRUE(verified("what bonds lose per angle, less the moment", "the moment")
                  .below(100 * (lost / (h / o.radius) - moment) / steps / expected, 5, "%"));
}

TEST(AdhesiveRolling_analytic, hysteresis_of_adhesion_resists_rolling_by_its_work_over_the_width_of_contact) {
  expect_hysteresis_resists(0.1, 0.5, 2e-9, 1, 1.5);  // Maugis' parameter of closing and opening: 0.2 and 0.7
}

TEST(AdhesiveRollingNightly_analytic, in_the_limit_of_DMT_hysteresis_of_adhesion_resists_rolling_alike) {
  expect_hysteresis_resists(0.02, 0.05, 10e-9, 4, 2.4);  // 0.02 and 0.03
}

/// Dominik & Tielens (1995), Phil. Mag. A 72, 783, eq. 32: while its rim is pinned, a contact of radius a
/// resists a roll that brings the particle's centre ahead by xi with M = 4 F_c (a/a0)^(3/2) xi. That is (P_a
/// - P) xi, P_a = 4 E* a^3 / (3 R): what tilting a bonded circle takes, less what the load gives. Krijt,
/// Dominik & Tielens (2014), J. Phys. D 47, 175302: the rim moves where its energy release G (1 -+ e)^2, e =
/// 3 P_a xi / ((P_a - P) a), falls below the work of adhesion on approach or rises above that on separation.
struct PinnedContact {
  FrictionalContact contact;
  double surplus, critical,
      unrolled;           ///< P_a - P [N], xi at which the rim moves [m], moment before rolling [N m]
  bool has_lost = false;  ///< bonds have formed or broken since

  static FrictionalContactOptions options(double cells, double closing, double opening,
                                          double closing_range) {
    FrictionalContactOptions o;
    o.friction = 0;
    o.path_length = 140e-9;
    o.cells_per_radius = cells;
    o.adhesion = {std::make_shared<fem::Dugdale>(closing, closing_range),
                  std::make_shared<fem::Dugdale>(opening, 1e-9)};
    return o;
  }

  PinnedContact(double cells, double closing, double opening, double closing_range)
      : contact(options(cells, closing, opening, closing_range)) {
    const double R = contact.options.radius, load = contact.options.load,
                 far_field = contact.solver.far_field_compliance(0.9 * contact.contact_radius);
    const double P = 0.4 * load;
    for (const double share : {0.85, 0.7, 0.55, 0.4}) contact.step({}, share * load);
    // The radius of the pinned contact from its stiffness 2 E* a.
    const double before = contact.state.approach;
    contact.step({}, 0.97 * P);
    const double stiffness = 1 / ((before - contact.state.approach) / (0.03 * P) - far_field);
    contact.step({}, P);
    const double modulus = contact.reduced_modulus, a = stiffness / (2 * modulus),
                 Pa = 4 * modulus * a * a * a / (3 * R);
    const double G = (Pa - P) * (Pa - P) / (6 * M_PI * R * Pa);
    surplus = Pa - P;
    critical = surplus * a / (3 * Pa) * std::min(1 - std::sqrt(closing / G), std::sqrt(opening / G) - 1);
    std::printf("pinned at a %.1f nm, G %.3f J/m^2, moves from xi %.1f nm\n", 1e9 * a, G, 1e9 * critical);
    contact.options.load = P;
    unrolled = contact.roll(0).rolling_moment;
  }

  /// Moment at a share of the critical roll, over that of a pinned rim there.
  double moment(double share) {
    const double xi = share * critical;
    const double moment = contact.roll(xi / contact.options.radius).rolling_moment - unrolled;
    has_lost =
        has_lost || std::abs(contact.adhesion_loss) > 1e-3 * surplus * xi * xi / contact.options.radius;
    std::printf("xi %.2f nm: M / ((P_a - P) xi) %.4f\n", 1e9 * xi, moment / (surplus * xi));
    return moment / (surplus * xi);
  }

  testing::AssertionResult resists_as_pinned(double share) {
    char what[96];
    std::snprintf(what, sizeof what, "pinned contact, a/h %g, rolled to %g of Krijt's critical roll: moment",
                  contact.options.cells_per_radius, share);
    return test::Verified{"Adhesion", what, "Dominik & Tielens (1995)"}.within(moment(share), 1, 0.05);
  }
};

TEST(AdhesiveRolling_analytic, a_pinned_contact_resists_as_Dominik_and_Tielens_found) {
  PinnedContact pinned(12, 0.02, 1, 1e-9);
  for (const double share : {0.25, 0.5, 0.75}) EXPECT_TRUE(pinned.resists_as_pinned(share));
  EXPECT_FALSE(pinned.has_lost);
}

/// Attraction that closes over a short range, Maugis' parameter 2: the rim is that of fracture mechanics. It
/// is held by cells, so that it moves by whole ones, and the moment leaves the pinned one's line some of a
/// spacing later than the theory's.
TEST(AdhesiveRollingNightly_analytic, the_rim_of_a_pinned_contact_moves_from_Krijts_critical_roll_on) {
  PinnedContact pinned(20, 0.15, 1, 0.3e-9);
  for (const double share : {0.5, 0.75, 1.0}) EXPECT_TRUE(pinned.resists_as_pinned(share));
  EXPECT_FALSE(pinned.has_lost);
  const auto verified = [](const char* share) {
    return test::Verified{"Adhesion",
                          std::string("pinned contact, a/h 20, rolled to ") + share +
                              " of Krijt's critical roll: moment over that there",
                          "it leaves the pinned one's line"};
  };
  EXPECT_TRUE(verified("1.4").below(1.4 * pinned.moment(1.4), 1.3));
  EXPECT_TRUE(verified("1.8").between(1.8 * pinned.moment(1.8), 1, 1.4));
  EXPECT_TRUE(pinned.has_lost);
}

TEST(AdhesiveFriction_analytic, attraction_adds_to_the_load_that_friction_feels) {
  FrictionalContactOptions o;
  o.cells_per_radius = 8, o.friction = 0.3, o.load = 30e-6;
  o.adhesion.closing = o.adhesion.opening = std::make_shared<fem::Dugdale>(0.3, 3e-9);
  FrictionalContact contact(o);
  const auto r = contact.shift(6e-9);
  EXPECT_EQ(r.sticking, 0);
  EXPECT_GT(r.attraction, 0.2 * o.load);
  const test::Verified verified{"Adhesion", "full slip with attraction, a/h 8", "mu (P + attraction)"};
  EXPECT_TRUE(verified.within(r.lateral_force[0], o.friction * (o.load + r.attraction), 0.01));
}

}  // namespace
