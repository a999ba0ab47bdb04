// Equilibrium of two elastic-plastic bodies in unilateral contact at a given load or approach.
//
// Augmented Lagrangian (Alart & Curnier 1991; Puso & Laursen 2004 for mortar): at each contact node
//   p = max(0, lambda - eps g),  lambda <- p  until the penetration is negligible.
// For fixed lambda the equilibrium minimises a convex function (associated flow, hardening >= 0), which the
// semismooth Newton iteration with line search finds from any start. eps scales with E* / spacing.
#pragma once

#include <functional>
#include <string>

#include "fem/contact/contact_system.h"

namespace asperity::fem {

struct ContactSolverOptions {
  double residual_tolerance = 1e-6;     ///< sum of unbalanced nodal forces relative to the contact force
  double penetration_tolerance = 1e-3;  ///< change of the pressures by a multiplier update, relative, in the 1-norm
  double penalty_factor = 8.0;          ///< eps = factor E* / spacing
  int largest_newton = 60, largest_updates = 40;
};

/// One state of the contact; history lives in ContactSystem::bodies().
struct ContactState {
  Vector<double> displacement;
  std::vector<double> multiplier;  ///< lambda of each row [Pa], also the pressure of an accepted state
  double approach = 0;             ///< displacement of the driven plane towards the substrate [m], from first touch
};

struct SolveReport {
  int newton = 0, updates = 0, linear = 0;  ///< iterations
  double residual = 0, penetration = 0;     ///< reached, relative
  bool converged = false;
};

/// Resultants of an equilibrium.
struct ContactResultants {
  double force = 0;           ///< from tractions [N]
  double reaction_driven = 0; ///< from reactions of the driven plane [N]
  double reaction_fixed = 0;  ///< from reactions of the fixed plane [N]
  double moment_error = 0;    ///< |moment of tractions about the axes - moment of the same forces on the substrate| / (force spacing)
  double area = 0;            ///< real contact area [m^2]
  double largest_pressure = 0;
  int active = 0;
  bool reaches_rim = false;
};

class ContactSolver {
 public:
  ContactSolver(ContactSystem& system, const ContactSolverOptions& options);

  /// The state before first touch: the particle's lowest point meets the substrate.
  ContactState first_touch() const;

  /// Finds the equilibrium at `target` (normal force [N] under force control, approach [m] under displacement control),
  /// starting from `state`, which it replaces. Does not touch the history.
  SolveReport solve(ContactState& state, double target);

  /// Moves the particle rigidly by `approach` more, a first guess for larger loads.
  void push_rigidly(ContactState& state, double approach) const;

  ContactResultants resultants(const ContactState& state) const;
  /// Gap of each row at a state [m].
  std::vector<double> gaps(const ContactState& state) const;
  /// Incremental stiffness dF/d(approach) [N/m] of the bodies without further yielding, contact area as it is.
  double elastic_stiffness(const ContactState& state);
  /// Approach [m/N] that the finite bodies add to (or take from) that of half-spaces, from one elastic solution under
  /// Hertz' pressure of `radius` (Johnson 1985 eq. 3.39 for the half-spaces).
  double far_field_compliance(double radius);

  double touch_offset() const { return touch_offset_; }
  std::function<void(const std::string&)> log;

 private:
  std::vector<double> pressures(const ContactState& state, const std::vector<double>& gaps) const;
  double evaluate(const ContactState& state, double target, Vector<double>& residual, TangentField* tangent, std::vector<double>& p);
  bool force_control() const { return system_.options().control == Control::force; }
  /// Sets what follows from the free entries, and the driven plane under displacement control.
  void complete(Vector<double>& displacement, double approach) const;
  /// Displacement of elastic bodies when the driven plane advances and the contacts of `stiffness` [N/m] stay closed.
  Vector<double> linear_advance(double approach, const std::vector<double>& stiffness, double accuracy, int* iterations);
  /// First guess at another approach (displacement control).
  void advance_to(ContactState& state, double approach, SolveReport& report);
  void read_approach(ContactState& state) const;

  ContactSystem& system_;
  ContactSolverOptions options_;
  TangentField tangent_;
  double penalty_;       ///< eps [Pa/m]
  double touch_offset_;  ///< rigid shift that brings the bodies to first touch [m]
};

}  // namespace asperity::fem
