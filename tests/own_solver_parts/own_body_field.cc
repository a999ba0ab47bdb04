// A field of the bodies of somebody's own, all of it: hydrostatic pressure, minus a third of the stress'
// trace.
#include "fem/output/field.h"

namespace asperity::fem {
namespace {

std::vector<double> hydrostatic_pressures(const ShownState& shown) {
  std::vector<double> pressures;
  for (const auto& cell : shown.cells)
    pressures.push_back(-(cell.stress[0] + cell.stress[1] + cell.stress[2]) / 3);
  return pressures;
}

const RegisteredField entry{[] {
  return Field{"hydrostatic_pressure", "Pa", "minus a third of the stress' trace",
               FieldPlace::bodies,     1,    hydrostatic_pressures};
}};

}  // namespace
}  // namespace asperity::fem
