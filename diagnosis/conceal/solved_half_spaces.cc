#include <cmath>
#include <vector>

#include "diagnosis/conceal/other_code_truth.h"
#include "diagnosis/conceal/tabled_contact.h"
#include "half_space/case_contact.h"
#include "half_space/film_on_body.h"

namespace asperity::hidden {
namespace {

CaseInput smooth_case(const ElasticBody& sphere, const ElasticBody& plane, double radius) {
  CaseInput input;
  input.file = "concealed contact of half-spaces";
  input.particle.youngs_modulus = sphere.youngs_modulus, input.particle.poisson_ratio = sphere.poisson_ratio;
  input.substrate.youngs_modulus = plane.youngs_modulus, input.substrate.poisson_ratio = plane.poisson_ratio;
  input.radius = radius;
  return input;
}

/// Approaches [m] and forces [N] of an elastic contact.
struct LoadingCurve {
  std::vector<double> approach, force;
};

/// At twenty loads from a five-hundredth of a force [N] to a little more than it.
LoadingCurve solved(const CaseInput& input, double largest_force) {
  constexpr double least = 2e-3, most = 1.3;
  constexpr int loads = 20;
  half_space::CaseContactOptions options;
  options.with_stiffness = false;
  std::vector<double> under;
  for (int i = 0; i < loads; ++i)
    under.push_back(largest_force * least * std::pow(most / least, i / (loads - 1.0)));
  LoadingCurve curve;
  for (const auto& contact : half_space::contacts_under(input, under, options)) {
    curve.approach.push_back(contact.approach());
    curve.force.push_back(contact.force());
  }
  return curve;
}

}  // namespace

std::unique_ptr<NormalTruth> rough_half_spaces(const ElasticBody& sphere, const ElasticBody& plane,
                                               double radius, const RoughSurface& surface,
                                               double largest_force) {
  GeneratorParameters generator;
  generator.spectrum = {surface.rms, 0.8, surface.rolloff, surface.cutoff};
  generator.seed = surface.seed;
  CaseInput input = smooth_case(sphere, plane, radius);
  input.substrate.topography = generator;
  LoadingCurve curve = solved(input, largest_force);
  const double touch = curve.approach.front();
  for (double& d : curve.approach) d -= touch;
  return std::make_unique<TabledContact>(std::move(curve.approach), std::move(curve.force));
}

std::unique_ptr<NormalTruth> coated_half_spaces(const ElasticBody& sphere, const ElasticBody& plane,
                                                double radius, double modulus_ratio, double thickness,
                                                double largest_force) {
  const double of_plane = modulus_alone(plane),
               of_film = 1 / (1 / (modulus_ratio * reduced_modulus(sphere, plane)) - 1 / of_plane);
  CaseInput input = smooth_case(sphere, plane, radius);
  FilmInput& film = input.particle.film;
  film.thickness = thickness;
  film.poisson_ratio = sphere.poisson_ratio;
  film.youngs_modulus = of_film * (1 - sphere.poisson_ratio * sphere.poisson_ratio);
  LoadingCurve curve = solved(input, largest_force);
  curve.approach.insert(curve.approach.begin(), 0.0);
  curve.force.insert(curve.force.begin(), 0.0);
  return std::make_unique<TabledContact>(std::move(curve.approach), std::move(curve.force));
}

}  // namespace asperity::hidden
