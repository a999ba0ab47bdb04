// Friction loops of a sphere that is glued to its indenter.
#include <cmath>

#include "diagnosis/conceal/sliding_run.h"
#include "diagnosis/conceal/sphere.h"
#include "diagnosis/conceal/world.h"

namespace asperity::hidden {
namespace {

SlidingProgram sliding_program(const WorldRequest& request, Random& random) {
  SlidingProgram program;
  const double largest = between(random, 150e-6, 300e-6);
  program.loads = {largest / 8, largest / 4, largest / 2, largest};
  program.speeds = {1e-6};
  if (request.asks_for("velocity_dependence"))
    program.speeds = {0.1e-6, 1e-6, 10e-6}, program.loads = {largest / 4, largest}, program.cycles = 1;
  if (request.asks_for("run_in"))
    program.cycles = 12, program.loads = {largest / 4, largest}, program.samples = 40;
  if (request.asks_for("stick_slip")) {
    // At one load it is no question whether friction is the top of the teeth or their mean.
    program.loads = request.effects.size() > 1 ? std::vector<double>{largest / 2, largest}
                                               : std::vector<double>{largest, largest};
    program.samples = 240;
    program.cycles = 1;
  }
  if (request.asks_for("partial_slip") || request.setting == "small_loops") {
    const double heavy = between(random, 1e-3, 3e-3);
    program.loads = {heavy / 3, heavy};
    program.amplitude = 45e-9;
    program.samples = 100;
    program.cycles = 1;
  }
  if (request.asks_for("rate_and_state")) {
    program.steps_speed = true;
    program.loads = {largest};
    program.speeds = {1e-6, 3e-6, 1e-6, 3e-6, 1e-6};  // where ageing and slip laws are still alike
    program.amplitude = 4e-6;
    program.samples = 160;
    program.cycles = 1;
  }
  if (request.setting == "one_load") program.loads = {largest}, program.cycles = 4;
  return program;
}

void choose_sliding_parameters(World& world, const WorldRequest& request, const SlidingProgram& program,
                               double friction, Random& random) {
  const double low = program.loads.front(), high = program.loads.back(), middle = std::sqrt(low * high);
  for (const auto& id : request.effects) {
    if (id == "lateral_compliance")
      world.hide(id, "springs in series, stick and slip separated by events", "compliance",
                 between(random, 0.06, 0.2) * program.amplitude / (friction * high));
    else if (id == "adhesion_offset")
      // Beside stick-slip an offset also holds the difference between the top of the teeth and their mean.
      world.hide(id, "constant attraction under Coulomb's law", "adhesion_force",
                 between(random, 0.3, 1.2) * low, !request.asks_for("stick_slip"));
    else if (id == "static_friction_peak") {
      const char* model = "state that is renewed with slip, integrated in small steps";
      world.hide(id, model, "peak_ratio", between(random, 1.2, 1.6));
      world.hide(id, model, "slip_length", between(random, 0.08, 0.25) * program.amplitude);
    } else if (id == "velocity_dependence")
      world.hide(id, "Eyring: sinh^-1(v/2 v*), v* far below all speeds", "coefficient",
                 sign(random) * between(random, 0.03, 0.08) * friction);
    else if (id == "partial_slip")
      world.hide(id, "Mindlin & Deresiewicz in closed form with Masing's rule", "", 0);
    else if (id == "surface_tilt")
      world.hide(id, "forces turned into the instrument's frame", "angle",
                 sign(random) * between(random, 0.02, 0.06));
    else if (id == "lateral_zero_offset")
      world.hide(id, "zero of the force", "offset",
                 sign(random) * between(random, 0.1, 0.3) * friction * middle);
    else if (id == "area_proportional_friction")
      world.hide(id, "shear stress on the area of a true sphere (Sneddon 1965)", "shear_strength",
                 0);  // follows below, with the area
    else if (id == "run_in") {
      const char* model = "friction that fades with the path, not by whole cycles";
      world.hide(id, model, "change", between(random, 0.25, 0.7), false);
      world.hide(id, model, "cycles", between(random, 2, 5));
    } else if (id == "stick_slip") {
      const char* model = "slip events of irregular spacing and size";
      world.hide(id, model, "amplitude", between(random, 0.12, 0.3) * friction * low);
      world.hide(id, model, "period", between(random, 0.12, 0.25) * program.amplitude);
    } else if (id == "rate_and_state") {
      const char* model = "slip law of Ruina 1983, integrated in small steps";
      const double a = world.hide(id, model, "a", between(random, 0.06, 0.12) * friction);
      world.hide(id, model, "b", between(random, 1.4, 2.2) * a);
      world.hide(id, model, "slip_distance", between(random, 0.02, 0.05) * program.amplitude);
    } else if (id == "position_weakening") {
      world.hide(id, "friction falls at one place", "share", between(random, 0.25, 0.5), false);
      world.hide(id, "", "place", sign(random) * between(random, 0.2, 0.6) * program.amplitude, false);
      world.hide(id, "", "width", between(random, 0.08, 0.2) * program.amplitude, false);
    } else if (id == "lateral_oscillation") {
      world.hide(id, "the force oscillates in time", "amplitude",
                 between(random, 0.08, 0.2) * friction * middle, false);
      world.hide(id, "", "period",
                 between(random, 0.25, 0.6) * 2 * program.amplitude / program.speeds.front(), false);
    }
  }
}

/// Records runs, with the effects and without, one after the other into a table.
class LoopRecorder {
 public:
  LoopRecorder(const World& world, const SlidingProgram& program, double friction, unsigned seed)
      : world_(world), program_(program), friction_(friction), seed_(seed) {
    table_.file = "loops.csv";
    table_.control = {"lateral_displacement", "normal_force"};
    table_.response = "lateral_force";
  }
  const RecordingTable& table() const { return table_; }
  const std::vector<double>& without_effects() const { return without_; }

  void record_speed_steps(double load) {
    Run run(*this, load);
    const int n = program_.samples;
    const auto parts = static_cast<double>(program_.speeds.size());
    for (std::size_t s = 0; s < program_.speeds.size(); ++s)
      for (int i = 0; i < n; ++i)
        run.sample(program_.amplitude / parts * (static_cast<double>(s) + (i + 1.0) / n), program_.speeds[s],
                   0, "forward");
  }

  void record_loops(double load, double speed) {
    Run run(*this, load);
    const double A = program_.amplitude;
    const int n = program_.samples;
    for (int i = 0; i < n / 2; ++i) run.sample(2 * A * (i + 1) / n, speed, 0, "forward");
    for (int c = 0; c < program_.cycles; ++c) {
      for (int i = 0; i < n; ++i)
        run.sample(A - 2 * A * (i + 1) / n, speed, c + 0.5 * (i + 1.0) / n, "backward");
      for (int i = 0; i < n; ++i)
        run.sample(-A + 2 * A * (i + 1) / n, speed, c + 0.5 + 0.4999 * (i + 1.0) / n, "forward");
    }
  }

 private:
  class Run {
   public:
    Run(LoopRecorder& to, double load)
        : to_(to),
          load_(load),
          with_(to.world_, to.program_, to.friction_, load, true,
                to.seed_ + 1000u * static_cast<unsigned>(++to.number_)),
          plain_(to.world_, to.program_, to.friction_, load, false, 1) {}

    void sample(double position, double speed, double cycle, const char* segment) {
      time_ += std::abs(position - position_) / speed;
      position_ = position;
      const auto put = [&](const char* channel, double value) {
        to_.table_.columns[channel].push_back(value);
      };
      put("run", to_.number_);
      put("cycle", std::floor(cycle));
      put("time", time_);
      put("speed", speed);
      put("lateral_displacement", position);
      put("normal_force", load_);
      put("lateral_force", with_.force_at(position, time_, speed, cycle));
      to_.without_.push_back(plain_.force_at(position, time_, speed, cycle));
      to_.table_.segment.push_back(segment);
    }

   private:
    LoopRecorder& to_;
    double load_, time_ = 0, position_ = 0;
    SlidingRun with_, plain_;
  };

  const World& world_;
  const SlidingProgram& program_;
  double friction_;
  unsigned seed_;
  int number_ = 0;
  RecordingTable table_;
  std::vector<double> without_;
};

}  // namespace

World sliding_world(const WorldRequest& request) {
  Random random(request.seed);
  World world;
  world.recording = paper_bodies(Motion::sliding, "concealed friction loops");
  const SlidingProgram program = sliding_program(request, random);
  const double friction = between(random, 0.2, 0.45);
  choose_sliding_parameters(world, request, program, friction, random);
  if (world.hides("area_proportional_friction")) {
    const SlidingRun middle(world, program, friction, program.loads[program.loads.size() / 2], false, 1);
    const double a = middle.contact_radius();
    world.hide("area_proportional_friction", "", "shear_strength",
               friction * program.loads[program.loads.size() / 2] / (pi * a * a));
  }
  world.coefficients["sliding_friction"] = friction;
  world.recording.simulation_is_given = true;
  world.recording.simulation.parameters["sliding_friction"] = {friction * between(random, 0.7, 1.4), true};

  LoopRecorder recorder(world, program, friction, request.seed);
  for (const double load : program.loads)
    if (program.steps_speed)
      recorder.record_speed_steps(load);
    else
      for (const double speed : program.speeds) recorder.record_loops(load, speed);
  world.recording.tables = {recorder.table()};
  world.without_effects = {recorder.without_effects()};
  return world;
}

}  // namespace asperity::hidden
