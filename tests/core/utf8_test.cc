#include "core/utf8.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace asperity {
namespace {

/// What nlohmann::json says of the same text.
bool json_takes(const std::string& text) {
  try {
    nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

TEST(Utf8_other_code, is_judged_as_a_JSON_library_does) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second)
      for (const char* rest : {"", "\x80", "\x80\x80", "\xBF\xBF", "a"}) {
        const std::string text = std::string{static_cast<char>(first), static_cast<char>(second)} + rest;
        ASSERT_EQ(is_utf8(text), json_takes(text))
            << first << " " << second << " and " << std::string(rest).size();
      }
}

TEST(Utf8_analytic, latin_1_becomes_utf8_and_utf8_stays) {
  EXPECT_EQ(as_utf8("H\xF6he in \xB5m"), "Höhe in µm");
  EXPECT_EQ(as_utf8("Höhe in µm"), "Höhe in µm");
}

}  // namespace
}  // namespace asperity
