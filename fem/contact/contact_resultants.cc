// Forces, moments and contact area of a state, from the interface's tractions and from the bodies' reactions.
#include <algorithm>
#include <cmath>

#include "fem/contact/contact_area.h"
#include "fem/contact/contact_solver.h"

namespace asperity::fem {
namespace {

struct PressureMoments {
  std::array<double, 2> centre{};
  double hertzian_radius =
      0;  ///< of the Hertzian pressure with the same second moment, which is 2 a^2 / 5 under it
};

PressureMoments moments_of(const ContactSystem& system, const std::vector<double>& pressure) {
  double force = 0, x = 0, y = 0, square = 0;
  for (std::size_t r = 0; r < pressure.size(); ++r) {
    const double f = pressure[r] * system.areas()[r];
    const auto& p = system.row_points()[r];
    force += f, x += f * p[0], y += f * p[1], square += f * (p[0] * p[0] + p[1] * p[1]);
  }
  if (force <= 0) return {};
  const RigidMotion shift = system.coupling().surface();
  return {{x / force + shift.x, y / force + shift.y},
          std::sqrt(2.5 * std::max(0.0, square / force - (x * x + y * y) / force / force))};
}

}  // namespace

ContactResultants ContactSolver::resultants(const ContactState& state) const {
  ContactResultants result;
  const std::vector<double> gap = gaps(state);
  const std::array<double, 2> moment = add_rows(state, gap, result);
  add_shape(state, gap, result);
  if (result.force > 0)
    result.moment_error = std::hypot(moment[0], moment[1]) / (result.force * std::sqrt(result.area / M_PI));
  add_reactions(state, result);
  return result;
}

std::array<double, 2> ContactSolver::add_rows(const ContactState& state, const std::vector<double>& gap,
                                              ContactResultants& result) const {
  double moment_x = 0, moment_y = 0;
  const double radius = system_.options().mesh.sizes.radius;
  const Rotation turn = rotation(state.motion);
  const RigidMotion shift = system_.coupling().surface();
  std::array<std::vector<double>, 3> displacement;
  for (int c = 0; c < 3; ++c)
    displacement[c] = system_.interface().nodes().gather(state.displacement.begin(), c);
  result.sticking = tractions_.has_friction() ? tractions_.sticking() : 0;
  for (std::size_t r = 0; r < state.multiplier.size(); ++r) {
    const double p = state.multiplier[r];
    const int own = system_.rows()[r].node;
    auto material = system_.interface_points()[own];
    for (int c = 0; c < 3; ++c) material[c] += displacement[c][own];
    const auto place = turned(turn, material, radius);
    const double attraction =
        tractions_.has_adhesion() ? tractions_.attraction(state, static_cast<int>(r), gap[r]).stress : 0.0;
    const double force = (p - attraction) * system_.areas()[r];
    const auto& slope = system_.interface().slope(static_cast<int>(r));
    const double fx = state.shear[0][r] * system_.areas()[r] + force * slope[0],
                 fy = state.shear[1][r] * system_.areas()[r] + force * slope[1];
    result.lateral_force[0] -= fx, result.lateral_force[1] -= fy;
    result.torsion_moment -= place[0] * fy - place[1] * fx;
    // About the rolling axis (-sin, cos, 0) through the smooth shape's lowest point, which the approach has
    // taken down: this moment, less radius times the lateral force, is the one about the centre that the roll
    // turns, hence conjugate to its angle.
    const double lever = place[2] + state.approach;
    result.rolling_moment -= std::cos(state.motion.spin) * (lever * fx - place[0] * force) -
                             std::sin(state.motion.spin) * (place[1] * force - lever * fy);
    if (p > 0) ++result.active;
    result.reaches_rim = result.reaches_rim || (p > 0 && system_.on_rim()[r]);
    if (force == 0) continue;
    result.force += force;
    result.attraction += attraction * system_.areas()[r];
    result.largest_pressure = std::max(result.largest_pressure, p - attraction);
    system_.interface().for_row(static_cast<int>(r), [&](int node, double weight) {
      const bool particle = system_.interface().nodes().site(node).body == 0;
      const auto& at = particle ? system_.row_points()[r] : system_.interface_points()[node];
      moment_x += force * weight * (at[1] + (particle ? shift.y : 0.0));
      moment_y += force * weight * (at[0] + (particle ? shift.x : 0.0));
    });
  }
  return {moment_x, moment_y};
}

void ContactSolver::add_shape(const ContactState& state, const std::vector<double>& gap,
                              ContactResultants& result) const {
  std::vector<std::array<double, 2>> points;
  for (const auto& p : system_.row_points()) points.push_back({p[0], p[1]});
  const ContactShape shape =
      contact_shape(system_.row_quads(), points, state.multiplier, gap, system_.reduced_modulus());
  result.area = shape.area, result.perimeter = shape.perimeter, result.spots = shape.spots;
  const PressureMoments moments = moments_of(system_, state.multiplier);
  result.centre = moments.centre, result.pressure_radius = moments.hertzian_radius;
}

void ContactSolver::add_reactions(const ContactState& state, ContactResultants& result) const {
  const auto& level = system_.level();
  Vector<double> force;
  level.initialise(force);
  system_.bodies().internal_force(state.displacement, force, nullptr);
  double driven = 0, fixed = 0;
  for (const auto& [dof, share] : level.driven_share()) driven -= share * force.begin()[dof];
  force.compress(dealii::VectorOperation::add);
  std::array<double, 2> lateral{};
  for (const int dof : level.fixed_z()) {
    fixed += force.local_element(dof);
    for (int c = 0; c < 2; ++c) lateral[c] += force.local_element(dof - 2 + c);
  }
  for (int c = 0; c < 2; ++c)
    result.lateral_reaction[c] = -dealii::Utilities::MPI::sum(lateral[c], level.communicator());
  result.reaction_driven = dealii::Utilities::MPI::sum(driven, level.communicator()) * upright();
  result.reaction_fixed = dealii::Utilities::MPI::sum(fixed, level.communicator());
}

}  // namespace asperity::fem
