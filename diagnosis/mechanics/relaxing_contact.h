// A contact of a body that relaxes, E*(t) = E* psi(t), psi(t) = 1 - sum_k g_k (1 - exp(-t/tau_k)). While the
// contact grows (Lee & Radok 1960)
//   f = int_0^t psi(t - s) dF(d(s)),  F: force of the elastic body, by Hertz 4/3 E* R^(1/2) d^(3/2),
// and where it shrinks it is as large as it was at t_1 (Ting 1966),
//   f = int_0^(t_1) psi(t - s) dF(d(s)),  int_(t_1)^t psi(t - s) dd(s) = 0.
// Pressed again, the first integral is over all that was: 1 % of the largest force off boundary elements
// where it had not opened, 10 % where it had, for the body has not recovered. Of a solved case F is the
// solution's: each displacement has one set of points that touch, whatever the modulus, so that this holds
// for rough contacts too. SI units.
#pragma once

#include <array>
#include <vector>

#include "core/relaxing_modulus.h"
#include "diagnosis/mechanics/normal_contact.h"

namespace asperity {

class RelaxingContact : public NormalContact {
 public:
  static constexpr std::size_t most_parts = 2;

  /// `modulus`: of one or two parts.
  RelaxingContact(const Hertz& law, const RelaxingModulus& modulus);
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<RelaxingContact>(*this); }
  void begin_step(double time_step) override;
  double solved_force(double d) const override { return elastic(d); }
  double force(double d) const override;
  void accept(double d) override;

 private:
  /// A number of each part.
  using OfParts = std::array<double, most_parts>;
  /// While the contact grew.
  struct Instant {
    double time = 0, depth = 0, force = 0;  ///< [s], [m], of the elastic body [N]
    OfParts depth_left{}, force_left{};     ///< integrals of exp(-(t - s)/tau) over depth and force
  };
  /// Of one part over the step: what is left at its end, and the mean of that over it [-].
  struct Decay {
    double left = 1, mean = 1;
  };

  double elastic(double d) const {
    return d > 0 ? 4.0 / 3 * law_.reduced_modulus * std::sqrt(law_.radius * d) * d : 0;
  }
  /// What is left of a strain for good, and with all of it, each part by its own number.
  double with_shares(double whole, const OfParts& of_parts) const;
  Instant state_as_it_grows(double d) const;
  OfParts shrinking_at(double d) const;
  double regained_at(double d) const;
  bool grows_at(double d) const { return regained_at(d) >= 0; }
  double shrunk_force(double d) const;
  /// Values at a time before, as they have decayed until the end of this step.
  OfParts decayed(const OfParts& values, double time) const;

  Hertz law_;
  std::size_t parts_;
  OfParts share_{}, time_constant_{};
  double for_good_ = 1;  ///< 1 - sum of g
  std::array<Decay, most_parts> decay_{};
  std::vector<Instant> growth_{1};  ///< from first touch to where it was largest
  double step_ = 0, time_ = 0;      ///< of this step, and at the last [s]
  OfParts shrinking_{};             ///< integrals of exp(-(t - s)/tau) over the depth since then [m]
  Instant last_;                    ///< of all of the history
};

}  // namespace asperity
