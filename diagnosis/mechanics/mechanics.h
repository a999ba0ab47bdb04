// The mechanical model that a recording is compared with, as parts that effects replace, add in series, or
// add on top:
//
//   normal   d = d_contact + sum of series(f) + sum of delayed parts(d_contact) + sum of shifts(sample),
//              f = f_contact(d_contact) + sum of beside(d_contact),
//              f_n = reading(f + sum of additions(sample, d))
//   lateral  x = x_contact + C f_l,contact,   |f_l,contact| <= limit,   f_l = f_l,contact + sum of
//   additions(sample) limit    coefficient x (f_n + offset), each changed by the list of changes
//
// Copying it copies the histories: a run of the recording begins with a copy. SI units.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "core/length_scale.h"
#include "diagnosis/mechanics/normal_contact.h"
#include "diagnosis/recording/experiment.h"

namespace asperity {

/// What a friction law may depend on at one instant.
struct SlipState {
  const Sample* sample = nullptr;
  double normal_force = 0;    ///< f_n [N]
  double contact_radius = 0;  ///< a by Hertz, in sliding under load and attraction [m]
  double slip = 0;            ///< path slipped since the last reversal [m]
  double path = 0;  ///< recorded path since sliding began after the last reversal, elastic parts included [m]
  double speed = 0;      ///< [m/s]
  double time_step = 0;  ///< [s]
};

/// mu -> changed mu. May keep a history; called once for every sample, in order.
using CoefficientChange = std::function<double(double coefficient, const SlipState&)>;
/// Limit of the lateral force [N] -> changed limit.
using LimitChange = std::function<double(double limit, const SlipState&)>;

/// Delayed compliance: tau dq/dt = share d_contact - q (Kelvin & Voigt), d_contact straight between samples.
struct DelayedPart {
  double share = 0, time_constant = 1;
  double delayed = 0, last = 0;  ///< q and d_contact at the last sample [m]

  /// q at the end of a step.
  double after(double displacement, double time_step) const {
    const double t = time_step / time_constant, now = std::max(0.0, displacement), left = std::exp(-t);
    const double mean = t > 1e-9 ? (1 - left) / t : 1;  // of the exponential over the step
    return delayed * left + share * (now * (1 - mean) + last * (mean - left));
  }
  void accept(double displacement, double time_step) {
    delayed = after(displacement, time_step);
    last = std::max(0.0, displacement);
  }
};

/// What finite elements say beyond the reduced law: under normal load a displacement of the contact at its
/// force, in sliding and rolling factors on resistance and lateral stiffness.
class BranchCorrection {
 public:
  virtual ~BranchCorrection() = default;
  /// [m]
  virtual double displacement(const Sample&, double) const { return 0; }
  /// On the limit of the lateral force, and on the lateral stiffness, at a sample's normal force and surface
  /// [-].
  virtual double limit_factor(const Sample&) const { return 1; }
  virtual double stiffness_factor(const Sample&) const { return 1; }
  /// Force beside the limit that the factor gives [N].
  virtual double limit_offset(const Sample&) const { return 0; }
  /// The contact itself, where what finite elements say is a force at its displacement, as of a contact that
  /// attracts; null: it stays the reduced law.
  virtual std::shared_ptr<const NormalContact> contact_for(const NormalContact&) const { return nullptr; }
  /// Standard deviation of the finite elements' own answer, of mesh and load steps, at any force: of the
  /// displacement under normal load [m], of resistance along the surface as a part of it [-].
  virtual double error() const = 0;
  /// The same of the resistance that was solved, at a sample's normal force and surface [N]: what stands
  /// beside the solution adds nothing to it.
  virtual double limit_error(const Sample&) const { return 0; }
  /// The same of the lateral stiffness, as a part of it [-].
  virtual double stiffness_error() const { return 0; }
  /// The same of the attraction, as a part of it [-].
  virtual double attraction_error() const { return 0; }
  /// This correction with the attraction off by that error; closing and opening one by one where their works
  /// differ. Empty: nothing attracts.
  virtual std::vector<std::shared_ptr<const BranchCorrection>> with_attraction_off() const { return {}; }
  /// What a displacement may be off by because the experiment's surface is another realisation [m], over the
  /// force [N]: each times a factor of unit variance of its own. Empty: nothing.
  virtual const std::vector<std::function<double(double force)>>& surface_errors() const {
    static const std::vector<std::function<double(double)>> none;
    return none;
  }
  /// Their sum with these factors [-]: a displacement [m] over the force [N].
  virtual std::function<double(double force)> on_surface(const std::vector<double>& factors) const {
    return [this, factors](double force) {
      double d = 0;
      for (std::size_t k = 0; k < factors.size(); ++k) d += factors[k] * surface_errors()[k](force);
      return d;
    };
  }
};

/// Under normal load.
struct NormalMechanics {
  std::shared_ptr<const NormalContact> contact;  ///< without history; cloned for a run
  /// Force [N] that acts beside the contact, over its displacement [m].
  std::vector<std::function<double(double displacement)>> beside;
  std::vector<std::function<double(double force)>> series;   ///< displacement [m] of what lies in series
  std::vector<DelayedPart> delays;                           ///< displacement [m] that follows the contact's
  std::vector<std::function<double(const Sample&)>> shifts;  ///< displacement [m]; may keep a history
  std::vector<std::function<double(const Sample&, double displacement)>> additions;  ///< force [N]
  /// Force [N] to what the sensor reads of it [N], never falling.
  std::vector<std::function<double(double force)>> readings;
  std::shared_ptr<const BranchCorrection> correction;  ///< in series with the contact; null: none
};

/// Under lateral load.
struct LateralMechanics {
  enum class Stick { spring, strips } stick = Stick::spring;
  double compliance = 0;   ///< C in series [m/N]
  double coefficient = 0;  ///< mu of sliding, rolling, or torsion in mode torsion
  double offset = 0;       ///< h added to the normal force [N]
  std::vector<std::function<double(const Sample&)>> offsets;  ///< further h, of the sample [N]
  double torsion_coefficient = 0;                             ///< mu_to at the slopes of a rail
  LengthScale length = LengthScale::particle_radius;          ///< of rolling and torsion
  bool follows_area =
      false;  ///< sliding: the limit is coefficient x pi a^2, coefficient a shear strength [Pa]
  std::vector<CoefficientChange> coefficient_changes;
  std::vector<LimitChange> limit_changes;
  /// What else resists, beside the contact and its correction [N].
  std::vector<std::function<double(const SlipState&)>> beside;
  std::vector<std::function<double(const Sample&)>> additions;  ///< to the recorded force [N]
  std::shared_ptr<const BranchCorrection> correction;           ///< of limit and stiffness; null: none
};

struct Mechanics {
  Experiment experiment;
  Hertz geometry;  ///< E* and R of the normal contact
  NormalMechanics normal;
  LateralMechanics lateral;
};

/// h added to the normal force at a sample [N].
inline double offset_at(const LateralMechanics& lateral, const Sample& sample) {
  double sum = lateral.offset;
  for (const auto& part : lateral.offsets) sum += part(sample);
  return sum;
}

/// The recording's own simulation before any effect: its laws and the values of its coefficients.
Mechanics baseline_mechanics(const Experiment& experiment, const SimulationChoice& choice);

/// Simulated response of every sample, driven by the recorded control channels.
std::vector<double> simulate(const Mechanics& mechanics, const Samples& samples);

}  // namespace asperity
