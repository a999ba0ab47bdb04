// A smooth sphere pressed on a smooth block, shifted and spun with friction: the driver of the tangential
// verification tests.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "fem/contact/contact_solver.h"
#include "fem/interface/friction/coulomb.h"

namespace asperity::test {

/// Of equal elastic constants unless told otherwise: pressure and shear do not couple (Dundurs' beta = 0).
struct FrictionalContactOptions {
  double youngs[2] = {71e9, 71e9}, poisson[2] = {0.17, 0.17};  ///< particle, substrate
  double radius = 8.5e-6, load = 100e-6, friction = 0.5;
  double cells_per_radius = 12;  ///< of Hertz' contact
  double layers = 4;             ///< of contact_mesh.h: how slowly cells grow away from the contact
  double slip_tolerance = 3e-3;
  bool tilted_normals = false;
  fem::AdhesionLaws adhesion;
  double region =
      1.25;  ///< half width of where surfaces can meet or attract, over the contact's larger semi-axis
  double path_length = 0;  ///< that the particle can roll or slide along x, centred on the origin [m]
  bool loaded = true;      ///< or left at first touch, for loads in steps
  double semi_axis_across =
      1;  ///< of the contact's ellipse along y, over that along x: 1, or larger for a flatter particle
  double yield_stress = std::numeric_limits<double>::infinity();  ///< of one body [Pa]
  int yielding_body = 1;                                          ///< 0: the particle, 1: the substrate
};

/// Hertz' ellipse whose semi-axis along y is `ratio` >= 1 times that along x (Johnson 1985, eqs. 4.26
/// to 4.28).
struct HertzEllipse {
  double curvature_across;  ///< along y, over that along x
  double shape;             ///< 1/(2R) = p0 / E* shape / a; pi/4 for a circle

  explicit HertzEllipse(double ratio) : curvature_across(1), shape(M_PI / 4) {
    if (ratio == 1) return;
    const double square = 1 - 1 / (ratio * ratio), e = std::sqrt(square);
    const double K = std::comp_ellint_1(e), E = std::comp_ellint_2(e), along = ratio * ratio * E - K;
    curvature_across = (K - E) / along;
    shape = along / (square * ratio * ratio);
  }
};

struct FrictionalContact {
  FrictionalContactOptions options;
  double reduced_modulus, contact_radius, friction_force;  ///< contact_radius: the semi-axis along x
  fem::ContactSystem system;
  fem::ContactSolver solver;
  fem::ContactState state;
  double lateral_far_field;
  int newton = 0, linear = 0;
  double friction_work = 0, adhesion_loss = 0;  ///< of the last step [J]
  double plastic_work = 0;                      ///< of all steps [J]

  explicit FrictionalContact(const FrictionalContactOptions& o)
      : options(o),
        reduced_modulus(1 / ((1 - o.poisson[0] * o.poisson[0]) / o.youngs[0] +
                             (1 - o.poisson[1] * o.poisson[1]) / o.youngs[1])),
        contact_radius(std::cbrt(3 * o.load * o.radius * HertzEllipse(o.semi_axis_across).shape /
                                 (M_PI * reduced_modulus * o.semi_axis_across))),
        friction_force(o.friction * o.load),
        system(MPI_COMM_WORLD, system_options(o, contact_radius)),
        solver(system, solver_options(o)),
        state(solver.first_touch()) {
    lateral_far_field = solver.lateral_far_field_compliance(0.9 * contact_radius);
    if (!o.loaded) return;
    solver.push_rigidly(state, 0.8 * contact_radius * contact_radius / o.radius);
    step({});
  }

  /// To another position of the particle's frame, at the same load or at `target` [N; m under displacement
  /// control]; made the accepted state.
  fem::ContactResultants step(const fem::RigidMotion& motion) { return step(motion, options.load); }
  fem::ContactResultants step(const fem::RigidMotion& motion, double target) {
    const auto before = state.displacement;
    const auto report = solver.solve(state, target, motion);
    EXPECT_TRUE(report.converged);
    newton = report.newton, linear = report.linear, friction_work = report.friction_work,
    adhesion_loss = report.adhesion_loss;
    plastic_work += system.bodies().accept(before, state.displacement).plastic_work;
    return solver.resultants(state);
  }
  fem::ContactResultants shift(double x) {
    fem::RigidMotion motion = state.motion;
    motion.x = x;
    return step(motion);
  }
  fem::ContactResultants spin(double angle) {
    fem::RigidMotion motion = state.motion;
    motion.spin = angle;
    return step(motion);
  }

  /// Rolls to an angle; the shift leads that of pure rolling by `ahead` [m].
  fem::ContactResultants roll(double angle, double ahead = 0) {
    fem::RigidMotion motion = state.motion;
    motion.roll = angle, motion.x = options.radius * angle + ahead;
    return step(motion);
  }

  static fem::ContactSystemOptions system_options(const FrictionalContactOptions& o, double a) {
    fem::ContactSystemOptions options;
    auto& s = options.mesh.sizes;
    s.radius = o.radius, s.block_half_width = 0.7 * o.radius;
    options.mesh.layers = o.layers;
    s.spacing_particle = a / o.cells_per_radius;
    s.spacing_substrate = 1.1 * s.spacing_particle;
    s.offset_substrate_x = 0.37 * s.spacing_particle, s.offset_substrate_y = 0.21 * s.spacing_particle;
    s.region_particle = o.region * a * o.semi_axis_across;
    s.region_substrate = s.region_particle + 3 * s.spacing_particle;
    s.reach_particle = s.reach_substrate = o.path_length / 2;
    for (int b = 0; b < 2; ++b) options.materials[b] = fem::J2Material::elastic(o.youngs[b], o.poisson[b]);
    if (o.semi_axis_across > 1) {
      const double flatter = (1 - HertzEllipse(o.semi_axis_across).curvature_across) / (2 * o.radius),
                   widest = 1.35 * s.region_particle;
      options.mesh.particle_height = [flatter](double, double y) { return flatter * y * y; };
      options.mesh.largest_height_particle = flatter * widest * widest;
    }
    options.materials[o.yielding_body].yield_stress = o.yield_stress;
    options.tilted_normals = o.tilted_normals;
    return options;
  }
  static fem::ContactSolverOptions solver_options(const FrictionalContactOptions& o) {
    fem::ContactSolverOptions options;
    options.slip_tolerance = o.slip_tolerance;
    options.adhesion = o.adhesion;
    if (o.friction > 0) options.friction = std::make_shared<fem::Coulomb>(o.friction);
    return options;
  }
};

}  // namespace asperity::test
