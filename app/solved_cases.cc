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
namespace {

namespace fs = std::filesystem;

/// A case without what says how it is driven.
std::string contact_of(const Settings& settings, const fs::path& file) {
  Settings pressed;
  for (const Setting& setting : settings)
    if (setting.section != "Experiment") pressed.push_back(setting);
  override_setting(pressed, {"Experiment", "Type", "normal", "solved cases"});
  override_setting(pressed, {"Experiment", "Normal load", "1 uN", "solved cases"});
  return inputs_sha256(pressed, file);
}

}  // namespace

SolvedCases::SolvedCases(const fs::path& folder) : folder_(folder) {
  if (!fs::is_directory(folder))
    throw InputError("there is no folder '" + folder.string() + "' of solved cases");
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_directory() || !has_result(entry.path())) continue;
    const std::string inputs = provenance_of_result(entry.path()).inputs_sha256;
    if (!inputs.empty()) by_inputs_[inputs] = entry.path();
  }
}

fs::path SolvedCases::with_inputs(const std::string& sha256) const {
  const auto found = by_inputs_.find(sha256);
  return found == by_inputs_.end() ? fs::path() : found->second;
}

fs::path SolvedCases::the_contact() const {
  std::map<std::string, fs::path> contacts;
  for (const auto& [inputs, solved] : by_inputs_) {
    const fs::path file = solved / "case.prm";
    if (!fs::exists(file)) continue;
    const Settings settings = read_settings(file);
    if (case_from_settings(settings, file).experiment.type == Motion::normal)
      contacts[contact_of(settings, file)] = file;
  }
  if (contacts.empty())
    throw InputError("'" + folder_.string() +
                     "' holds no solved case of normal contact; name the case with --case CASE.prm");
  if (contacts.size() == 1) return contacts.begin()->second;
  std::vector<std::string> files;
  for (const auto& [contact, file] : contacts) files.push_back(file.string());
  std::sort(files.begin(), files.end());
  throw InputError("'" + folder_.string() + "' holds " + std::to_string(files.size()) +
                   " different contacts; name the one that is the simulation, for example --case " +
                   files.front());
}

}  // namespace asperity
