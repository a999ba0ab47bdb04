#include "fem/interface/surface_attraction.h"

#include "fem/interface/adhesion_law.h"
#include "half_space/case_contact.h"

namespace asperity::fem {

double attraction_reach(const InterfaceInput& input, double left) {
  const auto law = make_adhesion_laws(input).opening;
  if (!law) return 0;
  double gap = law->range();
  while (law->at(0.95 * gap).work < left * law->at(0).work) gap *= 0.95;
  return gap;
}

std::optional<half_space::Attraction> surface_attraction(const InterfaceInput& input) {
  const AdhesionLaws laws = make_adhesion_laws(input);
  if (!laws.opening) return std::nullopt;
  constexpr double left = 0.005;
  return half_space::Attraction{[law = laws.closing](double gap) { return law->at(gap).stress; },
                                [law = laws.opening](double gap) { return law->at(gap).stress; },
                                attraction_reach(input, left), laws.opening->at(0).work};
}

AttractionScales attraction_scales(const CaseInput& input) {
  const auto attraction = surface_attraction(input.interface);
  if (!attraction) return {};
  return {half_space::attraction_zone(input, *attraction), attraction->work / attraction->opening(0)};
}

}  // namespace asperity::fem
