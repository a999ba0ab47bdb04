#include "core/json_text.h"

#include <algorithm>

#include "core/error.h"
#include "core/read_limits.h"

namespace asperity {
namespace {

[[noreturn]] void refuse(const std::string& text, std::size_t byte, const std::string& file,
                         const std::string& what) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  throw InputError(file + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')) + ": " + what);
}

/// ": unexpected '}', expected string literal", of a message that says where before " - " and what was read
/// last behind it.
std::string reason_of(const nlohmann::json::parse_error& error) {
  std::string message = error.what();
  const auto dash = message.find(" - ");
  if (dash == std::string::npos) return "";
  message.erase(0, dash + 3);
  if (const auto read = message.find("; last read: '"); read != std::string::npos) {
    const auto expected = message.find("'; expected ", read);
    message.erase(read, expected == std::string::npos ? expected : expected + 1 - read);
  }
  std::replace(message.begin(), message.end(), ';', ',');
  return ": " + message;
}

}  // namespace

std::optional<std::size_t> too_deep_at(const std::string& text) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;  // what follows is no end of the string
      else if (c == '"')
        in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > read_limits::deepest_nesting) return i;
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
  return std::nullopt;
}

nlohmann::ordered_json parse_json(const std::string& text, const std::string& file) {
  if (const auto byte = too_deep_at(text))
    refuse(text, *byte, file,
           "objects and lists are nested more than " + std::to_string(read_limits::deepest_nesting) +
               " deep; no file of asperity is: write it again");
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    refuse(text, error.byte, file,
           "this is not JSON here" + reason_of(error) + "; correct it or write it again");
  } catch (const nlohmann::json::exception&) {
    throw InputError(file + ": it holds a number beyond what a double can be; correct it");
  }
}

nlohmann::ordered_json json_if_valid(const std::string& text) {
  if (too_deep_at(text)) return nlohmann::ordered_json(nlohmann::ordered_json::value_t::discarded);
  return nlohmann::ordered_json::parse(text, nullptr, false);
}

}  // namespace asperity
