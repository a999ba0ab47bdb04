#include "core/quantity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

TEST(Quantity_analytic, reads_a_number_with_its_unit_into_SI) {
  EXPECT_DOUBLE_EQ(parse_quantity("2.5 um", Dimension::length), 2.5e-6);
  EXPECT_DOUBLE_EQ(parse_quantity(" 3000uN ", Dimension::force), 3e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("71 GPa", Dimension::pressure), 71e9);
  EXPECT_DOUBLE_EQ(parse_quantity("180 deg", Dimension::angle), M_PI);
  EXPECT_DOUBLE_EQ(parse_quantity("1e-6", Dimension::length), 1e-6);
  EXPECT_TRUE(std::isinf(parse_quantity("inf", Dimension::pressure)));
}

TEST(Quantity_analytic, each_unit_has_its_factor) {
  const std::vector<std::pair<Dimension, std::vector<std::pair<const char*, double>>>> units{
      {Dimension::none, {{"1", 1}, {"1 %", 0.01}}},
      {Dimension::length,
       {{"1 m", 1},
        {"1 cm", 1e-2},
        {"1 mm", 1e-3},
        {"1 um", 1e-6},
        {"1 nm", 1e-9},
        {"1 A", 1e-10},
        {"1 pm", 1e-12},
        {"1 km", 1e3}}},
      {Dimension::force,
       {{"1 N", 1}, {"1 mN", 1e-3}, {"1 uN", 1e-6}, {"1 nN", 1e-9}, {"1 pN", 1e-12}, {"1 kN", 1e3}}},
      {Dimension::pressure, {{"1 Pa", 1}, {"1 kPa", 1e3}, {"1 MPa", 1e6}, {"1 GPa", 1e9}, {"1 TPa", 1e12}}},
      {Dimension::time, {{"1 s", 1}, {"1 ms", 1e-3}, {"1 us", 1e-6}, {"1 min", 60}, {"1 h", 3600}}},
      {Dimension::angle, {{"1 rad", 1}, {"1 mrad", 1e-3}, {"1 urad", 1e-6}, {"1 deg", M_PI / 180}}},
      {Dimension::speed, {{"1 m/s", 1}, {"1 mm/s", 1e-3}, {"1 um/s", 1e-6}, {"1 nm/s", 1e-9}}},
      {Dimension::surface_energy, {{"1 J/m^2", 1}, {"1 mJ/m^2", 1e-3}, {"1 N/m", 1}, {"1 mN/m", 1e-3}}},
      {Dimension::area, {{"1 m^2", 1}, {"1 mm^2", 1e-6}, {"1 um^2", 1e-12}, {"1 nm^2", 1e-18}}},
      {Dimension::stiffness,
       {{"1 N/m", 1}, {"1 kN/m", 1e3}, {"1 MN/m", 1e6}, {"1 uN/nm", 1e3}, {"1 mN/um", 1e3}}},
      {Dimension::temperature, {{"1 K", 1}}},
      {Dimension::voltage, {{"1 V", 1}, {"1 mV", 1e-3}, {"1 uV", 1e-6}, {"1 kV", 1e3}}},
      {Dimension::molar_volume, {{"1 m^3/mol", 1}, {"1 cm^3/mol", 1e-6}}}};
  for (const auto& [dimension, list] : units)
    for (const auto& [text, value] : list)
      EXPECT_NEAR(parse_quantity(text, dimension) / value, 1, 1e-14) << text;
}

const std::vector<std::pair<Dimension, std::string>>& si_symbols() {
  static const std::vector<std::pair<Dimension, std::string>> symbols{{Dimension::none, ""},
                                                                      {Dimension::length, "m"},
                                                                      {Dimension::force, "N"},
                                                                      {Dimension::pressure, "Pa"},
                                                                      {Dimension::time, "s"},
                                                                      {Dimension::angle, "rad"},
                                                                      {Dimension::speed, "m/s"},
                                                                      {Dimension::surface_energy, "J/m^2"},
                                                                      {Dimension::area, "m^2"},
                                                                      {Dimension::stiffness, "N/m"},
                                                                      {Dimension::voltage, "V"},
                                                                      {Dimension::temperature, "K"},
                                                                      {Dimension::molar_volume, "m^3/mol"}};
  return symbols;
}

TEST(Quantity_analytic, the_SI_unit_of_each_dimension_has_the_factor_1) {
  for (const auto& [dimension, symbol] : si_symbols()) {
    EXPECT_EQ(si_symbol(dimension), symbol);
    EXPECT_EQ(unit_factor(symbol, dimension), 1) << symbol;
    EXPECT_EQ(parse_quantity("-3.5 " + symbol, dimension), -3.5) << symbol;
  }
  EXPECT_EQ(unit_factor("", Dimension::none), 1);
}

TEST(Quantity_analytic, other_spellings_of_a_unit_have_its_factor) {
  for (const char* micro : {"u", "\u00b5", "\u03bc"}) {  // the micro sign and the Greek letter
    EXPECT_DOUBLE_EQ(parse_quantity(std::string("8.5 ") + micro + "m", Dimension::length), 8.5e-6) << micro;
    EXPECT_DOUBLE_EQ(parse_quantity(std::string("8.5 ") + micro + "N", Dimension::force), 8.5e-6) << micro;
  }
  EXPECT_DOUBLE_EQ(parse_quantity("3 \u00c5", Dimension::length), 3e-10);
  EXPECT_DOUBLE_EQ(parse_quantity("90\u00b0", Dimension::angle), M_PI / 2);
}

TEST(Quantity_analytic, any_prefix_that_is_written_is_read) {
  const std::vector<std::pair<std::string, double>> prefixes{
      {"T", 1e12}, {"G", 1e9}, {"M", 1e6}, {"k", 1e3}, {"m", 1e-3}, {"u", 1e-6}, {"n", 1e-9}, {"p", 1e-12}};
  for (const auto& [dimension, symbol] : si_symbols())
    for (const auto& [prefix, factor] : prefixes) {
      if (dimension == Dimension::none || dimension == Dimension::area || dimension == Dimension::angle ||
          dimension == Dimension::molar_volume)
        continue;
      EXPECT_EQ(format_quantity(2 * factor, dimension), "2 " + prefix + symbol);
      EXPECT_NEAR(unit_factor(prefix + symbol, dimension) / factor, 1, 1e-14) << prefix << symbol;
    }
}

TEST(Quantity_behaviour, a_refusal_names_the_text_and_the_units_that_fit) {
  const auto message = [](const std::string& text, Dimension dimension) {
    return test::message_of<InputError>([&] { parse_quantity(text, dimension); });
  };
  EXPECT_EQ(message(" 2 GPa", Dimension::time),
            "in '2 GPa' the unit 'GPa' does not fit; use one of s, ms, us, min, h");
  EXPECT_EQ(message("2 m", Dimension::none), "in '2 m' the unit 'm' does not fit; use one of %");
  EXPECT_EQ(message("um", Dimension::length), "'um' is not a number with a unit; write for example '2.5 m'");
  EXPECT_EQ(message(" ", Dimension::force), "' ' is not a number with a unit; write for example '2.5 N'");
  EXPECT_THROW(unit_factor("km^2", Dimension::area), InputError);  // 1e6 or 1e3?
  EXPECT_THROW(unit_factor("k", Dimension::none), InputError);
  EXPECT_THROW(unit_factor("krad", Dimension::angle), InputError);
}

TEST(Quantity_behaviour, what_has_no_prefix_is_written_in_SI_or_as_a_plain_number) {
  EXPECT_EQ(format_quantity(1e-13, Dimension::length), "1e-13 m");  // below the smallest prefix
  EXPECT_EQ(format_quantity(-2.5e-6, Dimension::length), "-2.5 um");
  EXPECT_EQ(format_quantity(0.02, Dimension::angle), "0.02 rad");
  EXPECT_EQ(format_quantity(3e-12, Dimension::area), "3e-12 m^2");
  EXPECT_EQ(format_quantity(1.0 / 3, Dimension::none), "0.333");
  EXPECT_EQ(format_quantity(1.0 / 3, Dimension::none, 5), "0.33333");
  EXPECT_EQ(format_quantity(-INFINITY, Dimension::pressure), "-inf");
  EXPECT_EQ(format_quantity(5e15, Dimension::pressure), "5e+03 TPa");
}

TEST(Quantity_behaviour, refuses_what_is_no_quantity_of_that_dimension) {
  EXPECT_THROW(parse_quantity("", Dimension::length), InputError);
  EXPECT_THROW(parse_quantity("um", Dimension::length), InputError);
  EXPECT_THROW(parse_quantity("2.5 GPa", Dimension::length), InputError);
  EXPECT_THROW(parse_quantity("2.5 um um", Dimension::length), InputError);
  EXPECT_THROW(parse_quantity("nan", Dimension::length), InputError);
}

TEST(Quantity_behaviour, is_written_with_a_readable_prefix) {
  EXPECT_EQ(format_quantity(2.5e-6, Dimension::length), "2.5 um");
  EXPECT_EQ(format_quantity(1e-3, Dimension::force), "1 mN");
  EXPECT_EQ(format_quantity(71e9, Dimension::pressure), "71 GPa");
  EXPECT_EQ(format_quantity(0, Dimension::length), "0 m");
  EXPECT_EQ(format_quantity(849e-12, Dimension::length), "849 pm");
}

TEST(Quantity_behaviour, what_rounds_to_a_thousand_takes_the_next_prefix) {
  EXPECT_EQ(format_quantity(0.99999e-9, Dimension::length), "1 nm");
  EXPECT_EQ(format_quantity(-999.9e-6, Dimension::force), "-1 mN");
  EXPECT_EQ(format_quantity(999.4e-12, Dimension::length), "999 pm");
  EXPECT_EQ(format_quantity(0.99999e-9, Dimension::length, 6), "999.99 pm");
}

TEST(Quantity_behaviour, hundreds_in_two_digits_have_no_exponent) {
  EXPECT_EQ(format_quantity(316e-6, Dimension::length, 2), "320 um");
  EXPECT_EQ(format_quantity(-316e-6, Dimension::length, 1), "-300 um");
  EXPECT_EQ(format_quantity(1.26e-6, Dimension::length, 2), "1.3 um");
  EXPECT_EQ(format_quantity(99.6e-9, Dimension::force, 2), "100 nN");
}

TEST(Quantity_analytic, is_read_as_it_is_written_whatever_its_magnitude) {
  for (const Dimension dimension :
       {Dimension::none, Dimension::length, Dimension::force, Dimension::pressure, Dimension::time,
        Dimension::angle, Dimension::speed, Dimension::surface_energy, Dimension::area, Dimension::stiffness,
        Dimension::temperature, Dimension::voltage, Dimension::molar_volume})
    for (double value = 1.5e-15; value < 1e16; value *= 10)
      EXPECT_NEAR(parse_quantity(format_quantity(value, dimension), dimension), value, 1e-12 * value)
          << format_quantity(value, dimension);
}

TEST(Quantity_analytic, what_follows_a_nul_is_no_blank) {
  EXPECT_THROW(parse_quantity(std::string("1\0 um", 5), Dimension::length), InputError);
}

}  // namespace asperity
