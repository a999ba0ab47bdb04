#include "app/inputs_hash.h"

#include <functional>

#include "app/case_declaration.h"
#include "app/case_file.h"
#include "core/atomic_file.h"
#include "core/renamed_entries.h"
#include "core/sha256.h"
#include "core/topography_spec.h"

namespace asperity {
namespace {

/// To be raised where the text below changes its meaning.
constexpr const char* version = "asperity-inputs/1\n";

/// A scan by its content: the same file in another folder is the same input.
std::string by_content(ScanParameters scan) {
  scan.file =
      std::filesystem::path(scan.file).filename().string() + " sha256 " + sha256(read_file(scan.file));
  return scan.text();
}

std::string sha256_without(const std::function<bool(const Setting&)>& is_left_out, const Settings& settings,
                           const std::filesystem::path& file) {
  std::string text = version;
  const Settings complete = complete_settings(settings, file);
  for (std::size_t i = 0; i < complete.size(); ++i) {
    const CaseEntry& entry = case_entries()[i];  // complete_settings has their order
    if (is_left_out(complete[i])) continue;
    std::string value = entry.canonical(complete[i].value);
    if (!entry.required() && value == entry.canonical(entry.default_text)) continue;
    if (entry.name == "Topography") {
      const TopographySpec topography(value);
      if (topography.scan()) value = by_content(*topography.scan());
    }
    text += former_path(complete[i].path()) + " = " + value + "\n";
  }
  return sha256(text);
}

}  // namespace

bool is_about_the_run(const Setting& setting) {
  return setting.section == "Output" || setting.path() == "Title" || setting.path() == "Solver/Threads";
}

std::string inputs_sha256(const Settings& settings, const std::filesystem::path& file) {
  return sha256_without(is_about_the_run, settings, file);
}

std::string contact_sha256(const Settings& settings, const std::filesystem::path& file) {
  return sha256_without(
      [](const Setting& setting) { return setting.section == "Experiment" || is_about_the_run(setting); },
      settings, file);
}

}  // namespace asperity
