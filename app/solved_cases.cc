#include "app/solved_cases.h"

#include <algorithm>
#include <vector>

#include "app/case_file.h"
#include "app/case_folder.h"
#include "app/inputs_hash.h"
#include "app/study_summary.h"
#include "core/error.h"
#include "core/parameter_file.h"

namespace asperity {

namespace fs = std::filesystem;

SolvedCases::SolvedCases(const fs::path& folder) : folder_(folder) {
  if (!fs::is_directory(folder))
    throw InputError("there is no folder '" + folder.string() + "' of solved cases");
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_directory() || !has_result(entry.path())) continue;
    const std::string inputs = provenance_of_result(entry.path()).inputs_sha256;
    if (inputs.empty()) continue;
    by_inputs_[inputs] = entry.path();
    const fs::path file = entry.path() / "case.prm";
    if (!fs::exists(file)) continue;
    try {
      const Settings settings = read_settings(file);
      const ExperimentInput driven = case_from_settings(settings, file).experiment;
      known_.push_back(
          {{entry.path(), driven.type, driven.normal_load, driven.speed}, contact_sha256(settings, file)});
    } catch (const InputError&) {  // of another version, or of a scan that is gone: it is known by its inputs
      continue;
    }
  }
  std::sort(known_.begin(), known_.end(),
            [](const Known& a, const Known& b) { return a.driven.folder < b.driven.folder; });
}

fs::path SolvedCases::with_inputs(const std::string& sha256) const {
  const auto found = by_inputs_.find(sha256);
  return found == by_inputs_.end() ? fs::path() : found->second;
}

std::vector<DrivenCase> SolvedCases::of_contact(const Settings& settings, const fs::path& file) const {
  std::vector<DrivenCase> list;
  if (known_.empty()) return list;
  const std::string contact = contact_sha256(settings, file);
  for (const Known& known : known_)
    if (known.contact == contact) list.push_back(known.driven);
  return list;
}

fs::path SolvedCases::the_contact(Motion motion) const {
  std::map<std::string, fs::path> contacts;
  for (const Known& known : known_)
    if (known.driven.motion == motion) contacts[known.contact] = known.driven.folder / "case.prm";
  if (contacts.empty())
    throw InputError("'" + folder_.string() + "' holds no solved case of " +
                     (motion == Motion::normal ? "normal contact" : name_of(motion)) +
                     "; name the case with --case CASE.prm");
  if (contacts.size() == 1) return contacts.begin()->second;
  std::vector<std::string> files;
  for (const auto& [contact, file] : contacts) files.push_back(file.string());
  std::sort(files.begin(), files.end());
  throw InputError("'" + folder_.string() + "' holds " + std::to_string(files.size()) +
                   " different contacts; name the one that is the simulation, for example --case " +
                   files.front());
}

}  // namespace asperity
