#include "diagnosis/conceal/normal_program.h"

#include <cmath>

#include "diagnosis/conceal/other_code_truth.h"

namespace asperity::hidden {
namespace {

/// Of effects that another code has solved; false: of none.
bool choose_other_code(World& world, const std::string& id, const Sphere& nominal, double depth,
                       Random& random) {
  if (id == "bulk_plasticity") {
    const double critical = depth / between(random, 6, 35);
    world.hide(id, "axisymmetric finite elements, tabled", "yield_stress",
               TabledYielding::yield_stress_at(critical, nominal.reduced_modulus, nominal.radius));
  } else if (id == "roughness_compliance") {
    const char* model = "generated surface on half-spaces";
    world.hide(id, model, "rms", between(random, 0.8e-9, 2e-9), false);
    world.hide(id, model, "rolloff", between(random, 100e-9, 200e-9), false);
    world.hide(id, model, "cutoff", between(random, 60e-9, 80e-9), false);
  } else if (id == "film") {
    const char* model = "layered half-space (Burmister 1945)";
    world.hide(id, model, "modulus_ratio",
               sign(random) < 0 ? between(random, 0.1, 0.4) : between(random, 2, 3));
    world.hide(id, model, "thickness", between(random, 0.15, 0.6) * std::sqrt(nominal.radius * depth));
  } else {
    return false;
  }
  return true;
}

/// Laws of the contact; false: it is none of them.
bool choose_contact(World& world, const std::string& id, const NormalProgram& program, const Sphere& nominal,
                    double depth, Random& random) {
  const double largest = program.loads.back();
  if (id == "adhesion")
    world.hide(id, "Maugis 1992", "pull_off_force", between(random, 0.08, 0.2) * largest);
  else if (id == "effective_radius")
    world.hide(id, "sphere of another radius (Sneddon 1965)", "radius_ratio",
               sign(random) > 0 ? between(random, 1.2, 1.7) : between(random, 0.55, 0.8));
  else if (id == "bulk_plasticity")
    world.hide(id, "Kogut & Etsion 2002, unloading of Etsion, Kligerman & Kadin 2005", "yield_stress",
               between(random, 0.5e9, 1.0e9));
  else if (id == "roughness_compliance")
    world.hide(id, "layer with exponential pressure on rings over a half-space", "roughness_length",
               between(random, 0.02, 0.06) * depth, false);
  else if (id == "creep") {
    const char* model = "Kelvin element in series, driven through ramps and holds alike";
    world.hide(id, model, "amplitude", between(random, 0.06, 0.2), false);
    world.hide(id, model, "time_constant", between(random, 2, 8));
  } else if (id == "adhesion_hysteresis") {
    const char* model = "Maugis 1992 with two works of adhesion, edge pinned between them";
    const double closing = world.hide(id, model, "work_closing",
                                      between(random, 0.03, 0.06) * largest / (1.5 * pi * nominal.radius));
    world.hide(id, model, "work_opening", between(random, 3, 6) * closing);
  } else if (id == "capillary") {
    const char* model = "ring of constant suction around the contact (Maugis 1992)";
    world.hide(id, model, "pull_off_force", 4 * pi * nominal.radius * between(random, 0.03, 0.072));
    world.hide(id, model, "rupture_distance", between(random, 1.2e-9, 4.8e-9));
  } else if (id == "viscoelasticity") {
    const char* model = "row of springs and dampers (Popov & Hess 2015)";
    world.hide(id, model, "share", between(random, 0.15, 0.6));
    world.hide(id, model, "time_constant", between(random, 0.5, 5) * program.load_time);
  } else {
    return false;
  }
  return true;
}

}  // namespace

NormalProgram normal_program(const WorldRequest& request, Random& random) {
  const auto has = [&](const char* id) { return request.asks_for(id); };
  NormalProgram program;
  // Loads at which the physics asked for shows; the others come at any.
  double largest = between(random, 0.2e-3, 2e-3);
  if (has("adhesion") || has("adhesion_hysteresis") || has("capillary"))
    largest = between(random, 40e-6, 80e-6);
  if (has("roughness_compliance") || has("film")) largest = between(random, 150e-6, 400e-6);
  if (has("bulk_plasticity")) largest = between(random, 2e-3, 3e-3);
  program.loads = {largest / 4, largest / 2, largest};
  program.off_contact = has("capillary") ? 1.6 : 0.6;
  program.controls_force =
      has("creep") || (!has("adhesion") && !has("adhesion_hysteresis") && !has("capillary") &&
                       !has("baseline_tilt") && !has("contact_point_offset") && !has("pop_in") &&
                       !has("interference") && !has("piezo_hysteresis") && request.seed % 3 == 0);
  if (request.setting == "long_hold") program.controls_force = true;
  if (has("creep") || request.setting == "long_hold") program.hold_time = 30, program.hold_samples = 90;
  if (has("creep")) {  // fast up and down, so that what happens in the hold is not half over before it
    program.load_time = 1;
    program.loads = {0.7 * largest, 0.85 * largest, largest};
  }
  if (has("viscoelasticity")) program.hold_time = 0, program.hold_samples = 0, program.slower = 4;
  if (request.setting == "ramp_only") {
    program.loads = {largest};
    program.controls_force = true;
    program.unloads = false;
    program.hold_time = 0, program.hold_samples = 0;
    program.load_samples = 220;
  }
  if (program.controls_force) program.off_contact = 0;
  return program;
}

void choose_normal_parameters(World& world, const WorldRequest& request, const NormalProgram& program,
                              const Sphere& nominal, Random& random) {
  const double largest = program.loads.back(),
               depth = nominal.approach_of(nominal.contact_radius_at_force(largest));
  const double run_time = 2 * program.load_time + program.hold_time;
  for (const auto& id : request.effects) {
    if (request.setting == by_other_code && choose_other_code(world, id, nominal, depth, random)) continue;
    if (choose_contact(world, id, program, nominal, depth, random)) continue;
    if (id == "instrument_compliance")
      world.hide(id, "implicit series of springs, solved by bisection", "compliance",
                 between(random, 0.1, 0.4) * depth / largest);
    else if (id == "contact_point_offset")
      world.hide(id, "shift of the recorded displacement", "offset",
                 sign(random) * between(random, 0.08, 0.25) * depth);
    else if (id == "thermal_drift")
      world.hide(id, "recorded displacement grows with time", "rate",
                 (request.setting == "ramp_only" ? 1 : sign(random)) * between(random, 0.08, 0.25) * depth /
                     run_time);
    else if (id == "baseline_tilt")
      world.hide(id, "force grows with the recorded displacement", "slope",
                 sign(random) * between(random, 0.06, 0.2) * largest / depth);
    else if (id == "pop_in")
      world.hide(id, "sudden displacement at a load of its own in each run", "jump",
                 between(random, 0.06, 0.15) * depth, false);
    else if (id == "interference") {
      const char* model = "light between cantilever and sample adds a force that is periodic in displacement";
      world.hide(id, model, "amplitude", between(random, 0.02, 0.05) * largest, false);
      world.hide(id, model, "period", between(random, 0.2, 0.4) * depth, false);
    } else if (id == "piezo_hysteresis")
      world.hide(id, "the displacement sensor has another characteristic upwards than downwards", "share",
                 between(random, 0.04, 0.09), false);
    else if (id == "thermal_oscillation") {
      world.hide(id, "sinusoidal shift of the displacement", "amplitude", between(random, 0.03, 0.08) * depth,
                 false);
      world.hide(id, "", "period", between(random, 3, 7), false);
    }
  }
}

}  // namespace asperity::hidden
