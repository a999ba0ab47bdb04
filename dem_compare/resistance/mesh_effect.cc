#include "dem_compare/resistance/mesh_effect.h"

#include <algorithm>

#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/cases/path_averages.h"
#include "dem_compare/resistance/paired_paths.h"

namespace asperity {
namespace {

/// Those that the counted one is compared with.
std::vector<double> other_spacings(const MovingState& state) {
  std::vector<double> finer, coarser;
  for (const auto& item : state.on_other_meshes) {
    auto& side = item.spacing < state.spacing ? finer : coarser;
    const bool known =
        std::any_of(side.begin(), side.end(), [&](double h) { return same_spacing(h, item.spacing); });
    if (!known) side.push_back(item.spacing);
  }
  std::sort(finer.rbegin(), finer.rend());
  if (!finer.empty() || coarser.empty()) return finer;
  return {*std::min_element(coarser.begin(), coarser.end())};
}

MeshEffect effect_of(const MovingContact& contact, const MovingState& state, double other) {
  MeshEffect effect;
  effect.contact = &contact, effect.state = &state;
  effect.counts_fine = other > state.spacing;
  effect.coarse = std::max(other, state.spacing), effect.fine = std::min(other, state.spacing);
  std::vector<Uncertain> ratios;
  for (const auto& counted : state.cases)
    for (const auto& item : state.on_other_meshes) {
      if (!same_spacing(item.spacing, other) || !same_realisation(counted.seeds, item.seeds)) continue;
      ratios.push_back(effect.counts_fine ? paired_ratio(counted.first, item.first)
                                          : paired_ratio(item.first, counted.first));
      break;
    }
  effect.realisations = static_cast<int>(ratios.size());
  effect.ratio = mean_of_realisations(ratios);
  return effect;
}

}  // namespace

Uncertain MeshEffect::excess() const {
  // M(h) = M0 + c h: M0 = fine + (fine - coarse) fine_h / (coarse_h - fine_h).
  const double own = counts_fine ? fine : coarse, step = coarse - fine;
  const double limit = ratio.value + (ratio.value - 1) * fine / step;  // over the coarse one's resistance
  const double counted = counts_fine ? ratio.value : 1;
  return {counted / limit - 1, own / step / (limit * limit) * ratio.sd};
}

std::vector<MeshEffect> mesh_effects(const MovingStudy& study) {
  std::vector<MeshEffect> found;
  for (const auto& contact : study.contacts)
    for (const auto& state : contact.states)
      for (const double other : other_spacings(state)) {
        const MeshEffect effect = effect_of(contact, state, other);
        if (effect.realisations > 0) found.push_back(effect);
      }
  return found;
}

}  // namespace asperity
