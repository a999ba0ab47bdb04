#include "app/relaxing_case.h"

#include "app/driven_case.h"
#include "fem/materials/material_law.h"

namespace asperity {

RelaxingPart relaxation_of(const BodyInput& body) {
  const fem::Relaxation relaxation = fem::make_material_law(body).relaxation;
  return {relaxation.share, relaxation.time};
}

void leave_out_relaxation(Settings& settings, const CaseInput& input) {
  const auto leave_out = [&](const BodyInput& body, const std::string& section) {
    if (!(relaxation_of(body).share > 0)) return;
    set_entry(settings, section + "/Relaxing share", "0");
    set_entry(settings, section + "/Relaxation time", "0 s");
  };
  leave_out(input.particle, "Particle");
  leave_out(input.substrate, "Substrate");
}

}  // namespace asperity
