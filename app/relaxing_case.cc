#include "app/relaxing_case.h"

#include <cmath>

#include "app/driven_case.h"
#include "core/error.h"
#include "fem/interface/adhesion_law.h"
#include "fem/materials/material_law.h"

namespace asperity {

RelaxingPart relaxation_of(const BodyInput& body) {
  const fem::Relaxation relaxation = fem::make_material_law(body).relaxation;
  return {relaxation.share, relaxation.time};
}

void refuse_what_relaxes_besides(const CaseInput& input, const std::filesystem::path& file) {
  if (!fem::relaxes(input)) return;
  if (relaxation_of(input.particle).share > 0 && relaxation_of(input.substrate).share > 0)
    throw InputError(file.string() +
                     ": both bodies relax with time, and --case takes cases in which one of them does; set "
                     "Relaxing share and Relaxation time of the other to 0");
  const auto yields = [](const BodyInput& body) {
    return std::isfinite(fem::make_material_law(body).yield_stress);
  };
  if (yields(input.particle) || yields(input.substrate) ||
      fem::work_of_adhesion(input.interface).opening > 0 || input.interface.attraction_force > 0)
    throw InputError(file.string() +
                     ": a body relaxes with time, and --case takes such a case only where no body yields and "
                     "surfaces do not attract; leave out one of the two");
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
