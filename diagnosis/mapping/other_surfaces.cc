// The recorded surface is another than the case's, where that is generated.
#include <cmath>

#include "core/quantity.h"
#include "diagnosis/mapping/solved_case_mapping.h"

namespace asperity {

void SolvedCaseMapping::solve_on_other_surfaces() {
  const double largest = protocols_.list.front().largest_force;
  OtherSurfaces surfaces;
  say("solving other realisations of the case's surface, by half-spaces");
  try {
    surfaces = model_.on_other_surfaces(largest);
  } catch (const std::exception& error) {  // half-spaces have limits of their own
    remarks_.push_back(
        "what another realisation of the case's surface changes is not known, for half-spaces do "
        "not solve it (" +
        std::string(error.what()) + "): what is named may be the surface");
    return;
  }
  const auto& changes = surfaces.changes;
  if (changes.empty()) return;
  surface_errors_ = surface_errors_of(surfaces);
  double sum = 0;
  for (const auto& change : changes) sum += std::pow(change.displacement.back(), 2);
  remarks_.push_back(
      "the case's surface is one realisation of its spectrum, and the recorded one is another: on " +
      std::to_string(changes.size()) + " other seeds the approach under " +
      format_quantity(largest, Dimension::force) + " differs by " +
      format_quantity(std::sqrt(sum / static_cast<double>(changes.size())), Dimension::length) +
      " (root mean square, half-spaces) and its zero may be off by " +
      format_quantity(surfaces.unseen, Dimension::length) +
      ", which is a part of the evidence; a scan of the recorded place has no such error");
}

}  // namespace asperity
