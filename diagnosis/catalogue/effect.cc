#include "diagnosis/catalogue/effect.h"

#include <algorithm>

namespace asperity {

std::vector<CorrectedEntry> Effect::corrected_entries(const Experiment& experiment,
                                                      const std::vector<DiagnosedParameter>& found) const {
  std::vector<double> at;
  for (const auto& p : found) at.push_back(p.value);
  std::vector<CorrectedEntry> entries;
  for (const auto& change : case_changes(experiment, at.data()))
    entries.push_back({change.entry, change.unit, change.value, change.value, change.value, ""});
  // An entry may follow from several parameters: the interval holds all corners of theirs.
  for (std::size_t corner = 0; corner < std::size_t{1} << at.size(); ++corner) {
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = corner >> k & 1 ? found[k].high : found[k].low;
    const auto changes = case_changes(experiment, at.data());
    for (std::size_t k = 0; k < entries.size(); ++k) {
      entries[k].low = std::min(entries[k].low, changes[k].value);
      entries[k].high = std::max(entries[k].high, changes[k].value);
    }
  }
  return entries;
}

}  // namespace asperity
