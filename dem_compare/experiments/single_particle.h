// An experiment with one particle, as bodies and contacts; which experiments there are:
// particle_experiment.h. Axes: x along the motion of the indenter, z up, y across. The planes do not turn;
// weight is left out (6e-11 N against 1e-4 N). Under load the sphere starts from rest, each contact closed
// along its own normal, without lateral forces. SI units.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "dem_compare/experiments/friction_loop.h"
#include "dem_compare/motion/contact_model.h"

namespace asperity {

/// Contact of the particle with one plane.
struct ParticleContact {
  std::string name;
  ContactModel model;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< from the plane to the particle
  bool on_indenter = false;                           ///< the plane moves with the indenter
  double share = 1;                                   ///< normal force over the load of the indenter, at rest
};

struct SingleParticle {
  double radius = 0;   ///< R [m]
  bool glued = false;  ///< to the indenter
  std::vector<ParticleContact> contacts;
};

/// Where the bodies are, and the contacts' accepted states.
struct ParticleState {
  Placement sphere;                                    ///< displaced from the origin
  Eigen::Vector3d indenter = Eigen::Vector3d::Zero();  ///< displacement of the indenter [m]
  std::vector<Eigen::Vector3d> planes;                 ///< a point of each plane at rest
  std::vector<ContactModelState> contacts;
};

/// Equilibrium under the load before the indenter moves.
/// normal_load [N]. Throws InputError for one that a contact cannot carry.
ParticleState at_rest(const SingleParticle& particle, double normal_load);

/// Motion of one contact from a state to new places of the sphere and the indenter.
ContactMotion motion_of(const SingleParticle& particle, const ParticleState& from, std::size_t contact,
                        const Placement& sphere, const Eigen::Vector3d& indenter);

/// Sums over the contacts.
struct Resultants {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();  ///< on the particle
  Eigen::Vector3d from_indenter = Eigen::Vector3d::Zero();  ///< on the particle, from the indenter alone [N]
};
Resultants resultants(const SingleParticle& particle, const std::vector<ContactModelState>& contacts);

/// A state as a row of the loop.
LoopRow row_of(const SingleParticle& particle, const ParticleState& state, int leg);
/// In the order of the contacts.
std::vector<std::string> contact_names(const SingleParticle& particle);

/// Way of the particle's surface to the first limit of any mode [m]. Throws InputError where no contact
/// resists.
double path_to_first_limit(const SingleParticle& particle, const ParticleState& rest);
/// Increment of the indenter that resolves the yielding of every mode: a twentieth of that way [m].
double resolving_increment(const SingleParticle& particle, const ParticleState& rest);

}  // namespace asperity
