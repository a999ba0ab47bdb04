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

std::string why_without_form(const Effect& effect, const Experiment& experiment) {
  if (effect.enters_by(experiment) == EntersBy::reduced_law_only)
    return effect.why_not_by_finite_elements(experiment);
  // What relaxes is the whole contact: an effect that puts another law in its place has none that relaxes.
  const EffectDescription& law = effect.description();
  const bool attracts = law.takes("attraction"),
             is_law_of_contact = attracts || law.takes("normal_law") || law.takes("burst");
  if (experiment.case_relaxes() && is_law_of_contact && effect.values_in_case(experiment).empty())
    return "a body of the case relaxes, and its law is one of bodies that do not";
  if (experiment.case_attracts() && is_law_of_contact && !attracts)
    return "the surfaces of the case attract, and its law is one of surfaces that do not";
  return "";
}

}  // namespace asperity
