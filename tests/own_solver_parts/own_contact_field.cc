// A field of the contact of somebody's own, all of it: the share of friction that acts, shear traction over
// contact pressure.
#include <cmath>

#include "fem/output/field.h"

namespace asperity::fem {
namespace {

std::vector<double> traction_ratios(const ShownState& shown) {
  const ContactState& state = shown.state;
  std::vector<double> ratios;
  for (std::size_t r = 0; r < state.multiplier.size(); ++r) {
    const double shear = state.shear[0].empty() ? 0 : std::hypot(state.shear[0][r], state.shear[1][r]);
    ratios.push_back(shown.is_closed(r) ? shear / state.multiplier[r] : 0);
  }
  return ratios;
}

const RegisteredField entry{[] {
  return Field{"traction_ratio",    "", "shear traction over contact pressure",
               FieldPlace::contact, 1,  traction_ratios};
}};

}  // namespace
}  // namespace asperity::fem
