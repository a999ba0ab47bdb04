#include "core/text_file.h"

#include <utility>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/utf8.h"

namespace asperity {
namespace {

void append_utf8(char32_t character, std::string& text) {
  const auto part = [&](int shift, unsigned int lead, unsigned int mask) {
    text += static_cast<char>(lead | ((character >> shift) & mask));
  };
  if (character < 0x80) return part(0, 0, 0x7f);
  if (character < 0x800) {
    part(6, 0xc0, 0x1f);
  } else if (character < 0x10000) {
    part(12, 0xe0, 0x0f);
    part(6, 0x80, 0x3f);
  } else {
    part(18, 0xf0, 0x07);
    part(12, 0x80, 0x3f);
    part(6, 0x80, 0x3f);
  }
  part(0, 0x80, 0x3f);
}

bool is_control(char32_t character) {
  return character < 0x20 && character != '\t' && character != '\n' && character != '\r' && character != '\f';
}

std::string with_lines_ended_alike(const std::string& text) {
  if (text.find('\r') == std::string::npos) return text;
  std::string alike;
  alike.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r')
      alike += text[i];
    else if (i + 1 == text.size() || text[i + 1] != '\n')
      alike += '\n';
  }
  return alike;
}

}  // namespace

std::optional<std::string> text_of_utf16(const std::string& bytes) {
  const bool little = bytes.compare(0, 2, "\xFF\xFE") == 0, big = bytes.compare(0, 2, "\xFE\xFF") == 0;
  if ((!little && !big) || bytes.size() % 2 != 0) return std::nullopt;
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<unsigned char>(bytes[at]),
               second = static_cast<unsigned char>(bytes[at + 1]);
    return static_cast<char32_t>(little ? first | (second << 8) : (first << 8) | second);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 2; at < bytes.size(); at += 2) {
    char32_t character = unit(at);
    if (character >= 0xd800 && character < 0xe000) {  // the first of two that make one character
      const char32_t low = at + 2 < bytes.size() ? unit(at + 2) : 0;
      if (character >= 0xdc00 || low < 0xdc00 || low >= 0xe000) return std::nullopt;
      character = 0x10000 + ((character - 0xd800) << 10) + (low - 0xdc00);
      at += 2;
    }
    if (is_control(character)) return std::nullopt;
    append_utf8(character, text);
  }
  return text;
}

std::string plain_text(std::string bytes) {
  if (auto text = text_of_utf16(bytes)) return with_lines_ended_alike(*text);
  if (bytes.compare(0, 3, "\xEF\xBB\xBF") == 0) bytes.erase(0, 3);
  return with_lines_ended_alike(as_utf8(std::move(bytes)));
}

std::string read_text_file(const std::filesystem::path& path) {
  std::string text = plain_text(read_file(path));
  if (text.find('\0') != std::string::npos)
    throw InputError(path.string() + ": is binary, not text; export it as text");
  return text;
}

}  // namespace asperity
