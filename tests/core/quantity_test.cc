#include "core/quantity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace asperity {

TEST(Quantity, reads_a_number_with_its_unit_into_SI) {
  EXPECT_DOUBLE_EQ(parse_quantity("2.5 um", Dimension::length), 2.5e-6);
  EXPECT_DOUBLE_EQ(parse_quantity(" 3000uN ", Dimension::force), 3e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("71 GPa", Dimension::pressure), 71e9);
  EXPECT_DOUBLE_EQ(parse_quantity("180 deg", Dimension::angle), M_PI);
  EXPECT_DOUBLE_EQ(parse_quantity("1e-6", Dimension::length), 1e-6);
  EXPECT_TRUE(std::isinf(parse_quantity("inf", Dimension::pressure)));
}

TEST(Quantity, refuses_what_is_no_quantity_of_that_dimension) {
  EXPECT_THROW(parse_quantity("", Dimension::length), InputError);
  EXPECT_THROW(parse_quantity("um", Dimension::length), InputError);
  EXPECT_THROW(parse_quantity("2.5 GPa", Dimension::length), InputError);
  EXPECT_THROW(parse_quantity("2.5 um um", Dimension::length), InputError);
  EXPECT_THROW(parse_quantity("nan", Dimension::length), InputError);
}

TEST(Quantity, is_written_with_a_readable_prefix) {
  EXPECT_EQ(format_quantity(2.5e-6, Dimension::length), "2.5 um");
  EXPECT_EQ(format_quantity(1e-3, Dimension::force), "1 mN");
  EXPECT_EQ(format_quantity(71e9, Dimension::pressure), "71 GPa");
  EXPECT_EQ(format_quantity(0, Dimension::length), "0 m");
  EXPECT_EQ(format_quantity(849e-12, Dimension::length), "849 pm");
}

TEST(Quantity, what_rounds_to_a_thousand_takes_the_next_prefix) {
  EXPECT_EQ(format_quantity(0.99999e-9, Dimension::length), "1 nm");
  EXPECT_EQ(format_quantity(-999.9e-6, Dimension::force), "-1 mN");
  EXPECT_EQ(format_quantity(999.4e-12, Dimension::length), "999 pm");
  EXPECT_EQ(format_quantity(0.99999e-9, Dimension::length, 6), "999.99 pm");
}

TEST(Quantity_analytic, is_read_as_it_is_written_whatever_its_magnitude) {
  for (const Dimension dimension : {Dimension::none, Dimension::length, Dimension::force, Dimension::pressure, Dimension::time,
                                    Dimension::angle, Dimension::speed, Dimension::surface_energy, Dimension::area, Dimension::stiffness})
    for (double value = 1.5e-15; value < 1e16; value *= 10)
      EXPECT_NEAR(parse_quantity(format_quantity(value, dimension), dimension), value, 1e-12 * value) << format_quantity(value, dimension);
}

TEST(Quantity_analytic, what_follows_a_nul_is_no_blank) {
  EXPECT_THROW(parse_quantity(std::string("1\0 um", 5), Dimension::length), InputError);
}

}  // namespace asperity
