#include "diagnosis/conceal/relaxing_sphere.h"

#include <cmath>

namespace asperity::hidden {

RelaxingSphere::RelaxingSphere(Sphere sphere, double share, double time_constant, double largest_approach)
    : modulus_(sphere.reduced_modulus), share_(share), time_constant_(time_constant) {
  constexpr int count = 800;
  spacing_ = std::sqrt(sphere.radius * largest_approach) / count;
  for (int i = 0; i < count; ++i) profile_.push_back(std::pow((i + 0.5) * spacing_, 2) / sphere.radius);
  elements_.resize(count);
}

/// Touched, s' = u' - s/tau beside the stress E* [(1 - g) u + g s]; free of stress, s' = -(1 - g) s/tau.
double RelaxingSphere::moved(double approach, double time, std::vector<Element>* after) const {
  const double steps = time / time_constant_, decay = std::exp(-steps),
               of_change = steps > 0 ? (1 - decay) / steps : 1, free_decay = std::exp(-(1 - share_) * steps);
  double force = 0;
  for (std::size_t i = 0; i < profile_.size(); ++i) {
    const Element& before = elements_[i];
    const double height = approach - profile_[i];
    const double relaxing = before.relaxing * decay + (height - before.height) * of_change,
                 stress = (1 - share_) * height + share_ * relaxing;
    if (stress > 0) {
      force += 2 * spacing_ * modulus_ * stress;
      if (after) (*after)[i] = {height, relaxing};
    } else if (after) {
      const double left = before.relaxing * free_decay;
      (*after)[i] = {-share_ * left / (1 - share_), left};
    }
  }
  return force;
}

}  // namespace asperity::hidden
