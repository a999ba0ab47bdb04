// Loading, holding and unloading of a sphere.
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/hertz.h"
#include "diagnosis/conceal/normal_truth.h"
#include "diagnosis/conceal/world.h"

namespace asperity::hidden {
namespace {

struct NormalProgram {
  std::vector<double> loads;  ///< of an elastic sphere at the end of each run's path [N]
  double off_contact = 0;     ///< path before touch, over the largest approach
  double load_time = 10, hold_time = 10;
  int load_samples = 110, hold_samples = 40;
  bool unloads = true, controls_force = false;
};

NormalProgram normal_program(const WorldRequest& request, Random& random) {
  const auto has = [&](const char* id) {
    return std::find(request.effects.begin(), request.effects.end(), id) != request.effects.end();
  };
  NormalProgram program;
  // Loads at which the physics asked for shows; the others come at any.
  double largest = between(random, 0.2e-3, 2e-3);
  if (has("adhesion") || has("adhesion_hysteresis")) largest = between(random, 40e-6, 80e-6);
  if (has("roughness_compliance")) largest = between(random, 150e-6, 400e-6);
  if (has("bulk_plasticity")) largest = between(random, 2e-3, 3e-3);
  program.loads = {largest / 4, largest / 2, largest};
  program.off_contact = 0.6;
  program.controls_force =
      has("creep") ||
      (!has("adhesion") && !has("adhesion_hysteresis") && !has("baseline_tilt") &&
       !has("contact_point_offset") && !has("pop_in") && !has("piezo_hysteresis") && request.seed % 3 == 0);
  if (request.setting == "long_hold") program.controls_force = true;
  if (has("creep") || request.setting == "long_hold") program.hold_time = 30, program.hold_samples = 90;
  if (has("creep")) {  // fast up and down, so that what happens in the hold is not half over before it
    program.load_time = 1;
    program.loads = {0.7 * largest, 0.85 * largest, largest};
  }
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

/// Parameters, scaled so that the effect is as large as instruments show it.
void choose_normal_parameters(World& world, const WorldRequest& request, const NormalProgram& program,
                              const Sphere& nominal, Random& random) {
  const double largest = program.loads.back(),
               depth = nominal.approach_of(nominal.contact_radius_at_force(largest));
  const double run_time = 2 * program.load_time + program.hold_time;
  for (const auto& id : request.effects) {
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
    else if (id == "adhesion")
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
    } else if (id == "baseline_tilt")
      world.hide(id, "force grows with the recorded displacement", "slope",
                 sign(random) * between(random, 0.06, 0.2) * largest / depth);
    else if (id == "adhesion_hysteresis") {
      const char* model = "Maugis 1992 with two works of adhesion, edge pinned between them";
      const double closing = world.hide(id, model, "work_closing",
                                        between(random, 0.03, 0.06) * largest / (1.5 * pi * nominal.radius));
      world.hide(id, model, "work_opening", between(random, 3, 6) * closing);
    } else if (id == "pop_in")
      world.hide(id, "sudden displacement at a load of its own in each run", "jump",
                 between(random, 0.06, 0.15) * depth, false);
    else if (id == "piezo_hysteresis")
      world.hide(id, "the displacement sensor has another characteristic upwards than downwards", "share",
                 between(random, 0.04, 0.09), false);
    else if (id == "thermal_oscillation") {
      world.hide(id, "sinusoidal shift of the displacement", "amplitude", between(random, 0.03, 0.08) * depth,
                 false);
      world.hide(id, "", "period", between(random, 3, 7), false);
    }
  }
}

MaugisDugdale adhesive(const Sphere& sphere, double work) {
  constexpr double distance = 0.3e-9, lennard_jones = 1.03;  // z0 [m]
  return {sphere.reduced_modulus, sphere.radius, work, lennard_jones * work / distance};
}

/// The work of adhesion w that gives a pull-off force, which lies between 3/2 and 2 pi w R.
MaugisDugdale adhesive_by_pull_off(const Sphere& sphere, double pull_off) {
  const double unit = pull_off / (pi * sphere.radius);
  return adhesive(
      sphere, root_between([&](double work) { return adhesive(sphere, work).pull_off_force() - pull_off; },
                           unit / 2.1, unit / 1.4));
}

class NormalRun {
 public:
  NormalRun(const World& world, const NormalProgram& program, const Sphere& nominal, double depth,
            bool with_effects)
      : world_(world), program_(program), depth_(depth), with_effects_(with_effects), sphere_(nominal) {
    if (has("effective_radius")) sphere_.radius *= of("effective_radius", "radius_ratio");
    if (has("adhesion"))
      law_ = std::make_unique<AdhesiveTruth>(adhesive_by_pull_off(sphere_, of("adhesion", "pull_off_force")));
    else if (has("adhesion_hysteresis"))
      law_ = std::make_unique<HystereticTruth>(adhesive(sphere_, of("adhesion_hysteresis", "work_closing")),
                                               adhesive(sphere_, of("adhesion_hysteresis", "work_opening")));
    else if (has("bulk_plasticity"))
      law_ = std::make_unique<PlasticTruth>(sphere_.reduced_modulus, sphere_.radius, 0.17,
                                            of("bulk_plasticity", "yield_stress"));
    else if (has("roughness_compliance"))
      law_ = rough_truth(sphere_, of("roughness_compliance", "roughness_length"), 1.5 * depth);
    else if (has("creep"))
      law_ = std::make_unique<CreepingTruth>(sphere_, of("creep", "amplitude"), of("creep", "time_constant"));
    else
      law_ = std::make_unique<ElasticTruth>(sphere_);
  }

  /// Recorded force at a recorded displacement.
  double force_at(double displacement, double time, bool is_loading) {
    const double step = time - time_;
    const double given =
        displacement - shift(time) - sensor(displacement, is_loading) - (popped_ ? of("pop_in", "jump") : 0);
    const double compliance = of("instrument_compliance", "compliance");
    const double d = root([&](double x) { return x + compliance * law_->force(x, step) - given; },
                          given - 2 * depth_, given + 2 * depth_);
    const double force = law_->force(d, step);
    take(d, time, force);
    return force + of("baseline_tilt", "slope") * displacement;
  }

  /// Recorded displacement at a recorded force.
  double displacement_at(double force, double time, bool) {
    const double step = time - time_;
    const double d = root([&](double x) { return law_->force(x, step) - force; }, -depth_, 4 * depth_);
    take(d, time, force);
    return d + of("instrument_compliance", "compliance") * force + shift(time);
  }

 private:
  bool has(const char* id) const { return with_effects_ && world_.hides(id); }
  double of(const char* id, const char* parameter) const {
    return with_effects_ ? world_.value(id, parameter) : 0;
  }
  double shift(double time) const {
    const double wave = has("thermal_oscillation")
                            ? of("thermal_oscillation", "amplitude") *
                                  std::sin(2 * pi * time / of("thermal_oscillation", "period"))
                            : 0;
    return of("contact_point_offset", "offset") + of("thermal_drift", "rate") * time + wave;
  }
  double sensor(double displacement, bool is_loading) const {
    if (!has("piezo_hysteresis")) return 0;
    const double part = std::clamp(displacement / depth_, 0.0, 1.0);
    return (is_loading ? 1 : -1) * of("piezo_hysteresis", "share") * depth_ * 4 * part * (1 - part);
  }
  void take(double d, double time, double force) {
    law_->take(d, time - time_);
    time_ = time;
    constexpr double popping_share = 0.55;
    if (has("pop_in") && force > popping_share * program_.loads.back() / 2) popped_ = true;
  }
  template <class Function>
  static double root(const Function& f, double low, double high) {
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) (f((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
    return (low + high) / 2;
  }

  const World& world_;
  const NormalProgram& program_;
  double depth_;
  bool with_effects_;
  Sphere sphere_;
  std::unique_ptr<NormalTruth> law_;
  double time_ = 0;
  bool popped_ = false;
};

}  // namespace

World normal_world(const WorldRequest& request) {
  Random random(request.seed);
  World world;
  world.recording = paper_bodies(Motion::normal, "concealed normal loading");
  const NormalProgram program = normal_program(request, random);
  const Sphere nominal{reduced_modulus({71e9, 0.17}, {179e9, 0.25}), world.recording.particle.radius};
  choose_normal_parameters(world, request, program, nominal, random);
  const double deepest = nominal.approach_of(nominal.contact_radius_at_force(program.loads.back()));

  RecordingTable table;
  table.file = "loading.csv";
  table.control = {program.controls_force ? "normal_force" : "normal_displacement"};
  table.response = program.controls_force ? "normal_displacement" : "normal_force";
  auto &run = table.columns["run"], &time = table.columns["time"], &control = table.columns[table.control[0]],
       &response = table.columns[table.response];
  std::vector<double> without;
  int number = 0;
  for (const double load : program.loads) {
    ++number;
    NormalRun with(world, program, nominal, deepest, true), plain(world, program, nominal, deepest, false);
    const double depth = nominal.approach_of(nominal.contact_radius_at_force(load));
    const double start = program.controls_force ? 0.01 * load : -program.off_contact * deepest,
                 end = program.controls_force ? load : depth;
    double t = 0;
    const auto sample = [&](double value, const std::string& segment) {
      const bool is_loading = segment == "load";
      run.push_back(number);
      time.push_back(t);
      control.push_back(value);
      response.push_back(program.controls_force ? with.displacement_at(value, t, is_loading)
                                                : with.force_at(value, t, is_loading));
      without.push_back(program.controls_force ? plain.displacement_at(value, t, is_loading)
                                               : plain.force_at(value, t, is_loading));
      table.segment.push_back(segment);
    };
    const int n = program.load_samples;
    for (int i = 0; i < n; ++i, t += program.load_time / n)
      sample(start + (end - start) * (i + 0.5) / n, "load");
    for (int i = 0; i < program.hold_samples; ++i, t += program.hold_time / program.hold_samples)
      sample(end, "hold");
    for (int i = 0; program.unloads && i < n; ++i, t += program.load_time / n)
      sample(end - (end - start) * (i + 0.5) / n, "unload");
  }
  world.recording.tables = {table};
  world.without_effects = {without};
  return world;
}

}  // namespace asperity::hidden
