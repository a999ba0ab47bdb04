#include "engines/many_particles/time_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/hertz.h"
#include "core/printable.h"

namespace asperity {
namespace {

constexpr double share_of_rayleigh = 0.2;  // usual, of dense packings (O'Sullivan 2011)
constexpr double steps_per_period = 30;    // velocity Verlet is stable above pi; energy needs more

double rayleigh_time(const MatrixMaterial& m, double radius) {
  const double shear_modulus = m.youngs_modulus / (2 * (1 + m.poissons_ratio));
  return M_PI * radius * std::sqrt(m.density / shear_modulus) / (0.1631 * m.poissons_ratio + 0.8766);
}

double mass(const MatrixMaterial& m, double radius) {
  return 4.0 / 3 * M_PI * radius * radius * radius * m.density;
}

struct Springs {
  double normal, lateral;  ///< [N/m]
};

/// Those of a contact that yields are taken of the largest particles: an engine may take one number for all
/// sizes.
Springs springs_of(const PairLaw& law, double effective_radius, double load,
                   double largest_effective_radius) {
  if (law.luding) {
    const LudingPair& luding = *law.luding;
    return {luding.kp * largest_effective_radius,
            std::max(luding.lateral, luding.k1) * largest_effective_radius};
  }
  const double a = Hertz{law.reduced_modulus, effective_radius}.contact_radius(load);
  return {2 * law.reduced_modulus * a, 8 * law.shear_modulus * a};
}

/// Squares of the angular frequencies of a sphere on one contact, `bodies` = 2 where the other one is as free
/// and as heavy.
std::vector<std::pair<double, std::string>> frequencies(const PairLaw& law, const MatrixMaterial& m, double R,
                                                        const Springs& springs, double effective_radius,
                                                        int bodies) {
  const double inertia = 0.4 * mass(m, R) * R * R, scale = effective_radius * effective_radius;
  const double lateral = springs.lateral;
  return {
      {bodies * springs.normal / mass(m, R), "normal spring"},
      {bodies * (lateral * R * R + law.rolling_stiffness * scale) / inertia, "lateral and rolling spring"},
      {bodies * law.torsion_stiffness * scale / inertia, "torsion spring"}};
}

}  // namespace

TimeStep time_step_of(const MaterialMatrix& matrix) {
  TimeStep step;
  double fastest = 0;
  const double R = matrix.smallest_radius;
  for (std::size_t i = 0; i < matrix.materials.size(); ++i) {
    const MatrixMaterial& m = matrix.materials[i];
    if (!(m.density > 0 && m.youngs_modulus > 0 && std::isfinite(m.poissons_ratio))) continue;
    const double rayleigh = rayleigh_time(m, R);
    step.rayleigh = step.rayleigh > 0 ? std::min(step.rayleigh, rayleigh) : rayleigh;
    for (std::size_t j = 0; j < matrix.materials.size(); ++j)
      for (const int bodies : {1, 2}) {
        const PairLaw& law = matrix.pair(i, j).law;
        const Springs springs = springs_of(law, R / bodies, matrix.load, matrix.largest_radius / bodies);
        for (const auto& [squared, spring] : frequencies(law, m, R, springs, R / bodies, bodies)) {
          if (squared <= fastest) continue;
          fastest = squared;
          step.spring = spring + " of '" + printable(m.name) + "' on '" +
                        printable(matrix.materials[j].name) + "'" + (bodies == 1 ? ", a plane" : "");
        }
      }
  }
  if (!(step.rayleigh > 0))
    throw InputError(
        matrix.files.front() +
        ": no record has density, youngs_modulus and poissons_ratio of a material that particles are of; the "
        "time step needs them");
  step.shortest_period = 2 * M_PI / std::sqrt(fastest);
  step.advised = std::min(share_of_rayleigh * step.rayleigh, step.shortest_period / steps_per_period);
  return step;
}

}  // namespace asperity
