// Words that are near each other, and times to wait.
#include <gtest/gtest.h>

#include "core/nearest_name.h"
#include "core/wait_text.h"

namespace asperity {
namespace {

TEST(EditDistance_analytic, counts_insertions_deletions_replacements_and_swaps_of_neighbours) {
  EXPECT_EQ(edit_distance("load", "load"), 0);
  EXPECT_EQ(edit_distance("load", "Loads"), 1);
  EXPECT_EQ(edit_distance("load", "lad"), 1);
  EXPECT_EQ(edit_distance("load", "lead"), 1);
  EXPECT_EQ(edit_distance("load", "laod"), 1);
  EXPECT_EQ(edit_distance("abcd", "badc"), 2);  // two swaps
  EXPECT_EQ(edit_distance("abc", "ca"), 3);  // optimal string alignment: what was swapped is not edited again
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("aab", "bba"), 2);  // a swap counts only where both letters change places
  EXPECT_EQ(edit_distance("xay", "zby"), 2);
}

TEST(NearestName_behaviour, is_meant_with_up_to_half_of_its_letters_wrong) {
  EXPECT_EQ(nearest_name("abxy", {"abcd"}), "abcd");
  EXPECT_EQ(nearest_name("axyz", {"abcd"}), "");
  EXPECT_EQ(nearest_name("slid", {"roll", "slide", "spin"}), "slide");
}

TEST(WaitText_behaviour, is_in_seconds_minutes_or_hours_by_its_size) {
  EXPECT_EQ(wait_text(42), "42 s");
  EXPECT_EQ(wait_text(89), "89 s");
  EXPECT_EQ(wait_text(90), "2 min");
  EXPECT_EQ(wait_text(180), "3 min");
  EXPECT_EQ(wait_text(5390), "90 min");
  EXPECT_EQ(wait_text(5400), "1.5 h");
  EXPECT_EQ(wait_text(5760), "1.6 h");
}

}  // namespace
}  // namespace asperity
