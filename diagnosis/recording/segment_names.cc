#include "diagnosis/recording/segment_names.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "core/joined.h"
#include "core/printable.h"
#include "diagnosis/recording/recording.h"

namespace asperity {

std::optional<std::string> segment_meant_by(const std::string& written) {
  std::string name = written;
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* known : {"load", "hold", "unload", "forward", "backward"})
    if (name == known) return name;
  return std::nullopt;
}

std::string remark_on_segment_names(const Recording& recording) {
  std::set<std::string> others;
  for (const auto& table : recording.tables)
    if (table.kind == TableKind::trace)
      for (const auto& name : table.segment)
        if (!name.empty() && !segment_meant_by(name)) others.insert(name);
  if (others.empty()) return "";
  constexpr std::size_t most_named = 5;
  std::vector<std::string> named;
  for (const auto& name : others)
    if (named.size() < most_named) named.push_back("'" + printable(name) + "'");
  return "segments are named " + joined(named, ", ") + (others.size() > most_named ? " and others" : "") +
         ", which is none of load, hold, unload, forward and backward: loading, holds and returns were read "
         "off "
         "the driven motion";
}

}  // namespace asperity
