#include "core/printable.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(Printable_analytic, leaves_visible_ascii_and_escapes_the_rest) {
  EXPECT_EQ(printable("a b~!\"\\"), "a b~!\"\\");
  EXPECT_EQ(printable("a\nb\r\tc\v\f"), "a\\nb\\r\\x09c\\x0b\\x0c");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\x1b[31m\x7f"), "\\x1b[31m\\x7f");
  EXPECT_EQ(printable("\u00b5N \u2028 \u202e \U0001d400"), "\\u00b5N \\u2028 \\u202e \\U0001d400");
}

TEST(PrintableLines_behaviour, leave_lines_and_scripts_and_escape_what_hides_or_turns) {
  EXPECT_EQ(printable_lines("5 \u00b5N, H\u00f6he,\n\t\u9ad8\u3055 \U0001d400"),
            "5 \u00b5N, H\u00f6he,\n\t\u9ad8\u3055 \U0001d400");
  EXPECT_EQ(printable_lines("\x1b]0;x\x07\r"), "\\x1b]0;x\\x07\\x0d");
  EXPECT_EQ(printable_lines(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable_lines("\ufeffrun \u202egnp.exe\u200b \u2028 \u0085"),
            "\\ufeffrun \\u202egnp.exe\\u200b \\u2028 \\u0085");
  EXPECT_EQ(printable_lines("\xb5N"), "\\xb5N");
}

TEST(Printable_analytic, escapes_byte_by_byte_what_is_no_utf_8) {
  EXPECT_EQ(printable("\xff"), "\\xff");
  EXPECT_EQ(printable("\xc2"), "\\xc2");           // cut off
  EXPECT_EQ(printable("\xc0\x8a"), "\\xc0\\x8a");  // overlong line break
  EXPECT_EQ(printable("\xe0\x80\x8a"), "\\xe0\\x80\\x8a");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
  EXPECT_EQ(printable("\xe2\x80\n"), "\\xe2\\x80\\n");
}

}  // namespace
}  // namespace asperity
