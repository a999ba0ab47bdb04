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
#include "fem/case/solve_cost.h"
#include "fem/interface/friction_law.h"
#include "fem/interface/surface_attraction.h"
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

/// Shift and angle at which a smooth elastic contact slips as a whole (Mindlin 1949; Lubkin 1951 at a stick
/// radius of a / 10), and steps of a spacing, an eighth of the contact radius at most; of half a spacing at
/// the rim of a contact that spins.
MotionScales motion_scales(const CaseInput& input, const CaseSetup& setup, double spacing) {
  const double a = setup.hertz_radius, area = M_PI * a * a;
  const auto law = make_friction_law(input.interface);
  const double friction = law ? area * law->initial_limit(setup.largest_contact_force() / area).stress : 0;
  const double torsion = 1 / torsion_modulus(elastic_body(input.particle), elastic_body(input.substrate));
  MotionScales scales;
  scales.full_slip_shift = 3 * friction * lateral_compliance(input) / (16 * a);
  scales.full_slip_angle = 0.64 * friction * torsion / (a * a);
  scales.largest_shift = std::min(spacing, a / 8);
  scales.largest_angle = spacing / (2 * a);
  scales.rolling_radius = input.radius;
  scales.contact_radius = a;
  return scales;
}

/// Hertz' contact at the largest load.
void find_hertz_scales(const CaseInput& input, CaseSetup& setup) {
  const Hertz hertz = hertz_of(input);
  setup.reduced_modulus = hertz.reduced_modulus;
  setup.hertz_approach = hertz_approach_of(input);
  const bool force = input.experiment.control == ExperimentInput::Control::force;
  setup.largest_load = force ? input.experiment.normal_load : hertz.force(setup.hertz_approach);
  setup.attraction_force = input.interface.attraction_force;
  setup.hertz_radius = std::sqrt(hertz.radius * setup.hertz_approach);
}

}  // namespace

std::string resolution_text(const MeshedRoughness& roughness, const std::string& body) {
  const auto length = [](double value) { return format_quantity(value, Dimension::length); };
  constexpr double little = 0.01;
  std::string text = body + ": " + format_quantity(roughness.cells_per_wave(), Dimension::none, 2) +
                     " cells over its shortest wave of " + length(roughness.scales.shortest_wave);
  if (roughness.scales.unresolved > little)
    text += "; still shorter waves hold " +
            format_quantity(100 * roughness.scales.unresolved, Dimension::none, 2) +
            " % of the scan's slope variance: they are not resolved";
  if (roughness.scales.period < roughness.region)
    text += "; the surface repeats every " + length(roughness.scales.period) + " within the region of " +
            length(roughness.region) + " (a larger size= in Topography makes another surface that does not)";
  return text;
}

J2Material material_of(const BodyInput& body) {
  J2Material material = J2Material::elastic(body.youngs_modulus, body.poisson_ratio);
  const Plasticity plasticity = make_plasticity(body);
  material.yield_stress = plasticity.yield_stress;
  material.kinematic_modulus = plasticity.kinematic_modulus;
  material.hardening = plasticity.hardening;
  return material;
}

CaseInput with_derived_path_length(const CaseInput& input) {
  CaseInput derived = input;
  CaseSetup setup;
  find_hertz_scales(input, setup);
  auto& e = derived.experiment;
  if ((e.type == Motion::sliding || e.type == Motion::rolling) && e.distance == 0)
    e.distance = 5 * setup.hertz_radius;
  if (e.type == Motion::torsion && e.angle == 0) e.angle = 6 * motion_scales(input, setup, 0).full_slip_angle;
  return derived;
}

namespace {

/// Spacing of the interface's nodes where the case gives none [m]: twelve cells over Hertz' contact radius,
/// which keep Hertz within 1 %, and four over the shortest wave of either surface, with which the largest
/// pressure reads 10 to 25 % too small and real area is good to some 7 % (output/discretisation_error.h);
/// result.json states both.
double derived_spacing(const CaseSetup& setup) {
  constexpr double cells_per_radius = 12, cells_per_wave = 4;
  double spacing = setup.hertz_radius / cells_per_radius;
  for (const auto& body : setup.roughness)
    spacing = std::min(spacing, body.scales.shortest_wave / cells_per_wave);
  return spacing;
}

/// A derived mesh must fit a workstation: hours and some 3 GB.
void require_affordable(const CaseInput& input, const CaseSetup& setup) {
  constexpr double most_unknowns = 4e6;
  const double unknowns = estimated_unknowns(setup.system.mesh.sizes, input.mesh.layers);
  const double spacing = setup.system.mesh.sizes.spacing_particle;
  const auto& scales =
      setup
          .roughness[setup.roughness[0].scales.shortest_wave < setup.roughness[1].scales.shortest_wave ? 0
                                                                                                       : 1]
          .scales;
  if (unknowns <= most_unknowns || !std::isfinite(scales.shortest_wave)) return;
  const double affordable = spacing * std::sqrt(unknowns / most_unknowns);
  throw InputError(input.file + ": the slopes of the roughness lie in waves down to " +
                   format_quantity(scales.shortest_wave, Dimension::length) + ", which take cells of " +
                   format_quantity(spacing, Dimension::length) + " and some " +
                   format_quantity(unknowns / 1e6, Dimension::none, 2) +
                   " million unknowns; leave out the shorter waves with cutoff=" +
                   format_quantity(4 * affordable, Dimension::length, 2) +
                   " in Topography, lower the load, or accept what a mesh of your own "
                   "Mesh/Interface spacing leaves out");
}

/// Radius that a smooth contact has at most [m]: Hertz', or where a body yields that of a mean pressure of
/// two yield stresses. A sphere that is indented until all below it flows carries 2.84 of them, less where
/// the contact is wide (Jackson & Green 2005). Under a given approach its contact is 1.49 times Hertz' at 650
/// approaches of first yield, where the edge piles up (axisymmetric finite elements of another program).
double largest_contact_radius(const CaseInput& input, const CaseSetup& setup) {
  constexpr double mean_pressure = 2, piled_up = 1.5;  // of the yield stress, of Hertz' radius
  const double yield =
      std::min(make_plasticity(input.particle).yield_stress, make_plasticity(input.substrate).yield_stress);
  double flowing = std::sqrt(setup.largest_contact_force() / (M_PI * mean_pressure * yield));
  if (input.experiment.control == ExperimentInput::Control::displacement)
    flowing = std::min(flowing, piled_up * setup.hertz_radius);
  return std::max(setup.hertz_radius, flowing);
}

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
    region = hertz_reach(setup.hertz_radius, R, reach) + 2 * spacing;
    // How far a body flows is an estimate: a mesh that holds Hertz' contact is not refused for it.
    const double flows_to = hertz_reach(setup.largest_radius, R, reach) + 2 * spacing;
    region = std::max(region, std::min(flows_to, largest_region));
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
  find_hertz_scales(input, setup);
  setup.largest_radius = largest_contact_radius(input, setup);
  const double R = input.radius;
  const bool force = input.experiment.control == ExperimentInput::Control::force;
  const TopographySpec& upper = input.particle.topography;
  const TopographySpec& lower = input.substrate.topography;

  setup.roughness[0].scales = topography_scales(upper);
  setup.roughness[1].scales = topography_scales(lower);

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
