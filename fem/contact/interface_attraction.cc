// Attraction at the rows of InterfaceTractions, and the bonds of its hysteresis.
#include <algorithm>

#include "fem/contact/interface_tractions.h"

namespace asperity::fem {

AdhesionLaw::Attraction InterfaceTractions::attraction(const ContactState& state, int row, double gap) const {
  // Surfaces that overlap for a moment, before the multipliers know, attract as if they touched.
  auto result = (state.bonded[row] ? *adhesion_.opening : *adhesion_.closing).at(std::max(0.0, gap));
  if (gap < 0) result.slope = 0;
  return result;
}

double InterfaceTractions::update_bonds(ContactState& state, const std::vector<double>& gaps) const {
  double lost = 0;
  for (std::size_t r = 0; r < attraction_.size(); ++r) {
    const bool formed = pressure_[r] > 0 && !state.bonded[r],
               broken = state.bonded[r] && gaps[r] > adhesion_.opening->range();
    if (!formed && !broken) continue;
    const auto before = attraction(state, static_cast<int>(r), gaps[r]);
    state.bonded[r] = formed;
    const auto after = attraction(state, static_cast<int>(r), gaps[r]);
    if (formed) state.multiplier[r] += after.stress - before.stress;
    lost += system_.areas()[r] * (after.work - before.work);
  }
  return lost;
}

double InterfaceTractions::adhesion_energy(const ContactState& state, const std::vector<double>& gaps) const {
  double energy = 0;
  for (std::size_t r = 0; r < attraction_.size(); ++r)
    energy -= system_.areas()[r] * attraction(state, static_cast<int>(r), gaps[r]).work;
  return energy;
}

}  // namespace asperity::fem
