#include "app/refused_cases.h"

#include <cmath>

#include "app/relaxing_case.h"
#include "core/error.h"
#include "fem/interface/adhesion_law.h"
#include "fem/materials/material_law.h"

namespace asperity {
namespace {

bool yields(const BodyInput& body) { return std::isfinite(fem::make_material_law(body).yield_stress); }

}  // namespace

void refuse_what_relaxes_besides(const CaseInput& input, const std::filesystem::path& file) {
  if (!fem::relaxes(input)) return;
  if (relaxation_of(input.particle).share > 0 && relaxation_of(input.substrate).share > 0)
    throw InputError(file.string() +
                     ": both bodies relax with time, and --case takes cases in which one of them does; set "
                     "Relaxing share and Relaxation time of the other to 0");
  if (yields(input.particle) || yields(input.substrate) ||
      fem::work_of_adhesion(input.interface).opening > 0 || input.interface.attraction_force > 0)
    throw InputError(file.string() +
                     ": a body relaxes with time, and --case takes such a case only where no body yields and "
                     "surfaces do not attract; leave out one of the two");
}

void refuse_for_normal_recordings(const CaseInput& input, const std::filesystem::path& file) {
  if (input.experiment.type != Motion::normal)
    throw InputError(file.string() + ": Experiment/Type is " + name_of(input.experiment.type) +
                     ", and the recording is of normal contact; set Type = normal");
  if (input.interface.attraction_force > 0)
    throw InputError(
        file.string() +
        ": for recordings of normal contact --case takes attraction over a range; set "
        "Interface/Attraction force = 0 N, and Work of adhesion and Adhesion range in its place");
  if (!(fem::work_of_adhesion(input.interface).opening > 0)) return;
  const std::string attracts = file.string() + ": the surfaces attract each other, and ";
  if (yields(input.particle) || yields(input.substrate))
    throw InputError(attracts +
                     "attraction between bodies that yield is not solved for a recording yet; leave "
                     "out the Yield stress or the Work of adhesion");
  if (input.particle.topography.generator() || input.substrate.topography.generator())
    throw InputError(attracts +
                     "what another realisation of a generated Topography changes in it is not known; "
                     "give a scan of the recorded place, or smooth");
}

}  // namespace asperity
