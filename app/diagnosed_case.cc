#include "app/diagnosed_case.h"

#include "core/atomic_file.h"
#include "core/printed.h"

namespace asperity {

namespace fs = std::filesystem;

void write_diagnosed_case(const Settings* settings, const Diagnosis& diagnosis, const fs::path& output) {
  const SolvedSimulation& simulation = diagnosis.simulation;
  for (const char* name : {"corrected.prm", "history_before.csv", "history_after.csv"})
    fs::remove(output / name);
  if (!settings) return;
  write_file_atomically(output / "history_before.csv",
                        read_file(fs::path(simulation.before) / "history.csv"));
  const auto entries = diagnosis.corrected();
  if (entries.empty()) return;
  Settings corrected = *settings;
  std::string head =
      "# The case with what asperity diagnose found missing (" + name_of(diagnosis.verdict) + "):\n";
  if (diagnosis.verdict == Verdict::partly_explained)
    head += "# More is missing, which these values may have taken up: their intervals do not count it.\n";
  for (const CorrectedEntry& e : entries) {
    const std::size_t slash = e.entry.find('/');
    override_setting(corrected,
                     {e.entry.substr(0, slash), e.entry.substr(slash + 1), e.written(), "diagnosis"});
    head += "# " + e.entry + " = " + e.written() + " (" + e.interval() + ")\n";
  }
  write_file_atomically(output / "corrected.prm", head + format_settings(corrected));
  if (!simulation.after.empty())
    write_file_atomically(output / "history_after.csv",
                          read_file(fs::path(simulation.after) / "history.csv"));
}

}  // namespace asperity
