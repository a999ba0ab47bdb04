// Calls in a case file's entry: "name(first, key=value, key=value)".
#pragma once

#include <functional>
#include <string>

namespace asperity {

/// Without blanks at both ends.
std::string without_outer_blanks(const std::string& text);

/// True if `text` begins with `name` and an opening parenthesis, or is `name` alone.
bool is_entry_call(const std::string& text, const std::string& name);

/// Passes each argument to `take`: its key ("" where none is written) and its value. Throws InputError naming
/// the argument that stands twice, or what `take` refuses; `example` shows how to write such a call.
void read_entry_call(const std::string& text, const std::string& name, const std::string& example,
                     const std::function<void(const std::string& key, const std::string& value)>& take);

}  // namespace asperity
