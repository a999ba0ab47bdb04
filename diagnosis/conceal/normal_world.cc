// Loading, holding and unloading of a sphere.
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/hertz.h"
#include "diagnosis/conceal/bridged_sphere.h"
#include "diagnosis/conceal/normal_program.h"
#include "diagnosis/conceal/normal_truth.h"
#include "diagnosis/conceal/other_code_truth.h"
#include "diagnosis/conceal/relaxing_sphere.h"
#include "diagnosis/conceal/world.h"

namespace asperity::hidden {
namespace {

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

/// Makes the law of the contact anew for each run; a layer, a surface or a film, which has no history, only
/// once.
class ContactLaw {
 public:
  /// depth: largest approach [m], at the force `largest` [N].
  ContactLaw(const World& world, const WorldRequest& request, Sphere sphere, double depth, double largest)
      : world_(world), by_other_code_(request.setting == by_other_code), sphere_(sphere), depth_(depth) {
    if (world.hides("effective_radius")) sphere_.radius *= world.value("effective_radius", "radius_ratio");
    const RecordedBody &on = world.recording.particle, &below = world.recording.substrate;
    constexpr double beyond = 1.5;  // of the largest approach or force
    if (world.hides("film"))
      elastic_ = coated_half_spaces(elastic_body(on), elastic_body(below), sphere_.radius,
                                    of("film", "modulus_ratio"), of("film", "thickness"), beyond * largest);
    const char* rough = "roughness_compliance";
    if (!world.hides(rough)) return;
    if (!by_other_code_)
      elastic_ = rough_truth(sphere_, of(rough, "roughness_length"), beyond * depth);
    else
      elastic_ = rough_half_spaces(
          elastic_body(on), elastic_body(below), sphere_.radius,
          {of(rough, "rms"), of(rough, "rolloff"), of(rough, "cutoff"), request.seed}, beyond * largest);
  }

  std::shared_ptr<NormalTruth> law() const {
    if (elastic_) return elastic_;
    if (world_.hides("adhesion"))
      return std::make_shared<AdhesiveTruth>(adhesive_by_pull_off(sphere_, of("adhesion", "pull_off_force")));
    if (world_.hides("adhesion_hysteresis"))
      return std::make_shared<HystereticTruth>(adhesive(sphere_, of("adhesion_hysteresis", "work_closing")),
                                               adhesive(sphere_, of("adhesion_hysteresis", "work_opening")));
    const double yield_stress = of("bulk_plasticity", "yield_stress");
    if (yield_stress > 0 && by_other_code_)
      return std::make_shared<TabledYielding>(sphere_.reduced_modulus, sphere_.radius, yield_stress);
    if (yield_stress > 0)
      return std::make_shared<PlasticTruth>(sphere_.reduced_modulus, sphere_.radius, 0.17, yield_stress);
    if (world_.hides("creep"))
      return std::make_shared<CreepingTruth>(sphere_, of("creep", "amplitude"), of("creep", "time_constant"));
    constexpr double softened = 4;  // of the largest approach, for a force that is held as the body relaxes
    if (world_.hides("viscoelasticity"))
      return std::make_shared<RelaxingSphere>(sphere_, of("viscoelasticity", "share"),
                                              of("viscoelasticity", "time_constant"), softened * depth_);
    if (world_.hides("capillary"))
      return std::make_shared<BridgedSphere>(sphere_, of("capillary", "pull_off_force"),
                                             of("capillary", "rupture_distance"));
    return std::make_shared<ElasticTruth>(sphere_);
  }

 private:
  static ElasticBody elastic_body(const RecordedBody& body) {
    return {body.youngs_modulus, body.poissons_ratio};
  }
  double of(const char* id, const char* parameter) const { return world_.value(id, parameter); }

  const World& world_;
  bool by_other_code_;
  Sphere sphere_;
  double depth_;
  std::shared_ptr<NormalTruth> elastic_;  ///< rough or coated; null: none
};

class NormalRun {
 public:
  /// law: of the contact with its effects; null: the nominal sphere, without any.
  NormalRun(const World& world, const NormalProgram& program, const Sphere& nominal, double depth,
            std::shared_ptr<NormalTruth> law)
      : world_(world), program_(program), depth_(depth), with_effects_(law != nullptr), law_(std::move(law)) {
    if (!law_) law_ = std::make_shared<ElasticTruth>(nominal);
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
    return force + of("baseline_tilt", "slope") * displacement + ripple(displacement);
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
  double ripple(double displacement) const {
    if (!has("interference")) return 0;
    return of("interference", "amplitude") * std::sin(2 * pi * displacement / of("interference", "period"));
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
  std::shared_ptr<NormalTruth> law_;
  double time_ = 0;
  bool popped_ = false;
};

}  // namespace

World normal_world(const WorldRequest& request) {
  Random random(request.seed);
  World world;
  world.recording = paper_bodies(Motion::normal, "concealed normal loading");
  const NormalProgram program = normal_program(request, random);
  if (request.setting == by_other_code && request.asks_for("bulk_plasticity"))
    world.recording.substrate = {"diamond", 1140e9, 0.07, RecordedBody::unknown, 0, RecordedBody::unknown};
  const RecordedBody &sphere = world.recording.particle, &plane = world.recording.substrate;
  const Sphere nominal{reduced_modulus({sphere.youngs_modulus, sphere.poissons_ratio},
                                       {plane.youngs_modulus, plane.poissons_ratio}),
                       sphere.radius};
  choose_normal_parameters(world, request, program, nominal, random);
  const double deepest = nominal.approach_of(nominal.contact_radius_at_force(program.loads.back()));

  const ContactLaw contact(world, request, nominal, deepest, program.loads.back());
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
    NormalRun with(world, program, nominal, deepest, contact.law()),
        plain(world, program, nominal, deepest, nullptr);
    const double depth = nominal.approach_of(nominal.contact_radius_at_force(load));
    const double start = program.controls_force ? 0.01 * load : -program.off_contact * deepest,
                 end = program.controls_force ? load : depth;
    const double ramp = program.load_time * std::pow(program.slower, number - 1);
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
    for (int i = 0; i < n; ++i, t += ramp / n) sample(start + (end - start) * (i + 0.5) / n, "load");
    for (int i = 0; i < program.hold_samples; ++i, t += program.hold_time / program.hold_samples)
      sample(end, "hold");
    for (int i = 0; program.unloads && i < n; ++i, t += ramp / n)
      sample(end - (end - start) * (i + 0.5) / n, "unload");
  }
  world.recording.tables = {table};
  world.without_effects = {without};
  return world;
}

}  // namespace asperity::hidden
