// The largest shear traction that a point of the interface transmits; beyond it the point slips (slip.h).
//
// A law is one class in one file of friction/, which also declares it: its entries of a case file, and how it
// is made from them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/law_declaration.h"
#include "fem/interface/slip.h"

namespace asperity::fem {

/// A point of the interface at the end of a step that is solved for. Steps last as long as the experiment's
/// speed and times say, and a second where it has none; a part of a divided step has its share.
struct InterfacePoint {
  double pressure = 0;   ///< of contact [Pa]
  double gap = 0;        ///< [m]
  PlaneVector slip{};    ///< since the last accepted state [m]; none where the point sticks or is open
  double slip_path = 0;  ///< accumulated slip since first touch, this step's included [m]
  double slip_rate = 0;  ///< this step's slip over its time [m/s]
  double time = 0, time_step = 0;  ///< [s]
};

/// The limit at one point.
struct ShearLimit {
  double stress;  ///< largest shear traction [Pa]
  double slope;   ///< its change with the pressure [-]
};

class FrictionLaw {
 public:
  virtual ~FrictionLaw() = default;
  /// Under a pressure of 0 or more; never falls as the pressure grows. history: internal variables of the
  /// point at the last accepted state. A step iterates the limit and the slip under it in turn
  /// (interface_tractions.h), which converges where the limit falls less per slip than the bodies' shear
  /// stress does; a limit that falls faster would let the contact jump.
  virtual ShearLimit limit(const InterfacePoint& point, const double* history) const = 0;
  /// Whether the limit grows with the rate of slip from none at rest, so that a point under shear always
  /// slips: limit and slip are then found together (rate_limited_shear.h).
  virtual bool resists_by_rate() const { return false; }
  /// Steepest fall of the limit per slip under a pressure [Pa], in [Pa/m]: contacts that are less stiff jump.
  virtual double steepest_fall(double /*pressure*/) const { return 0; }
  /// Names of a point's internal variables, which are zero at first, in the fields of the interface.
  virtual std::vector<std::string> history() const { return {}; }
  /// Makes the history that of a state that is accepted.
  virtual void remember(const InterfacePoint&, double* /*history*/) const {}

  /// Of a point that has not slipped, with internal variables of zero: for sizes of steps.
  /// pressure [Pa].
  virtual ShearLimit initial_limit(double pressure) const;
};

/// What a law of friction says of itself, and how it is made.
struct FrictionLawDeclaration : LawDeclaration {
  /// From the values of all of its parameters.
  std::unique_ptr<FrictionLaw> (*make)(const LawValues&);
};
/// All of them, by name.
const std::vector<FrictionLawDeclaration>& friction_laws();

/// The law whose parameters the case gives, all that it needs and none besides; null where it gives none:
/// frictionless. Throws InputError where no law, or more than one, takes just those.
std::unique_ptr<FrictionLaw> make_friction_law(const InterfaceInput& input);

}  // namespace asperity::fem
