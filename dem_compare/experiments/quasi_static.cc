#include "dem_compare/experiments/quasi_static.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "core/error.h"

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Finite differences over the approach: a part of the increment, so as not to reach over a slider's limit,
/// but above rounding.
constexpr double difference_over_increment = 1e-3, smallest_difference = 1e-9, largest_difference = 1e-6;
/// Motions softer than this, over the normal stiffness, resist nothing (a free spin without torsion law) and
/// stay still.
constexpr double softest = 1e-6;
constexpr int most_iterations = 30, most_backtracks = 12;
/// An imbalance that stops shrinking below this is rounding.
constexpr double rounding = 1e-9;

/// One increment of the indenter from an accepted state.
class Increment {
 public:
  Increment(const SingleParticle& particle, const ParticleState& from, double normal_load, double length,
            double force)
      : particle_(particle), from_(from), load_(normal_load), length_(length), force_(force) {}

  int unknowns() const { return particle_.glued ? 1 : 7; }

  /// State after the indenter moved by `way` and the bodies by the unknowns u: shifts over length_, angles
  /// over length_/R.
  ParticleState moved(double way, const VectorXd& u) const {
    ParticleState state;
    state.planes = from_.planes;
    state.indenter = from_.indenter + way * Vector3d::UnitX();
    state.sphere = from_.sphere;
    if (particle_.glued) {
      state.sphere.position += Vector3d(way, 0, length_ * u[0]);
      state.indenter.z() += length_ * u[0];
    } else {
      state.sphere.position += length_ * u.head<3>();
      state.sphere.orientation =
          (rotation_by(length_ / particle_.radius * u.segment<3>(3)) * from_.sphere.orientation).normalized();
      state.indenter.z() += length_ * u[6];
    }
    for (std::size_t i = 0; i < particle_.contacts.size(); ++i)
      state.contacts.push_back(advance(particle_.contacts[i].model, from_.contacts[i],
                                       motion_of(particle_, from_, i, state.sphere, state.indenter)));
    return state;
  }

  VectorXd imbalance(const ParticleState& state) const {
    const Resultants sum = resultants(particle_, state.contacts);
    VectorXd r(unknowns());
    if (particle_.glued) {
      r[0] = (sum.force.z() - load_) / force_;
    } else {
      r.head<3>() = sum.force / force_;
      r.segment<3>(3) = sum.moment / (force_ * particle_.radius);
      r[6] = (sum.from_indenter.z() + load_) / force_;
    }
    return r;
  }

  MatrixXd tangent(double way, const VectorXd& u, const VectorXd& r) const {
    const double difference =
        std::clamp(difference_over_increment * std::max(std::abs(way) / length_, u.lpNorm<Eigen::Infinity>()),
                   smallest_difference, largest_difference);
    MatrixXd j(unknowns(), unknowns());
    for (int k = 0; k < unknowns(); ++k) {
      VectorXd shifted = u;
      shifted[k] +=
          u[k] < 0 ? -difference : difference;  // onwards, so that a slider that moves is seen moving
      j.col(k) = (imbalance(moved(way, shifted)) - r) / (shifted[k] - u[k]);
    }
    return j;
  }

  /// The equilibrium next to a first guess; empty if the method does not settle.
  std::optional<ParticleState> solve(double way, VectorXd& u, double tolerance) const {
    ParticleState state = moved(way, u);
    VectorXd r = imbalance(state);
    for (int i = 0; i < most_iterations; ++i) {
      const double size = r.lpNorm<Eigen::Infinity>();
      if (size <= tolerance) return state;
      Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors;
      factors.setThreshold(softest);
      const VectorXd step = factors.compute(tangent(way, u, r)).solve(-r);
      bool shrinks = false;
      double part = 1;
      for (int k = 0; k < most_backtracks && !shrinks; ++k, part /= 2) {
        const VectorXd next = u + part * step;
        ParticleState next_state = moved(way, next);
        const VectorXd next_r = imbalance(next_state);
        if (!(next_r.lpNorm<Eigen::Infinity>() < size)) continue;
        shrinks = true;
        u = next;
        r = next_r;
        state = std::move(next_state);
      }
      if (!shrinks) return size <= rounding ? std::optional<ParticleState>(state) : std::nullopt;
    }
    return std::nullopt;
  }

 private:
  const SingleParticle& particle_;
  const ParticleState& from_;
  double load_, length_, force_;
};

}  // namespace

FrictionLoop simulate_quasi_static(const SingleParticle& particle, const LoopProgram& program,
                                   const QuasiStaticOptions& options) {
  ParticleState state = at_rest(particle, program.normal_load);
  const NormalState& first = state.contacts.front().normal;
  const double length = first.contact_radius * first.contact_radius / particle.radius;
  double force = first.stiffness * length;
  for (std::size_t i = 0; i < state.contacts.size();
       ++i)  // adhesion can let the lateral forces exceed the load by far
    force = std::max(force, particle.contacts[i].model.sliding->limit(state.contacts[i].normal.force));
  const double increment =
      program.first_increment > 0 ? program.first_increment : resolving_increment(particle, state);

  FrictionLoop loop;
  loop.contact_names = contact_names(particle);
  loop.rows.push_back(row_of(particle, state, 0));
  VectorXd last;  // unknowns of the last increment, over its way: the next one often goes on like it
  for (const LoopStation& station : loop_stations(program, increment)) {
    int halvings = 0;
    double way = station.position - state.indenter.x();
    while (way != 0) {
      const Increment step(particle, state, program.normal_load, length, force);
      VectorXd u = last.size() ? VectorXd(way * last) : VectorXd(VectorXd::Zero(step.unknowns()));
      std::optional<ParticleState> next = step.solve(way, u, options.tolerance);
      if (!next && last.size()) {
        u.setZero();
        next = step.solve(way, u, options.tolerance);
      }
      if (!next) {
        if (++halvings > options.most_halvings) {
          std::ostringstream message;
          message << "no equilibrium of the particle was found with the indenter at "
                  << state.indenter.x() * 1e6 << " um; give a smaller first increment or growth";
          throw WorkError(message.str());
        }
        way /= 2;
        continue;
      }
      last = u / way;
      const bool arrived = way == station.position - state.indenter.x();
      state = std::move(*next);
      if (arrived) break;
      way = station.position - state.indenter.x();
    }
    loop.rows.push_back(row_of(particle, state, station.leg));
  }
  return loop;
}

}  // namespace asperity
