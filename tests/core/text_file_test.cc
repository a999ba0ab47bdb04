#include "core/text_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/printed.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/utf16.h"

namespace asperity {
namespace {

using test::Order;
using test::utf16_bytes;

/// The character as nlohmann::json reads it from the escape of its 16-bit units.
std::string of_json(const std::u16string& units) {
  std::string escapes;
  for (const char16_t unit : units) escapes += printed("\\u%04x", static_cast<unsigned int>(unit));
  return nlohmann::json::parse("\"" + escapes + "\"").get<std::string>();
}

TEST(TextOfUtf16_other_code, is_what_a_JSON_library_makes_of_the_same_units) {
  for (unsigned int c = 0x20; c < 0x10000; c += c < 0x900 ? 1 : 97) {
    if (c >= 0xd800 && c < 0xe000) continue;
    const std::u16string unit(1, static_cast<char16_t>(c));
    for (const Order order : {Order::little, Order::big})
      ASSERT_EQ(text_of_utf16(utf16_bytes(unit, order)), of_json(unit)) << c;
  }
  for (const std::u16string pair : {u"\xd800\xdc00", u"\xd83d\xde00", u"\xdbff\xdfff"})
    EXPECT_EQ(text_of_utf16(utf16_bytes(pair, Order::little)), of_json(pair));
}

TEST(TextOfUtf16_behaviour, is_none_of_what_is_no_text) {
  EXPECT_FALSE(text_of_utf16("run,time"));  // no mark
  EXPECT_FALSE(
      text_of_utf16("\xFF\xFE"
                    "a"));                                          // half a character
  EXPECT_FALSE(text_of_utf16(std::string("\xFF\xFE\x01\x00", 4)));  // a control character
  EXPECT_FALSE(text_of_utf16(std::string("\xFF\xFE\x00\x00", 4)));
  for (const std::u16string alone : {u"\xd800", u"\xd800z", u"\xdc00\xd800"})  // half of a pair
    EXPECT_FALSE(text_of_utf16(utf16_bytes(alone, Order::little)));
  EXPECT_EQ(text_of_utf16("\xFF\xFE"), "");
}

TEST(PlainText_behaviour, is_the_same_from_every_program_that_saved_it) {
  const std::string text = "a,µ\n\n1,2\n";
  for (const std::string saved :
       {text, "\xEF\xBB\xBF" + text, std::string("a,\xB5\n\n1,2\n"), std::string("a,µ\r\n\r\n1,2\r\n"),
        std::string("a,µ\r\r1,2\r"), utf16_bytes(u"a,µ\r\n\r\n1,2\r\n", Order::little),
        utf16_bytes(u"a,µ\n\n1,2\n", Order::big)})
    EXPECT_EQ(plain_text(saved), text);
}

TEST(ReadTextFile_behaviour, refuses_what_is_binary) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("t.csv", std::string("a\0b", 3));
  EXPECT_EQ(test::message_of<InputError>([&] { read_text_file(file); }),
            file.string() + ": is binary, not text; export it as text");
  EXPECT_EQ(read_text_file(folder.write("u.csv",
                                        "\xEF\xBB\xBF"
                                        "a\r\n")),
            "a\n");
}

}  // namespace
}  // namespace asperity
