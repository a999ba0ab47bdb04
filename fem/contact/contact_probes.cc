// Stiffnesses and compliances from single elastic solutions around a state.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "fem/contact/contact_solver.h"

namespace asperity::fem {
namespace {

/// Active contact nodes are tied by springs of so many times the penalty, as stiff as in a Newton step or
/// twice: the smoothers of multigrid are made for these.
constexpr double soft_tie = 1, stiff_tie = 2;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Stiffness of nodes that are tied rigidly: the springs' compliance is nearly in series with that of the
/// bodies and is extrapolated away. Springs so stiff that this needs no extrapolation leave conjugate
/// gradients without an answer on many meshes.
double rigidly_tied(const std::function<double(double tie)>& stiffness) {
  const double soft = stiffness(soft_tie), stiff = stiffness(stiff_tie);
  return 1 / (2 / stiff - 1 / soft);
}

/// Weights of Hertz' distribution over the rows, of sum 1: sqrt(1 - r^2 / radius^2) times the area.
std::vector<double> hertz_weights(const ContactSystem& system, double radius) {
  std::vector<double> weights(system.areas().size(), 0.0);
  double total = 0;
  for (std::size_t r = 0; r < weights.size(); ++r) {
    const auto& p = system.row_points()[r];
    const double s = 1 - (p[0] * p[0] + p[1] * p[1]) / (radius * radius);
    if (s > 0) total += weights[r] = system.areas()[r] * std::sqrt(s);
  }
  for (auto& w : weights) w /= total;
  return weights;
}

/// The mean over Hertz' pressure of what that pressure displaces, over the displacement of its centre: the
/// mean of r^2 is 2 a^2 / 5.
constexpr double mean_over_centre = 0.8;

}  // namespace

double ContactSolver::elastic_stiffness(const ContactState& state) {
  return rigidly_tied([&](double tie) { return tied_normal_stiffness(state, tie); });
}

double ContactSolver::tied_normal_stiffness(const ContactState& state, double tie) {
  const auto& level = system_.level();
  std::vector<RowStiffness> stiffness(state.multiplier.size());
  for (std::size_t r = 0; r < stiffness.size(); ++r)
    stiffness[r] = state.multiplier[r] > 0 ? tie * penalty_ * system_.areas()[r] : 0.0;
  if (!force_control()) {
    int iterations = 0;
    const std::vector<double> gaps =
        system_.interface().gaps(linear_advance(1.0, stiffness, 1e-6, &iterations).begin());
    if (iterations >= LinearSolver::most_iterations) return unknown;
    double force = 0;
    for (std::size_t r = 0; r < gaps.size(); ++r) force -= stiffness[r].normal * gaps[r];
    return force;
  }
  system_.linear().update(stiffness, nullptr, 0.0);
  Vector<double> unit, response;
  level.initialise(unit);
  level.initialise(response);
  if (level.owns_driven_dof()) unit.local_element(level.local_driven_dof()) = -1.0;
  if (system_.linear().solve(response, unit, 1e-6) >= LinearSolver::most_iterations) return unknown;
  const double own = level.owns_driven_dof() ? -response.local_element(level.local_driven_dof()) : 0.0;
  const double compliance = dealii::Utilities::MPI::sum(own, level.communicator());
  return upright() * upright() / compliance;
}

std::array<std::vector<double>, 2> ContactSolver::forces_of_tied_rows(const ContactState& state,
                                                                      const RigidMotion& motion, double tie) {
  const auto& level = system_.level();
  std::vector<RowStiffness> stiffness(state.multiplier.size());
  std::array<std::vector<double>, 2> slip, forces;
  for (auto& component : slip) component.assign(stiffness.size(), 0.0);
  for (std::size_t r = 0; r < stiffness.size(); ++r) {
    if (state.multiplier[r] <= 0) continue;
    stiffness[r].normal = stiffness[r].xx = stiffness[r].yy = tie * penalty_ * system_.areas()[r];
    const auto& p = system_.row_points()[r];
    slip[0][r] = motion.x - motion.spin * p[1];
    slip[1][r] = motion.y + motion.spin * p[0];
  }
  Vector<double> load, relaxed;
  level.initialise(load);
  level.initialise(relaxed);
  forces = slip;
  for (int c = 0; c < 2; ++c) {
    for (std::size_t r = 0; r < stiffness.size(); ++r) forces[c][r] *= -stiffness[r].xx;
    system_.interface().add_forces(forces[c], load.begin(), c);
  }
  level.condense(load.begin());
  load.compress(dealii::VectorOperation::add);
  system_.linear().update(stiffness, nullptr, 0.0);
  const bool is_solved = system_.linear().solve(relaxed, load, 1e-7) < LinearSolver::most_iterations;
  relaxed.update_ghost_values();
  for (int c = 0; c < 2; ++c) {
    const auto jumps = system_.interface().jumps(relaxed.begin(), c);
    for (std::size_t r = 0; r < stiffness.size(); ++r)
      forces[c][r] = is_solved ? -stiffness[r].xx * (slip[c][r] + jumps[r]) : unknown;
  }
  return forces;
}

double ContactSolver::lateral_stiffness(const ContactState& state) {
  RigidMotion unit;
  unit.x = 1;
  return rigidly_tied([&](double tie) {
    const auto forces = forces_of_tied_rows(state, unit, tie);
    double sum = 0;
    for (const double f : forces[0]) sum -= f;
    return sum;
  });
}

double ContactSolver::torsion_stiffness(const ContactState& state) {
  RigidMotion unit;
  unit.spin = 1;
  return rigidly_tied([&](double tie) {
    const auto forces = forces_of_tied_rows(state, unit, tie);
    double moment = 0;
    for (std::size_t r = 0; r < forces[0].size(); ++r) {
      const auto& p = system_.row_points()[r];
      moment -= p[0] * forces[1][r] - p[1] * forces[0][r];
    }
    return moment;
  });
}

void ContactSolver::say_if_unsolved(int iterations) const {
  if (iterations >= LinearSolver::most_iterations && log)
    log("the compliance of the finite bodies is not exact: the linear solver did not converge");
}

double ContactSolver::far_field_compliance(double radius, const std::array<J2Material, 2>* other) {
  const auto& level = system_.level();
  const std::vector<double> forces = hertz_weights(system_, radius);
  Vector<double> load, response;
  level.initialise(load);
  level.initialise(response);
  system_.interface().add_forces(forces, load.begin());
  // Under displacement control the driven plane's reaction is the opposite load.
  if (force_control() && level.owns_driven_dof()) load.begin()[level.local_driven_dof()] -= 1.0 / upright();
  level.condense(load.begin());
  load.compress(dealii::VectorOperation::add);
  const double spring =
      force_control() ? system_.reduced_modulus() * radius : 0.0;  // carries nothing: the loads balance
  const auto without_films = system_.linear_without_films(other);
  LinearSolver& linear = without_films ? *without_films : system_.linear();
  linear.update(std::vector<RowStiffness>(forces.size()), nullptr, spring);
  say_if_unsolved(linear.solve(response, load, 1e-7));
  const std::vector<double> opening = system_.interface().gaps(response.begin());
  double mean = 0;
  for (std::size_t r = 0; r < forces.size(); ++r) mean += forces[r] * opening[r];
  // Half-spaces under Hertz' pressure and unit force: delta = 3 / (4 E* a).
  const double modulus = ContactSystem::reduced_modulus(other ? *other : system_.options().materials);
  return mean - mean_over_centre * 3 / (4 * modulus * radius);
}

double ContactSolver::lateral_far_field_compliance(double radius, const std::array<J2Material, 2>* other) {
  const auto& level = system_.level();
  const std::vector<double> forces = hertz_weights(system_, radius);
  Vector<double> load, response;
  level.initialise(load);
  level.initialise(response);
  system_.interface().add_forces(forces, load.begin(), 0);
  level.condense(load.begin());
  load.compress(dealii::VectorOperation::add);
  const double spring = force_control() ? system_.reduced_modulus() * radius : 0.0;
  const auto without_films = system_.linear_without_films(other);
  LinearSolver& linear = without_films ? *without_films : system_.linear();
  linear.update(std::vector<RowStiffness>(forces.size()), nullptr, spring);
  say_if_unsolved(linear.solve(response, load, 1e-7));
  const std::vector<double> slip = system_.interface().jumps(response.begin(), 0);
  double mean = 0;
  for (std::size_t r = 0; r < forces.size(); ++r) mean += forces[r] * slip[r];
  // Half-spaces under shear of Hertz' distribution and unit force: 3 / (16 G* a) at the centre (Johnson 1985,
  // eq. 7.41).
  const double modulus = ContactSystem::reduced_shear_modulus(other ? *other : system_.options().materials);
  return mean - mean_over_centre * 3 / (16 * modulus * radius);
}

}  // namespace asperity::fem
