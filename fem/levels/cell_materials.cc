#include "fem/levels/cell_materials.h"

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

double oedometric_modulus(const J2Material& m) { return m.bulk_modulus + 4.0 / 3 * m.shear_modulus; }

/// Share of the film from 0 to 1.
J2Material laminate(const J2Material& film, const J2Material& body, double share) {
  const auto harmonic = [share](double of_film, double of_body) {
    return 1 / (share / of_film + (1 - share) / of_body);
  };
  constexpr double larger_part = 0.5;
  J2Material mixed = share >= larger_part ? film : body;
  mixed.shear_modulus = harmonic(film.shear_modulus, body.shear_modulus);
  mixed.bulk_modulus =
      harmonic(oedometric_modulus(film), oedometric_modulus(body)) - 4.0 / 3 * mixed.shear_modulus;
  return mixed;
}

}  // namespace

CellMaterials::CellMaterials(const std::array<J2Material, 2>& bodies, const std::array<Film, 2>& films)
    : CellMaterials(bodies) {
  for (int b = 0; b < 2; ++b) thickness_[b] = films[b].thickness;
  if (!has_films()) return;
  for (int b = 0; b < 2; ++b)
    for (int step = 1; step <= steps_of_share; ++step)
      table_.push_back(films[b].thickness > 0 ? laminate(films[b].material, bodies[b],
                                                         static_cast<double>(step) / steps_of_share)
                                              : bodies[b]);
}

unsigned char CellMaterials::number(int body, double share) const {
  if (!(thickness_[body] > 0)) return static_cast<unsigned char>(body);
  const int step = static_cast<int>(std::lround(share * steps_of_share));
  return static_cast<unsigned char>(step == 0 ? body : 1 + body * steps_of_share + step);
}

bool CellMaterials::relaxes() const {
  return std::any_of(table_.begin(), table_.end(),
                     [](const J2Material& m) { return m.relaxation.is_there(); });
}

bool CellMaterials::can_yield() const {
  return std::any_of(table_.begin(), table_.end(), [](const J2Material& m) { return m.can_yield(); });
}

}  // namespace asperity::fem
