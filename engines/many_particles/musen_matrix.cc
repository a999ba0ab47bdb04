#include <cmath>

#include "core/printable.h"
#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/text_number.h"

namespace asperity {

std::string musen_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "MUSEN";
  header.sizes = "Rolling has the particle's radius as its arm: right for pairs of one size and at walls.";
  header.damping = "Restitution coefficient of each interaction.";
  header.not_expressed = {"E* and G* of a record, which follow from E and nu",
                          "stiffness of rolling: the torque has no spring",
                          "torsion: merged with rolling, the same coefficient holds for spin"};
  std::string text = header_text(matrix, header, plain_comment) + "\n# Materials editor, compounds\n";
  const auto number = [](double value) {
    return std::isfinite(value) ? text_number(value) : std::string("not in any record");
  };
  for (const MatrixMaterial& m : matrix.materials)
    text += printable(m.name) + ": Young modulus [Pa] " + number(m.youngs_modulus) + ", Poisson ratio [-] " +
            number(m.poissons_ratio) + ", density [kg/m3] " + number(m.density) + "\n";
  text +=
      "# Materials editor, interactions; contact model Hertz-Mindlin; rolling of two particles, and at a "
      "wall\n";
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const PairLaw& law = matrix.pair(i, j).law;
    text += printable(matrix.materials[i].name) + " and " + printable(matrix.materials[j].name) +
            ": Sliding friction [-] " + text_number(law.sliding) + ", Rolling friction [-] " +
            text_number(law.rolling / 2) + " (wall " + text_number(law.rolling) +
            "), Restitution coefficient [-] " + text_number(matrix.restitution) + "\n";
  });
  return text;
}

}  // namespace asperity
