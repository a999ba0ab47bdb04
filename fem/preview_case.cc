#include "fem/preview_case.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "fem/case/case_setup.h"
#include "fem/case/solve_cost.h"
#include "fem/interface/adhesion_law.h"
#include "fem/interface/friction_law.h"
#include "fem/interface/surface_attraction.h"
#include "fem/materials/material_law.h"
#include "fem/solve_case.h"
#include "half_space/partial_slip.h"

namespace asperity {
namespace {

constexpr double tabor_factor = 3;  // hardness over yield stress (Tabor 1951)

/// The lower yield stress of the bodies; infinite where nothing yields [Pa].
double lower_yield_stress(const CaseInput& input) {
  return std::min(fem::make_material_law(input.particle).yield_stress,
                  fem::make_material_law(input.substrate).yield_stress);
}

bool film_yields(const CaseInput& input) {
  return std::isfinite(std::min(input.particle.film.yield_stress, input.substrate.film.yield_stress));
}

std::vector<YieldingBody> yielding_bodies(const CaseInput& input) {
  std::vector<YieldingBody> bodies;
  const auto add = [&](const char* name, const BodyInput& body) {
    const double stress = fem::make_material_law(body).yield_stress;
    if (std::isfinite(stress)) bodies.push_back({name, hertz_yield_factor(body.poisson_ratio) * stress});
  };
  add("particle", input.particle);
  add("substrate", input.substrate);
  return bodies;
}

FullSlip full_slip(const fem::FrictionLaw& law, const half_space::CaseContact& contact) {
  const auto& grid = contact.grid;
  FullSlip sum;
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const double pressure = contact.solution.pressure[static_cast<std::size_t>(iy) * grid.nx + ix];
      if (!(pressure > 0)) continue;
      const double force = law.initial_limit(pressure).stress * grid.cell_area();
      sum.lateral_force += force;
      sum.torsion_moment += force * std::hypot(grid.x(ix), grid.y(iy));
    }
  return sum;
}

/// From rest to twice the shift by which what sticks would hold as much as full slip.
std::vector<SlipPoint> partial_slip(const CaseInput& input, const fem::FrictionLaw& law,
                                    const half_space::CaseContact& contact, double full_slip) {
  half_space::Field limit = contact.solution.pressure;
  for (double& value : limit) value = value > 0 ? law.initial_limit(value).stress : 0;
  const half_space::StuckContact stuck(contact.grid, half_space::shear_compliance(input));
  const half_space::PartialSlip slip(stuck, std::move(limit));
  half_space::SlipState state = slip.at_rest();
  std::vector<SlipPoint> points;
  for (const double share : {0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0}) {
    const double shift = share * full_slip / contact.lateral_stiffness;
    state = slip.shifted(state, shift, 0);
    points.push_back({shift, state.force_x, state.slipping});
  }
  return points;
}

LeftOutOfPreview what_is_left_out(const CaseInput& input) {
  LeftOutOfPreview left_out;
  if (input.experiment.type != Motion::normal) left_out.motion = input.experiment.type;
  left_out.finite_bodies = input.experiment.control == ExperimentInput::Control::displacement;
  left_out.shear_of_films = has_films(input);
  left_out.yielding_films = film_yields(input);
  left_out.relaxation = fem::relaxes(input);
  return left_out;
}

}  // namespace

MeshPreview preview_mesh(const CaseInput& input) {
  check_case(input);
  const CaseInput derived = fem::with_derived_path_length(input);
  const fem::CaseSetup setup = fem::set_up_sizes(derived);
  const fem::SolveCost cost =
      fem::estimated_cost(derived, setup, std::isfinite(lower_yield_stress(input)) || film_yields(input));
  return {setup.system.mesh.sizes.spacing_particle,
          setup.system.mesh.sizes.region_particle,
          cost.unknowns,
          cost.memory,
          cost.seconds_on_two_cores(),
          cost.seconds,
          cost.steps};
}

PreviewedCase preview_case(const CaseInput& input, double hardness,
                           const half_space::OnSeparation& on_separation) {
  PreviewedCase preview;
  const auto attraction = fem::surface_attraction(input.interface);
  preview.hardness = hardness > 0 ? hardness : tabor_factor * lower_yield_stress(input);
  try {
    preview.contact = half_space::preview_of_case(input, preview.hardness, attraction, on_separation);
  } catch (const InputError&) {  // a contact of that hardness may be no half-space's where the elastic one is
    if (hardness > 0 || std::isinf(preview.hardness)) throw;
    preview.hardness = std::numeric_limits<double>::infinity();
    preview.contact = half_space::preview_of_case(input, preview.hardness, attraction, on_separation);
  }
  preview.work_of_separation = fem::work_of_adhesion(input.interface).opening;
  preview.yielding = yielding_bodies(input);
  preview.left_out = what_is_left_out(input);
  preview.left_out.adhesion = attraction && !preview.contact.fine.pull_off;
  try {
    preview.mesh = preview_mesh(input);
    if (const auto friction = fem::make_friction_law(input.interface)) {
      preview.slip = full_slip(*friction, preview.contact.fine);
      preview.coarse_slip = full_slip(*friction, preview.contact.coarse);
      if (input.experiment.type == Motion::sliding && !has_films(input) &&
          preview.coarse_slip->lateral_force > 0)
        preview.partial_slip =
            partial_slip(input, *friction, preview.contact.coarse, preview.coarse_slip->lateral_force);
    }
  } catch (const InputError& error) {
    preview.refusal = error.what();
  }
  return preview;
}

}  // namespace asperity
