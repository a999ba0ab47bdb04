#include "app/case_folder.h"

#include "app/case_file.h"
#include "core/atomic_file.h"
#include "core/error.h"

namespace asperity {
namespace {

/// Entries that change the cost and the files, not the answer.
bool is_about_the_run(const Setting& setting) {
  return setting.section == "Solver" || setting.section == "Output" || setting.section.empty();
}

}  // namespace

void remember_case(const Settings& settings, const std::filesystem::path& file, const std::filesystem::path& folder,
                   bool resume) {
  const std::filesystem::path remembered = folder / "case.prm";
  const bool exists = std::filesystem::exists(remembered);
  if (exists && std::filesystem::equivalent(file, remembered)) return;
  const Settings now = complete_settings(settings, file);
  if (resume && exists) {
    const Settings before = complete_settings(read_settings(remembered), remembered);
    for (std::size_t i = 0; i < now.size(); ++i)
      if (now[i].value != before[i].value && !is_about_the_run(now[i]))
        throw InputError("'" + folder.string() + "' was solved with " + now[i].path() + " = " + before[i].value +
                         ", and now it is " + now[i].value + "; leave out --resume or choose another folder");
    return;
  }
  std::filesystem::create_directories(folder);
  write_file_atomically(remembered, format_settings(now));
}

}  // namespace asperity
