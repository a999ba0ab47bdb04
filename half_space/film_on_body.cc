#include "half_space/film_on_body.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/shear_moduli.h"

namespace asperity::half_space {
namespace {

double modulus_of_films(double modulus, const std::vector<FilmOnBody>& films) {
  if (!(modulus > 0) || !std::isfinite(modulus))
    throw InputError("a half-space needs a finite modulus above 0");
  double compliance = 1 / modulus;
  for (const FilmOnBody& film : films) {
    if (!(film.thickness > 0)) throw InputError("a film needs a thickness above 0");
    compliance += 1 / modulus_alone(film.film) - 1 / modulus_alone(film.body);
  }
  return 1 / compliance;
}

/// Over which waves change from those of the bodies to those of the films [m]. A film that is stiffer than
/// its body by a factor holds that body's surface together up to waves that are as much longer.
struct Lengths {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
};
Lengths lengths_of(const std::vector<FilmOnBody>& films) {
  Lengths l;
  for (const FilmOnBody& film : films) {
    constexpr double least = 0.2, most = 12, stiffest = 300;
    const double contrast = std::clamp(modulus_alone(film.film) / modulus_alone(film.body), 1.0, stiffest);
    l.shortest = std::min(l.shortest, least * film.thickness);
    l.longest = std::max(l.longest, most * contrast * film.thickness);
  }
  return l;
}

}  // namespace

double FilmOnBody::compliance(double q) const {
  const double shear = shear_modulus(film), nu = film.poisson_ratio, ratio = shear / shear_modulus(body);
  const double below = (1 - body.poisson_ratio) / shear_modulus(body);
  // Towards longer waves it no longer changes, and is a small difference of large numbers.
  constexpr double long_wave = 1e-5;
  const double qt = std::max(q * thickness, long_wave), e = std::exp(-2 * qt);
  const double lambda = 1 - 4 * (1 - nu) / (1 + ratio * (3 - 4 * body.poisson_ratio)),
               k = (ratio - 1) / (ratio + 3 - 4 * nu);
  const double both = (1 - nu) / shear * (1 + 4 * qt * k * e - lambda * k * e * e) /
                      (1 - (lambda + k + 4 * k * qt * qt) * e + lambda * k * e * e);
  return (both - below) / (qt / thickness);
}

FilmedBodies::FilmedBodies(double modulus, const std::vector<FilmOnBody>& films)
    : of_films(modulus_of_films(modulus, films)) {
  if (films.empty()) return;
  const Lengths lengths = lengths_of(films);
  constexpr double terms_per_e_fold = 4.4;
  const int count = static_cast<int>(terms_per_e_fold * std::log(lengths.longest / lengths.shortest)),
            waves = 12 * count;
  const double longest_wave = 4e-4 / lengths.longest, shortest_wave = 8 / lengths.shortest;
  for (int j = 0; j < count; ++j)
    terms.push_back({lengths.shortest * std::pow(lengths.longest / lengths.shortest, j / (count - 1.0)), 0});
  Eigen::MatrixXd matrix(waves, count);
  Eigen::VectorXd change(waves);
  for (int i = 0; i < waves; ++i) {
    const double q = longest_wave * std::pow(shortest_wave / longest_wave, i / (waves - 1.0));
    double compliance = 1 / modulus;
    for (const FilmOnBody& film : films) compliance += q / 2 * film.compliance(q);
    // To the same part of the whole displacement for all waves.
    const double whole = of_films * compliance;
    change[i] = (whole - 1) / whole;
    for (int j = 0; j < count; ++j) matrix(i, j) = std::exp(-terms[j].reach * q) / whole;
  }
  const Eigen::VectorXd shares = matrix.colPivHouseholderQr().solve(change);
  for (int j = 0; j < count; ++j) terms[j].share = shares[j];
}

}  // namespace asperity::half_space
