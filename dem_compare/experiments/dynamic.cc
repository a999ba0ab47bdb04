#include "dem_compare/experiments/dynamic.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/error.h"

namespace asperity {
namespace {

using Eigen::Vector3d;

/// Particle and indenter with their velocities. The glued particle moves with the indenter and cannot turn.
class MovingParticle {
 public:
  MovingParticle(const SingleParticle& particle, double normal_load, const DynamicOptions& options)
      : particle_(particle), load_(normal_load), state_(at_rest(particle, normal_load)) {
    mass_ = 4.0 / 3 * M_PI * std::pow(particle.radius, 3) * options.density;
    inertia_ = 0.4 * mass_ * particle.radius * particle.radius;
    indenter_mass_ = options.indenter_mass > 0 ? options.indenter_mass : mass_;
    if (particle.glued && options.indenter_mass > 0) mass_ += options.indenter_mass;  // they move as one
    double stiffest = 0;
    for (const ContactModelState& contact : state_.contacts)
      stiffest = std::max(stiffest, contact.normal.stiffness);
    response_time_ = std::sqrt(std::min(mass_, indenter_mass_) / stiffest);
    time_step_ = options.time_step_ratio * response_time_;
  }

  double time_step() const { return time_step_; }
  /// (m/k)^(1/2) [s]
  double response_time() const { return response_time_; }
  const ParticleState& state() const { return state_; }

  /// One step with the indenter's x moved at `speed`.
  void step(double speed) {
    const double dt = time_step_;
    indenter_velocity_.x() = speed;
    const Vector3d velocity = velocity_ + dt / 2 * acceleration_, spin = spin_ + dt / 2 * spin_acceleration_;
    indenter_velocity_.z() += dt / 2 * indenter_acceleration_;
    ParticleState next;
    next.planes = state_.planes;
    next.sphere = state_.sphere;
    if (particle_.glued) {
      velocity_ = Vector3d(speed, 0, velocity.z());
      spin_.setZero();
      next.sphere.position += dt * velocity_;
      next.indenter = next.sphere.position;
      indenter_velocity_.z() = velocity.z();
    } else {
      velocity_ = velocity;
      spin_ = spin;
      next.sphere.position += dt * velocity_;
      next.sphere.orientation = (rotation_by(dt * spin_) * state_.sphere.orientation).normalized();
      next.indenter = state_.indenter + dt * indenter_velocity_;
    }
    next.contacts.reserve(state_.contacts.size());
    for (std::size_t i = 0; i < particle_.contacts.size(); ++i) {
      const ContactMotion motion = motion_of(particle_, state_, i, next.sphere, next.indenter);
      const Vector3d contact = next.sphere.position - motion.lever * motion.normal;
      const BodyVelocity body{next.sphere.position, velocity_, spin_};
      const BodyVelocity plane{
          contact, particle_.contacts[i].on_indenter ? indenter_velocity_ : Vector3d(Vector3d::Zero()),
          Vector3d::Zero()};
      next.contacts.push_back(advance(particle_.contacts[i].model, state_.contacts[i], motion,
                                      relative_velocity(body, plane, contact, motion.normal), mass_));
    }
    state_ = std::move(next);
    const Resultants sum = resultants(particle_, state_.contacts);
    if (particle_.glued) {
      acceleration_ = Vector3d(0, 0, (sum.force.z() - load_) / mass_);
    } else {
      acceleration_ = sum.force / mass_;
      spin_acceleration_ = sum.moment / inertia_;
      indenter_acceleration_ = (-sum.from_indenter.z() - load_) / indenter_mass_;
      spin_ += dt / 2 * spin_acceleration_;
    }
    velocity_ += dt / 2 * acceleration_;
    indenter_velocity_.z() += dt / 2 * indenter_acceleration_;
  }

 private:
  const SingleParticle& particle_;
  double load_, mass_ = 0, inertia_ = 0, indenter_mass_ = 0, response_time_ = 0, time_step_ = 0;
  ParticleState state_;
  Vector3d velocity_ = Vector3d::Zero(), acceleration_ = Vector3d::Zero();
  Vector3d spin_ = Vector3d::Zero(), spin_acceleration_ = Vector3d::Zero();
  Vector3d indenter_velocity_ = Vector3d::Zero();
  double indenter_acceleration_ = 0;
};

void check_contacts(const SingleParticle& particle, const ParticleState& state) {
  for (std::size_t i = 0; i < state.contacts.size(); ++i) {
    if (state.contacts[i].normal.touching && std::isfinite(state.contacts[i].normal.force)) continue;
    std::ostringstream message;
    message << "the contact '" << particle.contacts[i].name << "' opened with the indenter at "
            << state.indenter.x() * 1e6 << " um; give a lower speed, more damping or a smaller time step";
    throw WorkError(message.str());
  }
}

}  // namespace

FrictionLoop simulate_dynamic(const SingleParticle& particle, const LoopProgram& program,
                              const DynamicOptions& options) {
  if (!(options.speed > 0)) throw InputError("the indenter's speed is not positive; give one such as 1 mm/s");
  MovingParticle motion(particle, program.normal_load, options);
  const double increment =
      program.first_increment > 0 ? program.first_increment : resolving_increment(particle, motion.state());
  // Slow until a fifth beyond the first limit; as far before the end of a leg, to slide and roll steadily
  // again after braking.
  const double way = path_to_first_limit(particle, motion.state()), slow_path = 1.2 * way;
  const double slow = std::min(options.speed, options.reversal_share * way / motion.response_time());
  FrictionLoop loop;
  loop.contact_names = contact_names(particle);
  loop.speed = options.speed;
  loop.rows.push_back(row_of(particle, motion.state(), 0));
  for (const LoopStation& station : loop_stations(program, increment)) {
    const double direction = station.leg % 2 == 0 ? 1 : -1;
    const double start = station.leg == 0 ? 0 : -direction * program.amplitude,
                 end = direction * program.amplitude;
    for (double x = motion.state().indenter.x(); (station.position - x) * direction > 0;
         x = motion.state().indenter.x()) {
      const bool near_reversal = std::abs(x - start) < slow_path ||
                                 std::abs(end - x) < slow_path + options.speed * motion.time_step();
      motion.step(direction * (near_reversal ? slow : options.speed));
    }
    if (loop.rows.back().leg == station.leg &&
        loop.rows.back().indenter_displacement == motion.state().indenter.x())
      continue;  // two stations within one time step
    check_contacts(particle, motion.state());
    loop.rows.push_back(row_of(particle, motion.state(), station.leg));
  }
  return loop;
}

}  // namespace asperity
