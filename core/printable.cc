#include "core/printable.h"

#include "core/printed.h"

namespace asperity {
namespace {

/// Length of the UTF-8 sequence that begins with `lead`; 0 if none does.
int sequence_length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return 2;
  if (lead >= 0xe0 && lead < 0xf0) return 3;
  if (lead >= 0xf0 && lead < 0xf5) return 4;
  return 0;
}

/// The character at `at` and the bytes it takes. Overlong forms, surrogates and what lies beyond U+10FFFF are
/// no characters.
CodePoint decode(const std::string& text, std::size_t at, std::size_t& bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const CodePoint invalid{byte(at), false};
  const int length = sequence_length(byte(at));
  bytes = 1;
  if (length == 0 || at + static_cast<std::size_t>(length) > text.size()) return invalid;
  if (length == 1) return {byte(at), true};
  char32_t value = byte(at) & (0x7fu >> length);
  for (int i = 1; i < length; ++i) {
    const unsigned char next = byte(at + static_cast<std::size_t>(i));
    if ((next & 0xc0u) != 0x80u) return invalid;
    value = (value << 6) | (next & 0x3fu);
  }
  constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (value < smallest[length] || value > 0x10ffff || (value >= 0xd800 && value < 0xe000)) return invalid;
  bytes = static_cast<std::size_t>(length);
  return {value, true};
}

/// Control characters, and marks that hide or turn the direction (Unicode 15, general category Cf and the two
/// separators of lines).
bool hides_or_turns(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xad || c == 0x61c || (c >= 0x200b && c <= 0x200f) ||
         (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff ||
         (c >= 0xfff9 && c <= 0xfffb) || (c >= 0xe0000 && c <= 0xe0fff);
}

}  // namespace

void for_each_code_point(const std::string& text, const std::function<void(const CodePoint&)>& action) {
  std::size_t bytes = 0;
  for (std::size_t at = 0; at < text.size(); at += bytes) action(decode(text, at, bytes));
}

std::string escape_sequence(const CodePoint& character) {
  const auto value = static_cast<unsigned long>(character.value);
  const bool is_byte = !character.is_valid || value < 0x80;
  return printed(is_byte ? "\\x%02lx" : value < 0x10000 ? "\\u%04lx" : "\\U%08lx", value);
}

std::string printable_lines(const std::string& text) {
  std::string lines;
  std::size_t bytes = 0;
  for (std::size_t at = 0; at < text.size(); at += bytes) {
    const CodePoint character = decode(text, at, bytes);
    const bool stays = character.is_valid && (character.value == '\n' || character.value == '\t' ||
                                              !hides_or_turns(character.value));
    lines += stays ? text.substr(at, bytes) : escape_sequence(character);
  }
  return lines;
}

std::string printable(const std::string& text) {
  std::string line;
  for_each_code_point(text, [&](const CodePoint& character) {
    if (character.is_visible_ascii())
      line += static_cast<char>(character.value);
    else if (character.value == '\n')
      line += "\\n";
    else if (character.value == '\r')
      line += "\\r";
    else
      line += escape_sequence(character);
  });
  return line;
}

}  // namespace asperity
