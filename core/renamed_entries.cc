#include "core/renamed_entries.h"

#include "core/error.h"

namespace asperity {

const std::vector<RenamedEntry>& renamed_entries() {
  static const std::vector<RenamedEntry> entries{
      {"Experiment/Way back", "Experiment/Return distance"},
      {"Interface/Opening work", "Interface/Work of adhesion on separation"}};
  return entries;
}

std::string present_path(const std::string& path) {
  for (const auto& entry : renamed_entries())
    if (path == entry.former) return entry.present;
  return path;
}

std::string former_path(const std::string& path) {
  for (const auto& entry : renamed_entries())
    if (path == entry.present) return entry.former;
  return path;
}

void use_present_name(Setting& setting) {
  const std::string present = present_path(setting.path()), varied = present_path(setting.entry);
  if (present == setting.path() && varied == setting.entry) return;
  setting.former = setting.entry;
  setting.entry = varied != setting.entry ? varied : present.substr(present.rfind('/') + 1);
}

void use_present_names(Settings& settings) {
  for (auto& setting : settings) use_present_name(setting);
  for (const auto& old : settings)
    for (const auto& other : settings)
      if (!old.former.empty() && other.former.empty() && other.path() == old.path())
        throw InputError(old.where + ": '" + old.former + "' is the former name of '" + old.entry +
                         "', which is given as well (" + other.where + "); remove '" + old.former + "'");
}

std::vector<std::string> hints_of_former_names(const Settings& settings) {
  std::vector<std::string> hints;
  for (const auto& setting : settings)
    if (!setting.former.empty())
      hints.push_back(setting.where + ": '" + setting.former.substr(setting.former.rfind('/') + 1) +
                      "' is now called '" + setting.entry + "'; the former name is still read");
  return hints;
}

}  // namespace asperity
