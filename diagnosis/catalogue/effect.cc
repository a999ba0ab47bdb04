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
  // An entry may follow from several parameters: the interval holds all corners of theirs, and what no mesh
  // resolves too. The mesh is a means and has none.
  Experiment of_law = experiment;
  of_law.by_finite_elements = false;
  for (std::size_t corner = 0; corner < std::size_t{1} << at.size(); ++corner) {
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = corner >> k & 1 ? found[k].high : found[k].low;
    for (const auto& change : case_changes(of_law, at.data()))
      for (CorrectedEntry& entry : entries)
        if (entry.entry == change.entry) {
          entry.low = std::min(entry.low, change.value);
          entry.high = std::max(entry.high, change.value);
        }
  }
  return entries;
}

}  // namespace asperity
