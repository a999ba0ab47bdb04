#include "core/entry_call.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "core/error.h"

namespace asperity {

std::string without_outer_blanks(const std::string& text) {
  const auto is_space = [](unsigned char c) { return std::isspace(c); };
  const auto first = std::find_if_not(text.begin(), text.end(), is_space);
  const auto last = std::find_if_not(text.rbegin(), std::make_reverse_iterator(first), is_space).base();
  return std::string(first, last);
}

bool is_entry_call(const std::string& text, const std::string& name) {
  const std::string call = without_outer_blanks(text);
  if (call.compare(0, name.size(), name) != 0) return false;
  const std::string rest = without_outer_blanks(call.substr(name.size()));
  return rest.empty() || rest.front() == '(';
}

void read_entry_call(const std::string& text, const std::string& name, const std::string& example,
                     const std::function<void(const std::string&, const std::string&)>& take) {
  const std::string call = without_outer_blanks(text);
  const auto open = call.find('(');
  if (!is_entry_call(call, name) || open == std::string::npos || call.back() != ')')
    throw InputError("'" + text + "' is not a call of " + name + "; write for example " + example);
  std::set<std::string> seen;
  const std::string arguments = without_outer_blanks(call.substr(open + 1, call.size() - open - 2));
  for (std::size_t begin = 0; begin < arguments.size();) {
    const std::size_t end = std::min(arguments.find(',', begin), arguments.size());
    const std::string argument = arguments.substr(begin, end - begin);
    begin = end + 1;
    const auto equals = argument.find('=');
    const bool has_key = equals != std::string::npos;
    const std::string key = has_key ? without_outer_blanks(argument.substr(0, equals)) : "";
    const std::string value = without_outer_blanks(has_key ? argument.substr(equals + 1) : argument);
    if (has_key && !seen.insert(key).second)
      throw InputError("in '" + text + "' the entry '" + key + "' stands twice");
    try {
      take(key, value);
    } catch (const InputError& error) {
      throw InputError("in '" + text + "' at '" + (has_key ? key : value) + "': " + error.what());
    }
  }
}

}  // namespace asperity
