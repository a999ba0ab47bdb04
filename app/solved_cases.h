// A folder of cases solved earlier, of a study or of a diagnosis: which contact they are of, and which of
// them is the one asked for. Nothing is written there.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion.h"
#include "core/parameter_file.h"

namespace asperity {

/// A complete case, and how it was driven.
struct DrivenCase {
  std::filesystem::path folder;
  Motion motion = Motion::normal;
  double load = 0;   ///< largest normal load [N]; 0: its approach is prescribed
  double speed = 0;  ///< of the motion [m/s]
};

class SolvedCases {
 public:
  SolvedCases() = default;
  /// Looks at every complete case directly in `folder`. Throws InputError where there is no such folder.
  explicit SolvedCases(const std::filesystem::path& folder);

  /// Folder of the case with these inputs (app/inputs_hash.h); empty: it is not here.
  std::filesystem::path with_inputs(const std::string& sha256) const;
  /// Case file of the contact that was solved here: cases of this motion that differ in nothing but how
  /// they are driven. Throws InputError where there is none or more than one, naming the remedy.
  std::filesystem::path the_contact(Motion motion) const;
  /// Cases of the contact of a case (its file, against which names of scans are resolved), however it is
  /// driven.
  std::vector<DrivenCase> of_contact(const Settings& settings, const std::filesystem::path& file) const;

 private:
  /// What each of them was driven by, and the hash of its contact.
  struct Known {
    DrivenCase driven;
    std::string contact;
  };
  std::filesystem::path folder_;
  std::map<std::string, std::filesystem::path> by_inputs_;
  std::vector<Known> known_;
};

}  // namespace asperity
