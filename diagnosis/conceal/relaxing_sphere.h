// A sphere on a half-space that relaxes as a standard linear solid, put as a row of springs and dampers that
// the profile x^2/R meets one by one (Popov & Hess 2015, Method of Dimensionality Reduction, ch. 7): each
// follows a differential equation, touched or free, and no integral over the history is taken. SI units.
#pragma once

#include <vector>

#include "diagnosis/conceal/normal_truth.h"

namespace asperity::hidden {

class RelaxingSphere : public NormalTruth {
 public:
  /// share: of the modulus that relaxes [-], with that time constant [s]; largest_approach [m]: beyond it
  /// nothing more is met.
  RelaxingSphere(Sphere sphere, double share, double time_constant, double largest_approach);
  double force(double approach, double time) const override { return moved(approach, time, nullptr); }
  void take(double approach, double time) override { moved(approach, time, &elements_); }

 private:
  /// What one place of the row is: its surface and what relaxes of its stress over the modulus.
  struct Element {
    double height = 0, relaxing = 0;  ///< [m]
  };
  /// Force [N] a time [s] later at an approach [m]; the row as it is then, where it is asked for.
  double moved(double approach, double time, std::vector<Element>* after) const;

  double modulus_, share_, time_constant_, spacing_;
  std::vector<double> profile_;  ///< x^2/R of each element [m]
  std::vector<Element> elements_;
};

}  // namespace asperity::hidden
