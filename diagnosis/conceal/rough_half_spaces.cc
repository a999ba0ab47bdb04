#include <cmath>
#include <vector>

#include "diagnosis/conceal/other_code_truth.h"
#include "diagnosis/conceal/tabled_contact.h"
#include "half_space/case_contact.h"

namespace asperity::hidden {

std::unique_ptr<NormalTruth> rough_half_spaces(const ElasticBody& sphere, const ElasticBody& plane,
                                               double radius, const RoughSurface& surface,
                                               double largest_force) {
  constexpr double first_touch = 2e-3, most = 1.3;  // of the largest force
  constexpr int loads = 20;
  GeneratorParameters generator;
  generator.spectrum = {surface.rms, 0.8, surface.rolloff, surface.cutoff};
  generator.seed = surface.seed;
  CaseInput input;
  input.file = "concealed rough contact";
  input.particle.youngs_modulus = sphere.youngs_modulus, input.particle.poisson_ratio = sphere.poisson_ratio;
  input.substrate.youngs_modulus = plane.youngs_modulus, input.substrate.poisson_ratio = plane.poisson_ratio;
  input.substrate.topography = generator;
  input.radius = radius;
  half_space::CaseContactOptions options;
  options.with_stiffness = false;
  std::vector<double> approach, force, under;
  for (int i = 0; i < loads; ++i)
    under.push_back(largest_force * first_touch * std::pow(most / first_touch, i / (loads - 1.0)));
  for (const auto& contact : half_space::contacts_under(input, under, options)) {
    approach.push_back(contact.approach());
    force.push_back(contact.force());
  }
  const double touch = approach.front();
  for (double& d : approach) d -= touch;
  return std::make_unique<TabledContact>(std::move(approach), std::move(force));
}

}  // namespace asperity::hidden
