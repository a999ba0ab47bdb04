#include "app/case_folder.h"

#include <nlohmann/json.hpp>

#include "app/case_file.h"
#include "app/inputs_hash.h"
#include "app/study_summary.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/output_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

const std::string hash_line = "# inputs_sha256: ", commit_line = "# commit: ";

std::string head(const Provenance& provenance) {
  return (provenance.inputs_sha256.empty() ? "" : hash_line + provenance.inputs_sha256 + "\n") +
         (provenance.commit.empty() ? "" : commit_line + provenance.commit + "\n");
}

Provenance provenance_in(const fs::path& file) {
  const auto json = nlohmann::json::parse(read_file(file), nullptr, false);
  if (!json.is_object()) return {};
  const auto text = [&](const char* name) {
    return json.contains(name) && json[name].is_string() ? json[name].get<std::string>() : std::string();
  };
  return {text("inputs_sha256"), text("commit")};
}

[[noreturn]] void refuse(const FolderedCase& now, const std::string& why) {
  throw InputError("'" + now.folder.string() + "' " + why +
                   "; --overwrite solves it anew, or choose another folder");
}

void refuse_unless_same(const FolderedCase& now, const Provenance& solved) {
  if (solved.inputs_sha256.empty())
    refuse(now,
           "was solved by a version of asperity that did not record its inputs, so that --resume could mix "
           "two cases");
  if (solved.inputs_sha256 != now.provenance.inputs_sha256) refuse(now, difference_from_folder(now));
}

/// case.prm without the lines that say where it comes from.
std::string without_head(const std::string& text) {
  std::string rest;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    if (text.compare(at, hash_line.size(), hash_line) != 0 &&
        text.compare(at, commit_line.size(), commit_line) != 0)
      rest += text.substr(at, end - at);
    at = end;
  }
  return rest;
}

bool says_the_same_case(const fs::path& file, const Provenance& provenance) {
  try {
    return inputs_sha256(read_settings(file), file) == provenance.inputs_sha256;
  } catch (const InputError&) {
    return false;
  }
}

void write_case(const FolderedCase& now) {
  const fs::path path = now.folder / "case.prm";
  if (fs::exists(path)) {
    const std::string text = read_file(path), own = without_head(text);
    const bool is_json =
        own.find_first_not_of(" \t\r\n") != std::string::npos && own[own.find_first_not_of(" \t\r\n")] == '{';
    if (!is_json && says_the_same_case(path, now.provenance)) {
      const std::string headed = head(now.provenance) + own;
      if (headed != text) write_file_atomically(path, headed);
      return;
    }
    const bool written_by_a_person = own == text;
    if (written_by_a_person) write_file_atomically(now.folder / "case_given.prm", text);
  }
  write_file_atomically(path, case_text(complete_settings(now.settings, now.file), now.provenance));
}

}  // namespace

std::string case_text(const Settings& complete, const Provenance& provenance) {
  return head(provenance) + format_settings(complete);
}

Provenance provenance_of_result(const fs::path& folder) {
  return has_result(folder) ? provenance_in(folder / "result.json") : Provenance{};
}

std::string difference_from_folder(const FolderedCase& now) {
  const fs::path remembered = now.folder / "case.prm";
  std::string unknown = "was solved from another case";
  if (!fs::exists(remembered)) return unknown;
  try {
    const Settings before = complete_settings(read_settings(remembered), remembered),
                   present = complete_settings(now.settings, now.file);
    for (std::size_t i = 0; i < present.size(); ++i)
      if (present[i].value != before[i].value && !is_about_the_run(present[i]))
        return "was solved with " + present[i].path() + " = " + before[i].value + ", and now it is " +
               present[i].value;
  } catch (const InputError&) {
    return unknown;
  }
  return "was solved from another content of the scan or the case file that it names";
}

SolveStart check_folder(const FolderedCase& now, IfSolved if_solved) {
  if (fs::exists(fs::symlink_status(now.folder)) && !fs::is_directory(now.folder))
    throw InputError("'" + now.folder.string() + "' is no folder; choose another one for the results");
  const fs::path manifest = now.folder / "checkpoint" / "latest.json";
  const bool has_steps = fs::exists(manifest) || fs::exists(now.folder / "history.csv");
  if (!has_steps && !fs::exists(now.folder / "result.json")) return SolveStart::anew;
  if (if_solved == IfSolved::overwrite) return SolveStart::anew;
  const bool finished = has_result(now.folder);
  if (if_solved == IfSolved::refuse)
    throw InputError("'" + now.folder.string() + "' holds a " + (finished ? "finished" : "begun") +
                     " solution already; add --resume to " + (finished ? "keep" : "go on with") +
                     " it, --overwrite to solve it anew, or choose another folder");
  if (finished) {
    refuse_unless_same(now, provenance_of_result(now.folder));
    return SolveStart::finished;
  }
  if (!fs::exists(manifest)) return SolveStart::anew;
  const Provenance begun = provenance_in(manifest);
  refuse_unless_same(now, begun);
  if (begun.commit != now.provenance.commit)
    refuse(now, "was begun by the build of commit " + begun.commit + ", and this one is of " +
                    now.provenance.commit);
  return SolveStart::go_on;
}

void claim_folder(const FolderedCase& now, SolveStart start) {
  make_folder(now.folder);
  // The result first: what is left when this is interrupted must not pass for a solved case.
  if (start == SolveStart::anew)
    for (const char* name : {"result.json", "checkpoint", "history.csv", "fields", "fields.pvd", "interface",
                             "interface.pvd", "show_in_paraview.py", "report.html"})
      fs::remove_all(now.folder / name);
  write_case(now);
}

}  // namespace asperity
