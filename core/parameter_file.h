// Parameter files as deal.II's ParameterHandler reads them (.prm: subsection, set, end, include, '#'
// comments,
// '\' continuation) or JSON, as a flat list of settings that remember where they stand.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// One `set Entry = value`, with the subsections it stands in.
struct Setting {
  std::string section;      ///< "Particle"; nested ones joined, "Study/Vary"; "" at the top
  std::string entry;        ///< "Radius"
  std::string value;        ///< as written, blanks at both ends removed
  std::string where;        ///< "case.prm:12", or the override it came from
  std::string former = {};  ///< name as written, if it is one of an earlier version (core/renamed_entries.h)

  std::string path() const { return section.empty() ? entry : section + "/" + entry; }
};

using Settings = std::vector<Setting>;

/// Settings of a file in their order, JSON if its first character is '{', after `overrides` (see
/// parse_override), entries under their present names (core/renamed_entries.h). Throws InputError naming file
/// and line.
Settings read_settings(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// `Section/Entry=value` as given to --set, under its present name.
/// Throws InputError for a text that is none.
Setting parse_override(const std::string& text);

/// Replaces the setting of the same path, or appends it.
void override_setting(Settings& settings, const Setting& setting);

/// The settings as a .prm text.
std::string format_settings(const Settings& settings);

}  // namespace asperity
