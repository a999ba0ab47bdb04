// Pressure and shear at each contact row from gaps and slips: the interface laws applied by an augmented
// Lagrangian.
//
// Attraction, if any, acts beside the contact pressure p at its own gap (adhesion_law.h).
//   p = max(0, lambda - eps g),   t = return_to_limit(lambda_t - eps s, limit(lambda, s)),   lambda <- p,
//   lambda_t <- t.
// The limit is that of the last multipliers and the slip under them (Tresca friction), so that the
// equilibrium for fixed multipliers still minimises a convex function; at the fixed point of the updates it
// is the law's. Source: Alart & Curnier (1991); Haslinger, Hlavacek & Necas (1996), Handbook of Numerical
// Analysis IV, ch. 3 (fixed point of Tresca problems).
#pragma once

#include <memory>

#include "fem/contact/contact_state.h"
#include "fem/contact/contact_system.h"
#include "fem/interface/adhesion_law.h"
#include "fem/interface/friction_law.h"
#include "fem/interface/slip.h"

namespace asperity::fem {

/// Stiffness of rows that slip. Tangent: the derivative of their traction, zero along the slip direction (the
/// consistent tangent). Secant: traction over trial traction, which bounds their convex potential from above,
/// so that a whole step always lowers the energy (Weiszfeld 1937; Chan & Mulet 1999, SIAM J. Numer. Anal. 36,
/// 354), but convergence is slow where many rows slip far.
enum class SlipStiffness { tangent, secant };

class InterfaceTractions {
 public:
  /// friction: null for none. penalty: eps [Pa/m].
  InterfaceTractions(const ContactSystem& system, const FrictionLaw* friction, const AdhesionLaws& adhesion,
                     double penalty);

  /// To be called at the last accepted state, with the interfaces coupled for the step to `motion`: slip is
  /// counted from there. A row that is open slips only from where it comes into contact, which follows from
  /// its gaps at the accepted displacements before and after the coupling; where the load grows, a row that
  /// the motion alone does not bring into contact slips from the beginning. time_step: from the accepted
  /// state's time.
  /// time_step [s], gaps [m].
  void begin_step(const ContactState& accepted, const RigidMotion& motion,
                  const std::vector<double>& gaps_before, const std::vector<double>& gaps, bool load_grows,
                  double time_step);
  /// Shear limits from the multipliers of `state` and the evaluated slip.
  void update_limits(const ContactState& state);
  /// Rows with friction that stick beyond their limit until release():
  /// those whose motion does not carry their slip on, or those that stick now. For first guesses.
  void hold_unless_slipping_on(const ContactState& state);
  void hold_sticking();
  void release() { held_.clear(); }
  /// Evaluates all rows at a state with the given gaps [m].
  void evaluate(const ContactState& state, const std::vector<double>& gaps);
  /// Moves the multipliers to the evaluated tractions, by a share of the way [-]; `change` is to be asked
  /// before.
  void update_multipliers(ContactState& state, double share = 1) const;

  /// How far an update would go.
  struct Change {
    double pressure, shear;  ///< 1-norms of the changes that an update would make, relative to their totals
  };
  /// What an update would change of the state's multipliers.
  Change change(const ContactState& state) const;

  const std::vector<double>& pressure() const { return pressure_; }
  bool has_adhesion() const { return adhesion_.closing != nullptr; }
  /// Attraction of a row at a gap [m].
  AdhesionLaw::Attraction attraction(const ContactState& state, int row, double gap) const;
  /// Bonds of the evaluated rows at the end of a step: those in contact are formed, those out of range are
  /// broken. The multipliers balance the change of attraction. Returns the energy that is lost
  /// [J].
  double update_bonds(ContactState& state, const std::vector<double>& gaps) const;
  /// Makes time and history of `state`, which begin_step() was given, those of the evaluated rows at the end
  /// of a step.
  void update_history(ContactState& state) const;
  /// Energy of the attraction at these gaps [J].
  double adhesion_energy(const ContactState& state, const std::vector<double>& gaps) const;
  /// y += forces of the evaluated tractions on all nodes.
  void add_forces(double* y) const;
  /// Sum of pressure less attraction over the rows [N].
  double total_force() const;
  /// Load that an accepted state carries: its pressures less the attraction at its gaps [N].
  double carried_load(const ContactState& accepted, const std::vector<double>& gaps) const;
  /// Sum of |shear| over that of the pressures.
  /// A ratio [-].
  double shear_share() const;
  bool any_closed() const;
  int closed() const;
  /// Rows that stick; those without friction slip.
  int sticking() const;
  /// Stiffness of the rows at the evaluated state; without what attraction takes from it if `convex`.
  std::vector<RowStiffness> stiffness(bool convex, SlipStiffness slip) const;
  /// Work of the shear on the slip since the last accepted state, at the mean of both states' limits [J].
  /// Slip is the mean of what the couplings before and after the step see of the same displacements. Both
  /// make the balance of energy one of second order in the step.
  double friction_work(const ContactState& state) const;
  bool has_friction() const { return friction_ != nullptr; }
  /// Numbers that a state keeps of each row for friction.
  std::size_t history_size() const { return friction_ ? kept_of_all_laws + friction_->history().size() : 0; }
  /// Internal variables of the friction law that a state stores for a row; index: in FrictionLaw::history().
  /// In the unit of the variable.
  double remembered(const ContactState& state, std::size_t row, std::size_t index) const {
    return state.friction_history[row * history_size_ + kept_of_all_laws + index];
  }

 private:
  static constexpr std::size_t kept_of_all_laws = 2;  ///< slip path, shear limit
  /// A row under a pressure after the evaluated slip.
  InterfacePoint point(const ContactState& state, std::size_t row, double pressure) const;
  double shear_limit(const ContactState& state, std::size_t row, double pressure) const;
  bool resists_by_rate() const { return friction_->resists_by_rate() && time_step_ > 0; }
  /// Of a row under a pressure at the slip that is evaluated.
  Shear shear_at(const ContactState& state, std::size_t row, double pressure) const;
  /// Place of each row's node along x and y relative to the substrate's surface as it is displaced, but for a
  /// constant.
  std::array<std::vector<double>, 2> slips(const InterfaceOperator& interface,
                                           const ContactState& state) const;

  const ContactSystem& system_;
  const FrictionLaw* friction_;
  AdhesionLaws adhesion_;
  double penalty_;
  std::vector<char> held_;
  std::vector<double> pressure_, gap_, limit_, limit_before_;
  std::vector<AdhesionLaw::Attraction> attraction_;
  std::array<std::vector<double>, 2> slip_origin_, slip_, start_, start_before_, shear_before_;
  std::vector<Shear> shear_;
  std::size_t history_size_;
  double time_ = 0, time_step_ = 0;
};

}  // namespace asperity::fem
