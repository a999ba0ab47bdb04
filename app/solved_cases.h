// A folder of cases solved earlier, of a study or of a diagnosis: which contact they are of, and which of
// them is the one asked for. Nothing is written there.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace asperity {

class SolvedCases {
 public:
  SolvedCases() = default;
  /// Looks at every complete case directly in `folder`. Throws InputError where there is no such folder.
  explicit SolvedCases(const std::filesystem::path& folder);

  /// Folder of the case with these inputs (app/inputs_hash.h); empty: it is not here.
  std::filesystem::path with_inputs(const std::string& sha256) const;
  /// Case file of the contact that was solved here: cases of normal motion that differ in nothing but how
  /// they are driven. Throws InputError where there is none or more than one, naming the remedy.
  std::filesystem::path the_contact() const;

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::filesystem::path> by_inputs_;
};

}  // namespace asperity
