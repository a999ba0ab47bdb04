#include "dem_compare/experiments/single_particle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace asperity {

using Eigen::Vector3d;

ParticleState at_rest(const SingleParticle& particle, double normal_load) {
  ParticleState state;
  for (const ParticleContact& contact : particle.contacts) {
    const double force = contact.share * normal_load, approach = contact.model.normal->approach(force);
    if (!std::isfinite(approach))
      throw InputError("the contact '" + contact.name + "' cannot carry a normal force of " +
                       std::to_string(force * 1e6) + " uN; give a load above its pull-off");
    state.planes.push_back(-(particle.radius - approach) * contact.normal);
    ContactMotion motion;
    motion.normal = contact.normal;
    ContactModelState contact_state;
    for (const double reached :
         {std::max(0.0, approach), approach}) {  // adhesive contacts form at zero approach
      motion.approach = reached;
      motion.lever =
          contact.model.lever == LeverArm::particle_radius ? particle.radius : particle.radius - reached;
      contact_state = advance(contact.model, contact_state, motion);
    }
    state.contacts.push_back(contact_state);
  }
  return state;
}

ContactMotion motion_of(const SingleParticle& particle, const ParticleState& from, std::size_t contact,
                        const Placement& sphere, const Vector3d& indenter) {
  const ParticleContact& c = particle.contacts[contact];
  PlanePlacement before, after;
  before.normal = after.normal = c.normal;
  before.position = from.planes[contact] + (c.on_indenter ? from.indenter : Vector3d(Vector3d::Zero()));
  after.position = from.planes[contact] + (c.on_indenter ? indenter : Vector3d(Vector3d::Zero()));
  return sphere_on_plane(from.sphere, sphere, particle.radius, before, after, c.model.lever,
                         c.model.history_spin);
}

Resultants resultants(const SingleParticle& particle, const std::vector<ContactModelState>& contacts) {
  Resultants sum;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    sum.force += contacts[i].force;
    sum.moment += contacts[i].moment;
    if (particle.contacts[i].on_indenter) sum.from_indenter += contacts[i].force;
  }
  if (particle.glued) sum.from_indenter = -sum.force;  // the glue holds the rest of the balance
  return sum;
}

LoopRow row_of(const SingleParticle& particle, const ParticleState& state, int leg) {
  const Resultants sum = resultants(particle, state.contacts);
  LoopRow row{leg,
              state.indenter.x(),
              sum.from_indenter.x(),
              -sum.from_indenter.z(),
              state.sphere.position,
              rotation_vector(state.sphere.orientation),
              {}};
  for (const ContactModelState& contact : state.contacts) row.contacts.push_back(record_of(contact));
  return row;
}

std::vector<std::string> contact_names(const SingleParticle& particle) {
  std::vector<std::string> names;
  for (const ParticleContact& contact : particle.contacts) names.push_back(contact.name);
  return names;
}

double path_to_first_limit(const SingleParticle& particle, const ParticleState& rest) {
  double way = std::numeric_limits<double>::infinity();
  const auto consider = [&](double limit, double stiffness, double lever) {
    if (limit > 0 && stiffness > 0) way = std::min(way, limit / stiffness * lever);
  };
  for (std::size_t i = 0; i < rest.contacts.size(); ++i) {
    const ContactModel& model = particle.contacts[i].model;
    const ContactModelState& state = rest.contacts[i];
    consider(model.sliding->limit(state.normal.force), state.sliding.spring.stiffness, 1);
    if (particle.glued) continue;
    consider(model.rolling->limit(state.normal, state.lever), state.rolling.stiffness, state.lever);
    consider(model.torsion->limit(state.normal, state.lever), state.torsion.stiffness, state.lever);
  }
  if (!std::isfinite(way))
    throw InputError(
        "no contact of this experiment resists any motion under this load; give a larger load or a sliding "
        "coefficient");
  return way;
}

double resolving_increment(const SingleParticle& particle, const ParticleState& rest) {
  constexpr double increments_before_yielding = 20;
  return path_to_first_limit(particle, rest) / increments_before_yielding;
}

}  // namespace asperity
