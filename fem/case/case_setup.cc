#include "fem/case/case_setup.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.h"
#include "core/hertz_separation.h"
#include "core/quantity.h"
#include "core/shear_moduli.h"
#include "core/written_apart.h"
#include "fem/case/contact_path.h"
#include "fem/case/contact_radii.h"
#include "fem/case/derived_spacing.h"
#include "fem/interface/adhesion_law.h"
#include "fem/interface/friction_law.h"
#include "fem/materials/material_law.h"
#include "surfaces/sampler.h"
#include "surfaces/surface_of_entry.h"

namespace asperity::fem {
namespace {

/// Half width of the block in contact radii and in R: far enough that its own compliance is a small, measured
/// correction.
constexpr double block_half_width_in_radii = 0.7;
struct Roughness {
  meshing::HeightFunction height;
  double rms = 0, largest = 0;
};

Roughness roughness_of(const TopographySpec& spec, double half_width, double spacing) {
  Roughness roughness;
  if (spec.is_smooth()) return roughness;
  const double reach = 1.35 * half_width;  // the mesh lets roughness fade out beyond the region
  const auto sampler = std::make_shared<HeightSampler>(heights_over(spec, 2 * reach));
  roughness.height = [sampler](double x, double y) { return sampler->height(x, y); };
  const int n = std::max(8, static_cast<int>(half_width / spacing));
  double sum = 0, square = 0;
  for (int j = -n; j <= n; ++j)
    for (int i = -n; i <= n; ++i) {
      const double h = sampler->height(i * half_width / n, j * half_width / n);
      sum += h;
      square += h * h;
      roughness.largest = std::max(roughness.largest, std::abs(h));
    }
  const double count = (2.0 * n + 1) * (2.0 * n + 1);
  roughness.rms = std::sqrt(std::max(0.0, square / count - sum * sum / count / count));
  return roughness;
}

/// Sum of (2 - nu)/G of both bodies [1/Pa] (Mindlin 1949).
double lateral_compliance(const CaseInput& input) {
  return 1 / reduced_shear_modulus(elastic_body(input.particle), elastic_body(input.substrate));
}

/// Largest friction of a contact under a force [N], spread evenly over this radius [m].
double friction_over(const CaseInput& input, double force, double radius) {
  const double area = M_PI * radius * radius;
  const auto law = make_friction_law(input.interface);
  return law ? area * law->initial_limit(force / area).stress : 0;
}

/// Spin at which it slips as a whole [rad].
double full_slip_angle(const CaseInput& input, double force, double radius) {
  const double modulus = torsion_modulus(elastic_body(input.particle), elastic_body(input.substrate));
  return 0.64 * friction_over(input, force, radius) / (modulus * radius * radius);
}

/// Shift and angle at which a smooth elastic contact slips as a whole (Mindlin 1949; Lubkin 1951 at a stick
/// radius of a / 10), and steps of a spacing, an eighth of the contact radius at most; of half a spacing at
/// the rim of a contact that spins. Where smooth bodies of two materials roll, the edge that leaves within a
/// step lets go of the shear of their mismatch at once: a twentieth of the contact radius.
MotionScales motion_scales(const CaseInput& input, const CaseSetup& setup, double spacing) {
  const double a = std::max(setup.hertz_radius, setup.least_radius);
  const double force = setup.largest_contact_force() * std::pow(a / setup.hertz_radius, 3);
  MotionScales scales;
  scales.full_slip_shift = 3 * friction_over(input, force, a) * lateral_compliance(input) / (16 * a);
  scales.full_slip_angle = full_slip_angle(input, force, a);
  scales.largest_shift = std::min(spacing, a / 8);
  const bool lets_go = input.particle.topography.is_smooth() && input.substrate.topography.is_smooth() &&
                       make_friction_law(input.interface) != nullptr &&
                       dundurs_beta(elastic_body(input.particle), elastic_body(input.substrate)) != 0;
  scales.largest_roll = lets_go ? std::min(spacing, a / 20) : scales.largest_shift;
  scales.largest_angle = spacing / (2 * a);
  scales.rolling_radius = input.radius;
  scales.contact_radius = a;
  return scales;
}

/// Hertz' contact at the largest load, and what films and attraction make of it.
void find_contact_scales(const CaseInput& input, CaseSetup& setup) {
  const Hertz hertz = hertz_of(input);
  setup.reduced_modulus = hertz.reduced_modulus;
  setup.hertz_approach = hertz_approach_of(input);
  const bool force = input.experiment.control == ExperimentInput::Control::force;
  setup.largest_load = force ? input.experiment.normal_load : hertz.force(setup.hertz_approach);
  setup.attraction_force = input.interface.attraction_force;
  setup.hertz_radius = std::sqrt(hertz.radius * setup.hertz_approach);
  setup.filmed_radius = filmed_contact_radius(input, setup);
  setup.attraction = attraction_scales(input);
}

}  // namespace

J2Material material_of(const BodyInput& body) {
  J2Material material = J2Material::elastic(body.youngs_modulus, body.poisson_ratio);
  const MaterialLaw law = make_material_law(body);
  material.yield_stress = law.yield_stress;
  material.kinematic_modulus = law.kinematic_modulus;
  material.hardening = law.hardening;
  material.relaxation = law.relaxation;
  return material;
}

Film film_of(const BodyInput& body) {
  if (!body.film.is_there()) return {};
  Film film{J2Material::elastic(body.film.youngs_modulus, body.film.poisson_ratio), body.film.thickness};
  film.material.yield_stress = body.film.yield_stress;
  return film;
}

CaseInput with_derived_path_length(const CaseInput& input) {
  CaseInput derived = input;
  CaseSetup setup;
  find_contact_scales(input, setup);
  auto& e = derived.experiment;
  const double attracted = attracted_radius(input, setup);
  if ((e.type == Motion::sliding || e.type == Motion::rolling) && e.distance == 0) {
    // A rolling contact is steady a radius later than one that slides. A wide one would leave the sphere's
    // finely meshed cap.
    constexpr double widest_over_radius = 0.07;
    const double wide = std::max(setup.filmed_radius, attracted), widest = std::max(setup.hertz_radius, wide);
    const bool goes_on = e.type == Motion::rolling && widest < widest_over_radius * input.radius;
    const double more = goes_on ? 1 : 0;
    e.distance = std::max((5 + more) * setup.hertz_radius, (4 + more) * wide);
  }
  if (e.type == Motion::torsion && e.angle == 0) {
    e.angle = 6 * full_slip_angle(input, setup.largest_contact_force(), setup.hertz_radius);
    // Drawn to this radius the bodies bear on each other as under the load that presses Hertz' contact to it.
    const double bears = hertz_of(input).force(attracted * attracted / input.radius);
    if (attracted > 0) e.angle = std::max(e.angle, 4 * full_slip_angle(input, bears, attracted));
  }
  return derived;
}

namespace {

/// Half width of the finely meshed square [m]; throws InputError where no mesh has it.
double contact_region(const CaseInput& input, const CaseSetup& setup, double spacing) {
  const double R = input.radius;
  const double largest_region = 0.5 * meshing::BodyMap::cap_fraction * R;
  double region = input.mesh.contact_region;
  if (region == 0) {
    // Asperities three RMS heights high still touch where smooth surfaces would be that far apart; attraction
    // goes further.
    const double reach =
        std::hypot(3 * std::hypot(setup.roughness[0].scales.rms, setup.roughness[1].scales.rms),
                   attraction_reach(input.interface));
    region = hertz_reach(std::max(setup.hertz_radius, setup.least_radius), R, reach) + 2 * spacing;
    // How far a body flows is an estimate: a mesh that holds Hertz' contact is not refused for it.
    const double flows_to = hertz_reach(setup.largest_radius, R, reach) + 2 * spacing;
    const double drawn_to = 1.1 * attracted_radius(input, setup) + 2 * spacing;
    region = std::max(region, std::min(std::max(flows_to, drawn_to), largest_region));
  }
  if (region > largest_region) {
    const auto [found, allowed] = quantities_apart(region, largest_region, Dimension::length);
    throw InputError(input.file + ": the contact region of " + found + " is more than " + allowed +
                     ", where small strain and slopes end; lower Experiment/Normal load or set a smaller "
                     "Mesh/Contact region");
  }
  if (region < 4 * spacing)
    throw InputError(
        input.file + ": Mesh/Interface spacing of " + format_quantity(spacing, Dimension::length) +
        " leaves fewer than eight cells across the contact region of " +
        format_quantity(2 * region, Dimension::length) + "; set it to " + at_most(region / 16) + " or less");
  return region;
}

/// Friction that falls with slip by more than the contact's stiffness makes it jump (stick-slip), which no
/// sequence of equilibria follows. The bodies give way by 0.8 of 3 Q C/(16 a) on average over a pressure as
/// Hertz' (Mindlin 1949).
void require_friction_that_does_not_jump(const CaseInput& input, const CaseSetup& setup) {
  const auto law = make_friction_law(input.interface);
  if (!law || input.experiment.type == Motion::normal) return;
  const double a = setup.hertz_radius, area = M_PI * a * a,
               fall = law->steepest_fall(setup.largest_contact_force() / area) * area,
               give = 0.8 * 3 * lateral_compliance(input) / (16 * a), ratio = fall * give;
  if (ratio < 1) return;
  throw InputError(input.file + ": friction falls with slip " + format_quantity(ratio, Dimension::none, 2) +
                   " times as steeply as the contact's own stiffness follows, so that it would jump "
                   "(stick-slip); raise the length over which it falls by more than that factor");
}

}  // namespace

CaseSetup set_up_sizes(const CaseInput& input) {
  CaseSetup setup;
  find_contact_scales(input, setup);
  setup.largest_radius = largest_contact_radius(input, setup);
  const double R = input.radius;
  const bool force = input.experiment.control == ExperimentInput::Control::force;
  const TopographySpec& upper = input.particle.topography;
  const TopographySpec& lower = input.substrate.topography;

  setup.roughness[0].scales = topography_scales(upper);
  setup.roughness[1].scales = topography_scales(lower);
  setup.least_radius = least_contact_radius(input, setup);

  setup.system.films = {film_of(input.particle), film_of(input.substrate)};
  const double spacing =
      input.mesh.interface_spacing == 0 ? derived_spacing(setup) : input.mesh.interface_spacing;

  const double region = contact_region(input, setup, spacing);

  auto& options = setup.system;
  options.materials = {material_of(input.particle), material_of(input.substrate)};
  options.backend = input.solver.backend;
  options.control = force ? Control::force : Control::displacement;
  auto& sizes = options.mesh.sizes;
  sizes.radius = R;
  sizes.full_sphere = input.mesh.sphere == "full";
  sizes.block_half_width = block_half_width_in_radii * R;
  sizes.spacing_particle = sizes.spacing_substrate = spacing;
  sizes.region_particle = region;
  sizes.region_substrate = region + 3 * spacing;
  const Motion type = input.experiment.type;
  const bool rough = !upper.is_smooth() || !lower.is_smooth();
  options.tilted_normals = type == Motion::sliding || type == Motion::rolling || type == Motion::program ||
                           (type == Motion::torsion && rough);
  if (type == Motion::rolling) fit_to_rolling(input, sizes, region);
  if (type == Motion::sliding) fit_to_sliding(input, sizes);
  setup.motion = motion_scales(input, setup, spacing);
  require_friction_that_does_not_jump(input, setup);
  if (type == Motion::program) fit_to_program(input, setup);
  options.mesh.layers = input.mesh.layers;
  for (auto& body : setup.roughness) body.spacing = spacing;
  setup.roughness[0].region = 2 * (sizes.region_particle + sizes.reach_particle);
  setup.roughness[1].region = 2 * (sizes.region_substrate + sizes.reach_substrate);
  if (input.mesh.interface_spacing == 0) require_affordable(input, setup);
  return setup;
}

void check_extent(const CaseInput& input) { set_up_sizes(with_derived_path_length(input)); }

CaseSetup set_up(const CaseInput& input) {
  CaseSetup setup = set_up_sizes(input);
  auto& options = setup.system;
  const auto& sizes = options.mesh.sizes;
  const double spacing = sizes.spacing_particle;
  const Roughness particle =
      roughness_of(input.particle.topography, sizes.region_particle + sizes.reach_particle, spacing);
  const Roughness substrate =
      roughness_of(input.substrate.topography,
                   sizes.region_substrate + sizes.reach_substrate + sizes.offset_substrate_x, spacing);
  options.mesh.particle_height = particle.height;
  options.mesh.substrate_height = substrate.height;
  options.mesh.largest_height_particle = particle.largest;
  options.mesh.largest_height_substrate = substrate.largest;
  setup.rms_particle = particle.rms;
  setup.rms_substrate = substrate.rms;
  return setup;
}

}  // namespace asperity::fem
