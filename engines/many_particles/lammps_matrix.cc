#include <cmath>

#include "core/error.h"
#include "engines/lammps.h"
#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/time_step.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

/// Of 'damping tsuji' that LAMMPS computes from the number it is given (Tsuji et al. 1992, by its manual).
double tsuji_polynomial(double e) {
  return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

/// The number that makes a restitution: LAMMPS' polynomial is off by up to 0.05 (0.853 for 0.8), so it is
/// given the one at which its damper, polynomial times (m F/delta)^(1/2), is that of the restitution. Throws
/// InputError for one that it cannot reach.
double tsuji_number(double restitution) {
  if (restitution == 1) return 1;
  const double wanted = 2 * std::sqrt(5.0 / 6 * 1.5) * damping_ratio(restitution);
  if (wanted > tsuji_polynomial(0))
    throw InputError(
        "LAMMPS' damping reaches a restitution of 0.12 and above; choose a larger one with --restitution");
  double low = 0, high = 1;
  while (high - low > 1e-12) {
    const double middle = (low + high) / 2;
    (tsuji_polynomial(middle) > wanted ? low : high) = middle;
  }
  return low;
}

/// A pair's law at one effective radius, which fixes its torsion.
std::string law_text(const MaterialMatrix& matrix, std::size_t i, std::size_t j, double radius) {
  const PairLaw& law = matrix.pair(i, j).law;
  LammpsContact contact;
  contact.normal = 4.0 / 3 * law.reduced_modulus;
  contact.normal_damping = tsuji_number(matrix.restitution);
  contact.tangential = 8 * law.shear_modulus;
  contact.tangential_damping = matrix.restitution < 1 ? 1 : 0;
  contact.sliding = law.sliding;
  contact.rolling_stiffness = law.rolling_stiffness;
  contact.rolling = law.rolling;
  contact.torsion_stiffness = law.torsion_stiffness * radius * radius;
  contact.torsion = law.torsion * radius;
  // A lateral force that is held while the contact unloads would add to the energy of a spinning impact.
  return lammps_text(contact, "mindlin_rescale/force") + " damping tsuji";
}

}  // namespace

std::string lammps_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "LAMMPS";
  header.sizes =
      "'rolling sds' goes with them as written above: limit with R_e, stiffness with R_e^2. 'twisting sds' "
      "is one number for all "
      "sizes: here that of two of the largest particles (R_e = " +
      text_number(matrix.pair_radius()) + " m), at a plane that of one.";
  header.damping = "the second number of 'hertz' with 'damping tsuji', which is " +
                   text_number(tsuji_number(matrix.restitution)) +
                   " because LAMMPS' polynomial makes another restitution of the same number; tangential "
                   "damping as the normal one.";
  std::string text =
      header_text(matrix, header, lammps_comment) + "\n# Behind the box of " +
      std::to_string(matrix.materials.size()) +
      " types (boundary f f f or p p p, newton off, comm_modify vel yes).\npair_style granular\n";
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    text += "pair_coeff " + std::to_string(i + 1) + " " + std::to_string(j + 1) + " " +
            law_text(matrix, i, j, matrix.pair_radius()) + "\n";
  });
  text +=
      "\n# A plane of type j, for the particles of each type i: group type_i type i\n"
      "#   fix floor_i type_i wall/gran granular ${on_plane_i_j} zplane 0 NULL\n";
  for (std::size_t j = 0; j < matrix.materials.size(); ++j)
    for (std::size_t i = 0; i < matrix.materials.size(); ++i)
      text += "variable on_plane_" + std::to_string(i + 1) + "_" + std::to_string(j + 1) + " string \"" +
              law_text(matrix, i, j, matrix.wall_radius()) + "\"\n";
  return text + "timestep " + text_number(time_step_of(matrix).advised) + "\n";
}

}  // namespace asperity
