// Entries of case files that had another name in an earlier version. Case files, checkpoints and results of
// that version are still read, under the present names.
#pragma once

#include <string>
#include <vector>

#include "core/parameter_file.h"

namespace asperity {

/// One entry under both names.
struct RenamedEntry {
  const char *former, *present;  ///< "Section/Entry"
};

/// All that were renamed.
const std::vector<RenamedEntry>& renamed_entries();

/// Present name of an entry "Section/Entry"; other texts stay as they are.
std::string present_path(const std::string& path);

/// Its first name, by which the hash of the inputs of a case knows it, so that a renamed entry changes none.
std::string former_path(const std::string& path);

/// Gives a setting its present name; `former` then holds the one that was written. The name may be a path
/// itself, as in the subsection Vary of a study.
void use_present_name(Setting& setting);

/// The same for settings of one source. Throws InputError if an entry is given under both of its names.
void use_present_names(Settings& settings);

/// A sentence for each setting that was written under a former name, with its place and the present name.
std::vector<std::string> hints_of_former_names(const Settings& settings);

}  // namespace asperity
