// The folders of a study's cases, and what an earlier run left in them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study.h"

namespace asperity {

class StudyFolders {
 public:
  /// Both must outlive this. Reads every scan that a case names.
  StudyFolders(const Study& study, const std::filesystem::path& output);

  /// Of the case with this place in the study.
  std::filesystem::path folder(std::size_t index) const;
  std::filesystem::path case_file(std::size_t index) const { return folder(index) / "case.prm"; }
  std::filesystem::path log(std::size_t index) const { return folder(index) / "solve.log"; }
  /// SHA-256 of a case's inputs (app/inputs_hash.h).
  const std::string& inputs(std::size_t index) const { return hashes_[index]; }

  /// Complete, whatever the inputs.
  bool has_result(std::size_t index) const;
  /// Complete, and of this case's inputs.
  bool is_solved(std::size_t index) const;
  /// Something was begun in the folder.
  bool has_begun(std::size_t index) const;

  /// Refuses complete cases of other inputs than the study's, or that do not say of which. Throws InputError
  /// naming case and remedy.
  void refuse_other_inputs() const;
  /// Makes the folder of a case to be solved and writes its case.prm; what is there of other inputs goes to
  /// the folder `earlier`. Returns where it went; empty if nothing did.
  std::filesystem::path prepare(std::size_t index) const;

 private:
  bool says_the_same(std::size_t index) const;
  std::filesystem::path set_aside(std::size_t index) const;

  const Study& study_;
  const std::filesystem::path& output_;
  std::vector<std::string> hashes_;
};

}  // namespace asperity
