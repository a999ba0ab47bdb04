#include "diagnosis/challenge/nominal_case.h"

#include "core/printed.h"

namespace asperity {
namespace {

std::string body(const char* section, const RecordedBody& body) {
  std::string text = printed("subsection %s\n", section);
  if (body.radius > 0) text += printed("  set Radius = %.10g m\n", body.radius);
  return text + printed("  set Young modulus = %.10g Pa\n  set Poisson ratio = %.10g\nend\n",
                        body.youngs_modulus, body.poissons_ratio);
}

}  // namespace

std::string nominal_case(const Recording& recording) {
  const auto& parameters = recording.simulation.parameters;
  const auto friction = parameters.find("sliding_friction");
  return body("Particle", recording.particle) + body("Substrate", recording.substrate) +
         printed("subsection Interface\n  set Friction coefficient = %.10g\nend\n",
                 friction == parameters.end() ? 0 : friction->second.value) +
         "subsection Experiment\n  set Normal load = 100 uN\nend\n";
}

}  // namespace asperity
