// Equilibrium of two elastic-plastic bodies in unilateral, frictional contact at a given load or approach.
//
// Augmented Lagrangian (Alart & Curnier 1991; Puso & Laursen 2004 for mortar), see interface_tractions.h. For
// fixed multipliers the equilibrium minimises a convex function (associated flow, hardening >= 0, Tresca
// friction), which the semismooth Newton iteration with line search finds from any start. eps scales with E*
// / spacing.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "fem/contact/contact_state.h"
#include "fem/contact/contact_system.h"
#include "fem/contact/interface_tractions.h"
#include "fem/contact/steady_prediction.h"

namespace asperity::fem {

/// Laws of the interface, and tolerances of the iterations.
struct ContactSolverOptions {
  /// Sum of unbalanced nodal forces relative to the contact force; met, too, where it is no more than what
  /// rounding of the displacements leaves (light loads on a body far stiffer than the other, which moves as a
  /// whole).
  double residual_tolerance = 1e-6;
  double penetration_tolerance =
      3e-4;                      ///< change of the pressures by a multiplier update, relative, in the 1-norm
  double slip_tolerance = 1e-3;  ///< the same of the shear tractions
  double penalty_factor = 4.0;   ///< eps = factor E* / spacing
  int largest_newton = 60, largest_updates = 40;
  bool cautious = false;  ///< whether each step is solved as one is where the quick iteration failed
  std::shared_ptr<const FrictionLaw> friction;  ///< null: none
  AdhesionLaws adhesion;                        ///< empty: none
  /// Approach at first touch [m], where it is known from another mesh of the same bodies.
  std::optional<double> touch_offset;
};

class ContactSolver {
 public:
  ContactSolver(ContactSystem& system, const ContactSolverOptions& options);

  /// The state before first touch: the particle's lowest point meets the substrate.
  ContactState first_touch() const;

  /// Finds the equilibrium at `target` (normal force [N] under force control, approach [m] under displacement
  /// control), and at `motion`, starting from the accepted `state`, which it replaces: slip is counted from
  /// there. Does not touch the bodies' history. time_step: that this takes (InterfacePoint). Where the quick
  /// iteration finds none, the cautious one starts again. Throws StepFailure where a step has to be smaller.
  SolveReport solve(ContactState& state, double target, const RigidMotion& motion, double time_step = 1);
  SolveReport solve(ContactState& state, double target) { return solve(state, target, state.motion); }

  /// Moves the particle rigidly by `approach` more, a first guess for larger loads.
  /// approach [m].
  void push_rigidly(ContactState& state, double approach) const;

  /// Forces, areas and spots of a state.
  ContactResultants resultants(const ContactState& state) const;
  /// Gap of each row at a state [m].
  std::vector<double> gaps(const ContactState& state) const;
  /// Stiffnesses of the bodies without further yielding and slip, contact area as it is; NaN where the linear
  /// solver does not converge.
  double elastic_stiffness(const ContactState& state);  ///< dF/d(approach) [N/m]
  double lateral_stiffness(const ContactState& state);  ///< dQ/d(shift along x) [N/m]
  double torsion_stiffness(const ContactState& state);  ///< dM/d(spin) [N m/rad]
  /// Approach [m/N] that the finite bodies add to (or take from) that of half-spaces, from one elastic
  /// solution under Hertz' pressure of `radius` (Johnson 1985 eq. 3.39 for the half-spaces); `other`: with
  /// the elasticity of these bodies.
  double far_field_compliance(double radius, const std::array<J2Material, 2>* other = nullptr);
  /// The same for the shift under a lateral force (Johnson 1985 eq. 7.41 under Hertz' distribution of shear).
  /// radius [m]; the result in [m/N].
  double lateral_far_field_compliance(double radius, const std::array<J2Material, 2>* other = nullptr);

  bool has_friction() const { return tractions_.has_friction(); }
  bool has_adhesion() const { return tractions_.has_adhesion(); }
  const FrictionLaw* friction() const { return options_.friction.get(); }  ///< null: none
  SteadyPrediction& prediction() { return prediction_; }
  const SteadyPrediction& prediction() const { return prediction_; }
  const InterfaceTractions& tractions() const { return tractions_; }
  /// Approach at which the undeformed surfaces touch [m].
  double touch_offset() const { return touch_offset_; }
  std::function<void(const std::string&)> log;

 private:
  double evaluate(const ContactState& state, double target, Vector<double>& residual, TangentField* tangent);
  /// Sum of nodal forces that displacements rounded to double precision leave unbalanced [N].
  double force_of_rounding(const Vector<double>& displacement) const;
  /// How a step is solved. Quick: from the path so far, and multipliers follow as soon as the unbalanced
  /// force is less than their change. Cautious: from the accepted state, each update after a close balance.
  enum class Pace { quick, cautious };
  /// What the parts of one solve hand on.
  struct Iteration;
  /// solve() at a pace, without another try.
  SolveReport solve_at(Pace pace, ContactState& state, double target, const RigidMotion& motion,
                       double time_step);
  /// Moves the state on by a share of what the last step changed.
  void predict(Iteration& at, double share);
  /// The unbalanced force, relative, at which the multipliers are updated next, or the step is solved.
  double goal(const Iteration& at) const;
  /// Parts of solve(). Couples the interfaces at `motion`; the first guess.
  void begin_step(Iteration& at, const RigidMotion& motion, double time_step);
  /// Newton steps for fixed multipliers.
  void balance(Iteration& at);
  /// goal: of the unbalanced force, relative.
  void newton_step(Iteration& at, double goal);
  /// Cut steps show that nodes change from slip to stick. The consistent tangent has no stiffness along the
  /// slip direction, so its steps overshoot that change; the secant stiffness, an upper bound of the convex
  /// energy, does not. The two alternate whenever one of them makes little progress. step: of the line
  /// search; errors: relative.
  void choose_slip_stiffness(double step, double error_before, double error);
  /// How far another update of the multipliers would go.
  void measure_change(Iteration& at);
  /// A change of the multipliers as a force over the pressures' total.
  double force_of(const InterfaceTractions::Change& change) const;
  void update_multipliers(Iteration& at);
  /// Makes the last tractions those of the state; works of the interface.
  void finish(Iteration& at);
  /// A first guess: one step of elastic bodies in which the rows that tractions_ holds stick.
  void step_with_held_rows(Iteration& at);
  /// Parts of resultants(). Of the rows: forces, moments, largest pressure, what sticks; returns the moments
  /// about x and y of the forces on both bodies, which cancel but for error [N m].
  std::array<double, 2> add_rows(const ContactState& state, const std::vector<double>& gap,
                                 ContactResultants& result) const;
  /// Area, edge, spots and centre.
  void add_shape(const ContactState& state, const std::vector<double>& gap, ContactResultants& result) const;
  /// Reactions of the driven and the fixed plane. Collective.
  void add_reactions(const ContactState& state, ContactResultants& result) const;
  void say_if_unsolved(int iterations) const;
  /// dF/d(approach) [N/m] with the closed rows tied by springs of `tie` times the penalty; NaN where the
  /// linear solver does not converge.
  double tied_normal_stiffness(const ContactState& state, double tie);
  /// Forces of the closed rows, tied likewise, on the particle when its frame moves by `motion` [N], by
  /// component; NaN as above.
  std::array<std::vector<double>, 2> forces_of_tied_rows(const ContactState& state, const RigidMotion& motion,
                                                         double tie);
  /// Mean elastic displacement of the surfaces relative to each other, weighted with the pressure; none
  /// without tilted normals.
  SurfaceDisplacement mean_displacement(const ContactState& state) const;
  /// Rotates the driven plane's direction of motion by the angle rolled: it moves along the particle's own
  /// axes.
  double upright() const { return std::cos(system_.coupling().frames.roll); }
  bool force_control() const { return system_.options().control == Control::force; }
  /// Sets what follows from the free entries, and the driven plane under displacement control.
  void complete(Vector<double>& displacement, double approach) const;
  /// Displacement of elastic bodies when the driven plane advances and the contacts of `stiffness` [N/m] stay
  /// closed.
  Vector<double> linear_advance(double approach, const std::vector<RowStiffness>& stiffness, double accuracy,
                                int* iterations);
  /// First guess at another approach (displacement control).
  void advance_to(ContactState& state, double approach, SolveReport& report);
  void read_approach(ContactState& state) const;
  /// Newton's direction for the evaluated tractions, of descent in any case. Returns the iterations.
  int newton_direction(const TangentField* tangent, double spring, double accuracy,
                       const Vector<double>& residual, Vector<double>& direction);

  ContactSystem& system_;
  ContactSolverOptions options_;
  TangentField tangent_;
  SlipStiffness slip_stiffness_ = SlipStiffness::tangent;
  int convex_steps_left_ = 0;  ///< in which Newton's direction leaves the softening of attraction out
  double penalty_;             ///< eps [Pa/m]
  InterfaceTractions tractions_;
  SteadyPrediction prediction_;
  Vector<float> elastic_diagonal_;  ///< of both bodies' stiffness [N/m]
  double rounding_ = 0;             ///< force of rounding over the contact force, as evaluated last
  double touch_offset_;             ///< rigid shift that brings the bodies to first touch [m]
};

}  // namespace asperity::fem
