#include "app/study_folders.h"

#include "app/case_folder.h"
#include "app/inputs_hash.h"
#include "app/study_summary.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/output_folder.h"

namespace asperity {

namespace fs = std::filesystem;

StudyFolders::StudyFolders(const Study& study, const fs::path& output) : study_(study), output_(output) {
  for (const StudyCase& item : study.cases) hashes_.push_back(inputs_sha256(item.settings, study.file));
}

fs::path StudyFolders::folder(std::size_t index) const { return output_ / study_.cases[index].name; }

bool StudyFolders::has_result(std::size_t index) const { return asperity::has_result(folder(index)); }

bool StudyFolders::is_solved(std::size_t index) const {
  return says_the_same(index) && provenance_of_result(folder(index)).inputs_sha256 == inputs(index);
}

bool StudyFolders::has_begun(std::size_t index) const {
  return fs::exists(log(index)) || fs::exists(folder(index) / "checkpoint") ||
         fs::exists(folder(index) / "history.csv");
}

/// Entries that a case file lacks are at their defaults, so that a program that knows more entries still
/// knows the case.
bool StudyFolders::says_the_same(std::size_t index) const {
  if (!fs::exists(case_file(index))) return false;
  try {
    return inputs_sha256(read_settings(case_file(index)), case_file(index)) == inputs(index);
  } catch (const InputError&) {
    return false;
  }
}

void StudyFolders::refuse_other_inputs() const {
  for (std::size_t i = 0; i < study_.cases.size(); ++i) {
    if (!has_result(i) || is_solved(i)) continue;
    const std::string& name = study_.cases[i].name;
    const std::string why =
        provenance_of_result(folder(i)).inputs_sha256.empty()
            ? "was solved by a version of asperity that did not record its inputs"
            : difference_from_folder({study_.cases[i].settings, study_.file, folder(i), {inputs(i), ""}});
    throw InputError("case " + name + ": '" + folder(i).string() + "' " + why +
                     "; --overwrite solves such cases anew (with --only '" + name +
                     "' this one alone) and keeps what was there in '" + (output_ / "earlier").string() +
                     "'");
  }
}

fs::path StudyFolders::set_aside(std::size_t index) const {
  const fs::path place = output_ / "earlier";
  make_folder(place);
  const std::string& name = study_.cases[index].name;
  fs::path to = place / name;
  for (int i = 2; fs::exists(to); ++i) to = place / (name + "-" + std::to_string(i));
  fs::rename(folder(index), to);
  return to;
}

fs::path StudyFolders::prepare(std::size_t index) const {
  fs::path earlier;
  if (fs::exists(folder(index)) && (has_result(index) || !says_the_same(index))) earlier = set_aside(index);
  make_folder(folder(index));
  write_file_atomically(case_file(index), case_text(study_.cases[index].settings, {inputs(index), ""}));
  return earlier;
}

}  // namespace asperity
