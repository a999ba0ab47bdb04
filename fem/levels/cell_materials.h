// Materials of the cells: of both bodies, of a film on each of them, and of cells that lie in the film with a
// part of their depth. Those are laminates of film and body across which stress is the same: their shear and
// oedometric moduli are harmonic means. They yield as what fills the larger part of them.
#pragma once

#include <array>
#include <vector>

#include "fem/materials/j2_plasticity.h"

namespace asperity::fem {

/// A film that is bonded to a body.
struct Film {
  J2Material material;
  double thickness = 0;  ///< [m]; 0: there is none
};

class CellMaterials {
 public:
  /// Particle and substrate without films. Implicit: what has no film is given as its two materials.
  // NOLINTNEXTLINE(google-explicit-constructor)
  CellMaterials(const std::array<J2Material, 2>& bodies) : table_(bodies.begin(), bodies.end()) {}
  CellMaterials(const std::array<J2Material, 2>& bodies, const std::array<Film, 2>& films);

  /// Number of the material of a cell of a body that lies in its film with that share of its depth [-].
  unsigned char number(int body, double share) const;
  /// By number.
  const J2Material& operator[](unsigned char number) const { return table_[number]; }
  const std::vector<J2Material>& all() const { return table_; }
  /// Thickness of the films on particle and substrate [m]; 0: there is none.
  const std::array<double, 2>& thickness() const { return thickness_; }
  bool has_films() const { return thickness_[0] > 0 || thickness_[1] > 0; }
  bool can_yield() const;
  bool relaxes() const;

 private:
  static constexpr int steps_of_share = 100;
  static_assert(1 + 2 * steps_of_share < 256, "a cell keeps the number of its material in a byte");
  std::vector<J2Material> table_;  ///< particle, substrate, then each film by steps of its share
  std::array<double, 2> thickness_{};
};

}  // namespace asperity::fem
