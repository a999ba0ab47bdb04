// Friction loops of a sphere that is glued to its indenter.
#include <algorithm>
#include <cmath>

#include "dem_compare/laws/shear_moduli.h"
#include "diagnosis/conceal/masing_contact.h"
#include "diagnosis/conceal/sphere.h"
#include "diagnosis/conceal/world.h"

namespace asperity::hidden {
namespace {

struct SlidingProgram {
  std::vector<double> loads;     ///< [N]
  std::vector<double> speeds;    ///< of each load's runs [m/s]
  double amplitude = 250e-9;     ///< [m]
  int cycles = 2, samples = 60;  ///< of one direction
  bool steps_speed = false;      ///< one long stroke with steps of speed
};

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

/// One run at one load; driven in small steps between samples.
class SlidingRun {
 public:
  SlidingRun(const World& world, const SlidingProgram& program, double friction, double load,
             bool with_effects, unsigned seed)
      : world_(world),
        program_(program),
        with_effects_(with_effects),
        friction_(friction),
        load_(load),
        events_(seed) {
    const ElasticBody sphere{71e9, 0.17}, plane{179e9, 0.25};
    radius_ = Sphere{reduced_modulus(sphere, plane), 8.5e-6}.contact_radius_at_force(load);
    stiffness_ = 8 * sliding_modulus(sphere, plane) * radius_;
    if (has("partial_slip")) masing_ = MasingContact(stiffness_, friction_ * load_);
    next_event();
  }

  double contact_radius() const { return radius_; }

  double force_at(double position, double time, double speed, double cycle) {
    constexpr int steps = 40;
    const double from = position_, start = time_, compliance = of("lateral_compliance", "compliance");
    const int direction = position > from ? 1 : -1;
    if (direction != direction_ && position != from) {
      slip_ = 0;
      direction_ = direction;
      next_event();
    }
    for (int i = 1; i <= steps; ++i) {
      const double step = (position - from) / steps, dt = (time - start) / steps;
      advance_state(speed, dt);
      const double stiffness = 1 / (1 / stiffness_ + compliance), trial = force_ + stiffness * step;
      // The limit at the end of the step depends on what slips in it.
      double slipped = 0, most = limit(from + i * step, speed, cycle, 0);
      constexpr int rounds = 3;
      for (int round = 0; round < rounds; ++round) {
        slipped = std::max(0.0, (std::abs(trial) - most) / stiffness);
        most = limit(from + i * step, speed, cycle, slipped);
      }
      slip_ += slipped;
      sawtooth_ += slipped;
      force_ = slipped > 0 ? std::copysign(most, trial) : trial;
      if (sawtooth_ > period_) next_event();
    }
    position_ = position;
    time_ = time;
    if (has("partial_slip")) force_ = masing_.force(position);
    return recorded(time);
  }

 private:
  bool has(const char* id) const { return with_effects_ && world_.hides(id); }
  double of(const char* id, const char* parameter) const {
    return with_effects_ ? world_.value(id, parameter) : 0;
  }

  void next_event() {
    std::normal_distribution<double> normal;
    constexpr double irregular_spacing = 0.005, irregular_size = 0.05;
    period_ = of("stick_slip", "period") * (1 + irregular_spacing * normal(events_));
    drop_ = of("stick_slip", "amplitude") * (1 + irregular_size * normal(events_));
    sawtooth_ = 0;
  }

  /// dtheta/dt = -(v theta/L) ln(v theta/L)
  void advance_state(double speed, double dt) {
    if (!has("rate_and_state")) return;
    const double length = of("rate_and_state", "slip_distance");
    if (theta_ <= 0) theta_ = length / speed;
    theta_ *= std::exp(-speed * dt / length * std::log(speed * theta_ / length));
  }

  double limit(double position, double speed, double cycle, double slipped) const {
    double mu = friction_;
    if (has("velocity_dependence")) {
      constexpr double far_below = 1e-12;  // v* [m/s]
      const double reference = 1e-6, b = of("velocity_dependence", "coefficient");
      mu += b * (std::asinh(speed / (2 * far_below)) - std::asinh(reference / (2 * far_below)));
    }
    if (has("rate_and_state")) {
      const double a = of("rate_and_state", "a"), b = of("rate_and_state", "b"),
                   length = of("rate_and_state", "slip_distance");
      const double reference = 1e-6;
      mu += a * std::log(speed / reference) + b * std::log(reference * theta_ / length);
    }
    if (has("static_friction_peak"))
      mu *= 1 + (of("static_friction_peak", "peak_ratio") - 1) *
                    std::exp(-(slip_ + slipped) / of("static_friction_peak", "slip_length"));
    if (has("run_in")) mu *= 1 + of("run_in", "change") * std::exp(-cycle / of("run_in", "cycles"));
    if (has("position_weakening")) {
      const double x = (position - of("position_weakening", "place")) / of("position_weakening", "width");
      mu *= 1 - of("position_weakening", "share") * std::exp(-x * x / 2);
    }
    double most = mu * (load_ + of("adhesion_offset", "adhesion_force"));
    if (has("area_proportional_friction"))
      most = of("area_proportional_friction", "shear_strength") * pi * radius_ * radius_;
    if (has("stick_slip")) most -= drop_ * (1 - std::min(1.0, (sawtooth_ + slipped) / period_));
    return most;
  }

  double recorded(double time) const {
    double force = force_ + of("lateral_zero_offset", "offset");
    if (has("surface_tilt")) {
      // Balance along and across the instrument's axis: N cos = f_n + T sin, F = N sin + T cos.
      const double angle = of("surface_tilt", "angle");
      force = (force + std::sin(angle) * load_) / std::cos(angle);
    }
    if (has("lateral_oscillation"))
      force += of("lateral_oscillation", "amplitude") *
               std::sin(2 * pi * time / of("lateral_oscillation", "period"));
    return force;
  }

  const World& world_;
  const SlidingProgram& program_;
  bool with_effects_;
  double friction_, load_, radius_ = 0, stiffness_ = 0;
  Random events_;
  MasingContact masing_;
  double force_ = 0, position_ = 0, time_ = 0, slip_ = 0, theta_ = 0;
  double period_ = 0, drop_ = 0, sawtooth_ = 0;  ///< of stick-slip
  int direction_ = 1;
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

  RecordingTable table;
  table.file = "loops.csv";
  table.control = {"lateral_displacement", "normal_force"};
  table.response = "lateral_force";
  auto &run = table.columns["run"], &cycle = table.columns["cycle"], &time = table.columns["time"],
       &speed = table.columns["speed"];
  auto &x = table.columns["lateral_displacement"], &load = table.columns["normal_force"],
       &response = table.columns["lateral_force"];
  std::vector<double> without;
  int number = 0;
  for (const double f : program.loads) {
    const std::size_t runs = program.steps_speed ? 1 : program.speeds.size();
    for (std::size_t r = 0; r < runs; ++r) {
      ++number;
      SlidingRun with(world, program, friction, f, true,
                      request.seed + 1000u * static_cast<unsigned>(number));
      SlidingRun plain(world, program, friction, f, false, 1);
      double t = 0, before = 0;
      const auto sample = [&](double position, double v, double loop, const char* segment) {
        t += std::abs(position - before) / v;
        before = position;
        run.push_back(number), cycle.push_back(std::floor(loop)), time.push_back(t), speed.push_back(v);
        x.push_back(position), load.push_back(f);
        response.push_back(with.force_at(position, t, v, loop));
        without.push_back(plain.force_at(position, t, v, loop));
        table.segment.push_back(segment);
      };
      if (program.steps_speed) {
        const int n = program.samples;
        const auto parts = static_cast<double>(program.speeds.size());
        for (std::size_t s = 0; s < program.speeds.size(); ++s)
          for (int i = 0; i < n; ++i)
            sample(program.amplitude / parts * (static_cast<double>(s) + (i + 1.0) / n), program.speeds[s], 0,
                   "forward");
        continue;
      }
      const double v = program.speeds[r], A = program.amplitude;
      const int n = program.samples;
      for (int i = 0; i < n / 2; ++i) sample(2 * A * (i + 1) / n, v, 0, "forward");
      for (int c = 0; c < program.cycles; ++c) {
        for (int i = 0; i < n; ++i) sample(A - 2 * A * (i + 1) / n, v, c + 0.5 * (i + 1.0) / n, "backward");
        for (int i = 0; i < n; ++i)
          sample(-A + 2 * A * (i + 1) / n, v, c + 0.5 + 0.4999 * (i + 1.0) / n, "forward");
      }
    }
  }
  world.recording.tables = {table};
  world.without_effects = {without};
  return world;
}

}  // namespace asperity::hidden
