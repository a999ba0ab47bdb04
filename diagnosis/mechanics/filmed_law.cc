#include "diagnosis/mechanics/filmed_law.h"

#include <array>
#include <boost/math/interpolators/makima.hpp>
#include <cmath>
#include <tuple>

#include "half_space/filmed_sphere.h"

namespace asperity {
namespace {

constexpr double contrast_step = 0.35;  // of ln E_film/E_body
/// Of ln(d R/t^2): contacts from a fiftieth of the thickness to a thousand of it wide.
constexpr double first_reach = -7.8, reach_step = 0.5;
constexpr int reaches = 44;

}  // namespace

FilmedLaw::FilmedLaw(const ElasticBody& coated, double of_other)
    : coated_(coated), of_other_(of_other), bare_(1 / (1 / modulus_alone(coated) + 1 / of_other)) {}

const std::vector<double>& FilmedLaw::row(int contrast) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<double>& row = rows_[contrast];
  if (!row.empty()) return row;
  ElasticBody film = coated_;
  film.youngs_modulus *= std::exp(contrast_step * contrast);
  const half_space::FilmedSphere sphere(bare_, {{film, coated_, 1}});
  constexpr double first_radius = -6, radius_step = 0.25;  // of ln a/t
  constexpr int radii = 54;
  std::vector<double> reach, change;
  for (int i = 0; i < radii; ++i) {
    const auto contact = sphere.at(std::exp(first_radius + radius_step * i), 1);
    reach.push_back(std::log(contact.approach));
    change.push_back(std::log(contact.force / (4.0 / 3 * sphere.modulus_of_films())) -
                     1.5 * std::log(contact.approach));
  }
  const boost::math::interpolators::makima<std::vector<double>> curve(std::move(reach), std::move(change));
  for (int i = 0; i < reaches; ++i) row.push_back(curve(first_reach + reach_step * i));
  return row;
}

/// Between four contrasts by the cubic through them.
FilmedLaw::Curve FilmedLaw::curve(double of_film) const {
  const double film = 1 / (1 / (of_film * bare_) - 1 / of_other_),
               place = std::log(film / modulus_alone(coated_)) / contrast_step;
  const int from = static_cast<int>(std::floor(place)) - 1;
  const double x = place - from - 1;
  const std::array<double, 4> weights{-x * (x - 1) * (x - 2) / 6, (x + 1) * (x - 1) * (x - 2) / 2,
                                      -(x + 1) * x * (x - 2) / 2, (x + 1) * x * (x - 1) / 6};
  std::vector<double> changes(reaches, 0.0);
  for (int k = 0; k < 4; ++k) {
    const std::vector<double>& of_contrast = row(from + k);
    for (int i = 0; i < reaches; ++i) changes[i] += weights[k] * of_contrast[i];
  }
  return {changes, of_film};
}

FilmedLaw::Curve::Curve(const std::vector<double>& changes, double of_film)
    : first_(changes.front()),
      last_(changes.back()),
      of_film_(of_film),
      spline_(changes.begin(), changes.end(), first_reach, reach_step) {}

/// Beyond the table the change of a contact much smaller than the film is thick goes with a/t, and what is
/// left of the film to one much wider with t/a.
double FilmedLaw::Curve::modulus(double reach) const {
  constexpr double last_reach = first_reach + reach_step * (reaches - 1);
  const double place = std::log(reach);
  if (place < first_reach) return of_film_ * std::exp(first_ * std::exp((place - first_reach) / 2));
  if (place <= last_reach) return of_film_ * std::exp(spline_(place));
  const double of_body = -std::log(of_film_);
  return of_film_ * std::exp(of_body + (last_ - of_body) * std::exp((last_reach - place) / 2));
}

std::shared_ptr<const FilmedLaw> filmed_law(const ElasticBody& coated, const ElasticBody& other) {
  static std::mutex mutex;
  static std::map<std::tuple<double, double, double>, std::shared_ptr<const FilmedLaw>> laws;
  const std::lock_guard<std::mutex> lock(mutex);
  auto& law = laws[{coated.youngs_modulus, coated.poisson_ratio, modulus_alone(other)}];
  if (!law) law = std::make_shared<const FilmedLaw>(coated, modulus_alone(other));
  return law;
}

}  // namespace asperity
