#include <cmath>

#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/musen_script.h"

namespace asperity {

std::string musen_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "MUSEN";
  header.sizes = "Rolling has the particle's radius as its arm: right for pairs of one size and at walls.";
  header.damping = "Restitution coefficient of each interaction.";
  header.not_expressed = {"E* and G* of a record, which follow from E and nu",
                          "stiffness of rolling: the torque has no spring",
                          "torsion: merged with rolling, the same coefficient holds for spin"};
  std::string text =
      header_text(matrix, header, plain_comment) + "\n# For a job of a script; contact model Hertz-Mindlin\n";
  std::size_t number = 0;
  for (const MatrixMaterial& m : matrix.materials) {
    text += musen_compound(++number, m.name);
    const auto set = [&](const char* property, double value) {
      text += std::isfinite(value) ? musen_material(property, number, value)
                                   : std::string("# ") + property + " is in no record\n";
    };
    set("DENSITY", m.density), set("YOUNG_MODULUS", m.youngs_modulus), set("POISSON_RATIO", m.poissons_ratio);
  }
  text += "# Interactions of two particles; what rolls on a wall of the other material has twice that\n";
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const PairLaw& law = matrix.pair(i, j).law;
    text += musen_interaction("SLIDING_FRICTION", i + 1, j + 1, law.sliding) +
            musen_interaction("ROLLING_FRICTION", i + 1, j + 1, law.rolling / 2) +
            musen_interaction("RESTITUTION_COEFFICIENT", i + 1, j + 1, matrix.restitution);
  });
  return text;
}

}  // namespace asperity
