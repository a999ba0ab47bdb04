#include "core/written_apart.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(WrittenApart_behaviour, numbers_that_differ_are_seen_to_differ) {
  using Texts = std::pair<std::string, std::string>;
  EXPECT_EQ(quantities_apart(1.1321e-6, 1.1306e-6, Dimension::length), (Texts{"1.132 um", "1.131 um"}));
  EXPECT_EQ(quantities_apart(2.5e-6, 1e-6, Dimension::length), (Texts{"2.5 um", "1 um"}));
  EXPECT_EQ(quantities_apart(1e-6, 1e-6, Dimension::length), (Texts{"1 um", "1 um"}));
  EXPECT_EQ(percents_apart(0.010001, 0.01), (Texts{"1.0001 %", "1 %"}));
}

}  // namespace
}  // namespace asperity
