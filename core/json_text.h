// JSON from files: the one way in which all folders parse it, so that nesting is limited everywhere.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace asperity {

/// Byte at which objects and lists are nested deeper than read_limits::deepest_nesting; none: empty. Copying,
/// writing and comparing JSON values recurses, so that deep nesting would overflow the stack.
std::optional<std::size_t> too_deep_at(const std::string& text);

/// The JSON of a file's text. Throws InputError naming file and line where it is none or nested too deep.
nlohmann::ordered_json parse_json(const std::string& text, const std::string& file);

/// The same where a file that is damaged or cut off counts as absent: is_discarded() then.
nlohmann::ordered_json json_if_valid(const std::string& text);

}  // namespace asperity
