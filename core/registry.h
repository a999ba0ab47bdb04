// Registries: everything of a kind (laws, engines, experiments, formats, effects) that is linked, by its
// name.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/nearest_name.h"

namespace asperity {

/// Adds an entry to those of its kind, before main: a constant outside of all functions,
/// `inline const Registered<Entry> name{entry};`. Registries are to be read after main has begun.
template <class Entry>
class Registered {
 public:
  explicit Registered(Entry entry) { list().push_back(std::move(entry)); }
  /// In the order of linking, which says nothing.
  static const std::vector<Entry>& all() { return list(); }

 private:
  static std::vector<Entry>& list() {
    static std::vector<Entry> entries;  // in a function: filled while other constants are still being set up
    return entries;
  }
};

/// The entries in the order of their names. Throws std::logic_error if two have the same.
template <class Entry, class NameOf>
std::vector<Entry> in_order_of_names(std::vector<Entry> entries, NameOf name_of) {
  std::sort(entries.begin(), entries.end(),
            [&](const auto& a, const auto& b) { return name_of(a) < name_of(b); });
  for (std::size_t i = 1; i < entries.size(); ++i)
    if (name_of(entries[i - 1]) == name_of(entries[i]))
      throw std::logic_error("there are two entries '" + std::string(name_of(entries[i])) + "'");
  return entries;
}

/// What those makers make, beside `found` that the build has found, in the order of names.
template <class Entry, class NameOf>
std::vector<Entry> with_registered_makers(std::vector<Entry> found, NameOf name_of) {
  for (const auto make : Registered<Entry (*)()>::all()) found.push_back(make());
  return in_order_of_names(std::move(found), name_of);
}

/// The entry of that name. Throws InputError "REFUSAL 'name'", with the nearest name, or all that there are.
template <class Entry, class NameOf>
const Entry& entry_named(const std::vector<Entry>& entries, const std::string& name, NameOf name_of,
                         const std::string& refusal) {
  std::vector<std::string> names;
  for (const auto& entry : entries) {
    if (name_of(entry) == name) return entry;
    names.push_back(name_of(entry));
  }
  throw InputError(refusal + " '" + name + "'; " + did_you_mean(name, names));
}

}  // namespace asperity
