#include "core/written_apart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity {
namespace {

TEST(WrittenApart_behaviour, numbers_that_differ_are_seen_to_differ) {
  using Texts = std::pair<std::string, std::string>;
  EXPECT_EQ(quantities_apart(1.1321e-6, 1.1306e-6, Dimension::length), (Texts{"1.132 um", "1.131 um"}));
  EXPECT_EQ(quantities_apart(2.5e-6, 1e-6, Dimension::length), (Texts{"2.5 um", "1 um"}));
  EXPECT_EQ(quantities_apart(1e-6, 1e-6, Dimension::length), (Texts{"1 um", "1 um"}));
  EXPECT_EQ(percents_apart(0.010001, 0.01), (Texts{"1.0001 %", "1 %"}));
}

TEST(WrittenApart_behaviour, equal_numbers_keep_to_three_digits) {
  using Texts = std::pair<std::string, std::string>;
  EXPECT_EQ(quantities_apart(1e-6 / 3, 1e-6 / 3, Dimension::length), (Texts{"333 nm", "333 nm"}));
  EXPECT_EQ(percents_apart(2.0 / 3, 2.0 / 3), (Texts{"66.7 %", "66.7 %"}));
}

TEST(WrittenApart_behaviour, no_more_digits_are_taken_than_tell_apart) {
  std::vector<int> tried;
  const auto write = [&](double value, int digits) {
    tried.push_back(digits);
    return format_quantity(value, Dimension::none, digits);
  };
  written_apart(1.00001, 1.00002, write);
  EXPECT_EQ(tried, (std::vector<int>{3, 3, 4, 4, 5, 5, 6, 6}));
}

TEST(WrittenApart_analytic, seventeen_digits_tell_any_two_numbers_apart) {
  const auto texts = quantities_apart(1, std::nextafter(1.0, 2.0), Dimension::length);
  EXPECT_EQ(texts.first, "1 m");
  EXPECT_EQ(texts.second, "1.0000000000000002 m");
}

TEST(WrittenApart_behaviour, what_no_number_of_digits_tells_apart_is_written_the_same) {
  const auto texts = quantities_apart(std::nan(""), std::nan(""), Dimension::length);
  EXPECT_EQ(texts.first, texts.second);
}

}  // namespace
}  // namespace asperity
