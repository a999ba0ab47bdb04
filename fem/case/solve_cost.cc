#include "fem/case/solve_cost.h"

#include <cmath>

#include "core/error.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "fem/case/fine_path.h"
#include "fem/materials/material_law.h"
#include "fem/programs/program.h"

namespace asperity::fem {

double estimated_unknowns(const meshing::BodySizes& sizes, double layers) {
  const auto nodes = [&](double region, double reach, double spacing) {
    return 4 * region * (region + reach) / (spacing * spacing) * (4.0 / 3) * (layers + 1);
  };
  return 3 * (nodes(sizes.region_particle, sizes.reach_particle, sizes.spacing_particle) +
              nodes(sizes.region_substrate, sizes.reach_substrate, sizes.spacing_substrate));
}

double estimated_memory(double unknowns, bool all_keep_history) {
  // Program and libraries, then each unknown. Line through the maximum resident sets that result.json of
  // runs/paper/surfaces.prm states: 295 MB for 122121 unknowns (18 nm at the interface), 389 MB for 257358
  // (12 nm). Where all cells keep a history and a tangent, as of bodies that relax: 8e4 unknowns in 305 and
  // 347 MB.
  constexpr double bytes_of_program = 200e6, bytes_per_unknown = 750, with_history = 1700;
  return bytes_of_program + unknowns * (all_keep_history ? with_history : bytes_per_unknown);
}

std::string memory_warning(const CaseInput& input, const CaseSetup& setup, double unknowns,
                           double available) {
  constexpr double gibibyte = 1 << 30, far_more = 2, worth_saying = 1, filled = 0.75;
  const double needed = estimated_memory(unknowns, relaxes(input));
  if (!(needed > worth_saying * available)) return "";
  const double fits = setup.system.mesh.sizes.spacing_particle * std::sqrt(needed / (filled * available));
  const std::string text = "some " +
                           printed("%.2g million unknowns need %.2g GiB of memory, and %.2g GiB are free",
                                   unknowns / 1e6, needed / gibibyte, available / gibibyte),
                    remedy =
                        "Mesh/Interface spacing = " + format_quantity(fits, Dimension::length, 2) + " fits";
  if (needed > far_more * available) throw InputError(input.file + ": " + text + "; " + remedy);
  return text + ": the system may end the program; " + remedy;
}

SolveCost estimated_cost(const CaseInput& input, const CaseSetup& setup, bool yields) {
  // Beyond the fine regions, the bulk of both bodies has some 5e4 (rough_contact, 20 nm: 1.1e5 in all).
  constexpr double bulk = 5e4;
  // Meshing, first touch and the far field, then each step: medians of the 174 cases of
  // runs/paper/motions.prm on one core of 2026, 5e4 to 2e5 unknowns. Of yielding bodies 2.9 us a step that
  // spins, 4.7 us one that rolls or slides (6.6 us where it slides on 20 nm, 9 us with half the yield
  // stresses), of elastic ones 2.7 to 4.5 us. Two cases side by side, 17 nm, 30 and 300 uN: 5 us where they
  // are pressed or spin, 5.6 to 7.2 us where they roll or slide.
  constexpr double before = 10e-6, elastic_step = 4.2e-6, yielding_step = 5e-6, yielding_path_step = 6.5e-6;
  const auto program = make_program(input.experiment, setup.motion);
  SolveCost cost;
  cost.unknowns = bulk + estimated_unknowns(setup.system.mesh.sizes, input.mesh.layers) *
                             FinePath(input, setup, program).share_at_a_time();
  cost.memory = estimated_memory(cost.unknowns, relaxes(input));
  cost.steps = static_cast<int>(program.size());
  const bool is_inelastic = yields || relaxes(input);
  const Motion motion = input.experiment.type;
  const bool has_path = motion == Motion::sliding || motion == Motion::rolling;
  const double step = !is_inelastic ? elastic_step : has_path ? yielding_path_step : yielding_step;
  cost.seconds = cost.unknowns * (before + cost.steps * step);
  return cost;
}

}  // namespace asperity::fem
