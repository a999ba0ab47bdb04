// The law of a sphere with a film on one of the bodies (half_space/filmed_sphere.h), tabled: without units it
// is one curve for each ratio of the film's modulus to that of its body, whatever film, sphere and load.
#pragma once

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "core/hertz.h"

namespace asperity {

class FilmedLaw {
 public:
  /// of_other: E/(1 - nu^2) of the body without a film [Pa].
  FilmedLaw(const ElasticBody& coated, double of_other);

  /// Of one film, whose Poisson ratio is that of its body.
  class Curve {
   public:
    /// Modulus of the pair that a homogeneous sphere would need for the same force at an approach d, over
    /// that of the bodies [-]. reach: d R/t^2 of the sphere's radius R and the film's thickness t [-].
    double modulus(double reach) const;

   private:
    friend class FilmedLaw;
    Curve(const std::vector<double>& changes, double of_film);
    double first_, last_, of_film_;
    boost::math::interpolators::cardinal_cubic_b_spline<double> spline_;
  };

  /// of_film: modulus of the pair with the film alone over that of the bodies [-], below of_other over it.
  Curve curve(double of_film) const;

 private:
  /// By contrasts of film and body, ln of the modulus over that of the films at each reach.
  const std::vector<double>& row(int contrast) const;

  ElasticBody coated_;
  double of_other_, bare_;
  mutable std::mutex mutex_;
  mutable std::map<int, std::vector<double>> rows_;
};

/// Of these bodies, the film on the first; made once.
std::shared_ptr<const FilmedLaw> filmed_law(const ElasticBody& coated, const ElasticBody& other);

}  // namespace asperity
