// What the lines of a study say: axes, and the entries that each of their values sets.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/parameter_file.h"

namespace asperity {

/// One value of an axis: the entries it sets.
struct StudyChoice {
  std::string label;
  Settings settings;
};

/// One direction of the matrix, as written.
struct WrittenAxis {
  std::string path, where;
  std::vector<StudyChoice> choices;
};

/// A topography file is named relative to the file it stands in; cases live in other folders. Throws
/// InputError where its text is none of a topography.
void make_topography_absolute(Setting& setting, const std::filesystem::path& file);

/// A line of Study/Vary; throws InputError naming file and line.
WrittenAxis read_vary(const Setting& written, const std::filesystem::path& file);

/// A line of Study/Variants; throws InputError naming file and line.
StudyChoice read_variant(const Setting& written, const std::filesystem::path& file);

}  // namespace asperity
