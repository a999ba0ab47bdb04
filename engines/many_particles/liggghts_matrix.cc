#include <cmath>

#include "core/hertz.h"
#include "core/printed.h"
#include "core/shear_moduli.h"
#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/time_step.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

std::string percent(double error) { return printed("%+.1f %%", 100 * error); }

/// E* and G* follow from E and nu here: what that makes of each pair.
void compare_moduli(const MaterialMatrix& matrix, MatrixHeader& header) {
  constexpr double agrees = 1e-3;
  matrix.require_elasticity("LIGGGHTS");
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const ElasticBody a{matrix.materials[i].youngs_modulus, matrix.materials[i].poissons_ratio},
        b{matrix.materials[j].youngs_modulus, matrix.materials[j].poissons_ratio};
    const PairLaw& law = matrix.pair(i, j).law;
    const double of_E = reduced_modulus(a, b) / law.reduced_modulus - 1,
                 of_G = reduced_shear_modulus(a, b) / law.shear_modulus - 1;
    if (std::abs(of_E) > agrees || std::abs(of_G) > agrees)
      header.not_expressed.push_back(pair_name(matrix, i, j) +
                                     ": E* and G* of the record, which follow from E and nu here: E* " +
                                     percent(of_E) + ", G* " + percent(of_G));
  });
}

/// K/(k_n mu^2 R_e^2), k_n = 4/3 E* a, one number for all pairs: the geometric mean.
double rolling_prefactor(const MaterialMatrix& matrix, MatrixHeader& header) {
  const auto wanted = [&](const PairLaw& law) {
    const double a = Hertz{law.reduced_modulus, matrix.pair_radius()}.contact_radius(matrix.load);
    return law.rolling_stiffness / (4.0 / 3 * law.reduced_modulus * a * law.rolling * law.rolling);
  };
  double sum = 0;
  int count = 0;
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const PairLaw& law = matrix.pair(i, j).law;
    if (law.rolling > 0) sum += std::log(wanted(law)), ++count;
  });
  if (count == 0) return 0;
  const double prefactor = std::exp(sum / count);
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const PairLaw& law = matrix.pair(i, j).law;
    if (law.rolling > 0)
      header.not_expressed.push_back(
          pair_name(matrix, i, j) +
          ": rolling stiffness, prefactor k_n mu^2 R_e^2 with one prefactor for all pairs: " +
          percent(prefactor / wanted(law) - 1) + " at " + printed("%.3g", matrix.load) + " N");
  });
  return prefactor;
}

std::string by_pair(const MaterialMatrix& matrix, const std::string& name, double PairLaw::*member,
                    double otherwise) {
  const std::size_t n = matrix.materials.size();
  std::string text = " all property/global " + name + " peratomtypepair " + std::to_string(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      text += " " + text_number(member ? matrix.pair(i, j).law.*member : otherwise);
  return text + "\n";
}

std::string by_type(const MaterialMatrix& matrix, const std::string& name, double MatrixMaterial::*member) {
  std::string text = " all property/global " + name + " peratomtype";
  for (const MatrixMaterial& m : matrix.materials) text += " " + text_number(m.*member);
  return text + "\n";
}

}  // namespace

std::string liggghts_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "LIGGGHTS";
  header.sizes = "Rolling goes with them as written above, but its stiffness with k_n R_e^2.";
  header.damping = "coefficientRestitution.";
  if (matrix.restitution > 0.9)
    header.not_expressed.push_back(
        "relaxation of the lateral spring as a contact unloads: a spinning impact can gain energy above a "
        "restitution of 0.9");
  compare_moduli(matrix, header);
  const double prefactor = rolling_prefactor(matrix, header);
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    if (matrix.pair(i, j).law.torsion > 0)
      header.not_expressed.push_back(pair_name(matrix, i, j) +
                                     ": torsion: there is none beside 'luding'; -100 % at every load");
  });
  const std::string model =
      std::string("model hertz tangential history") + (prefactor > 0 ? " rolling_friction epsd3" : "");
  std::string text = header_text(matrix, header, lammps_comment) + "\n# Behind the box of " +
                     std::to_string(matrix.materials.size()) +
                     " types, before which must stand: hard_particles yes (moduli above 1e9 Pa)\nfix m1" +
                     by_type(matrix, "youngsModulus", &MatrixMaterial::youngs_modulus) + "fix m2" +
                     by_type(matrix, "poissonsRatio", &MatrixMaterial::poissons_ratio) + "fix m3" +
                     by_pair(matrix, "coefficientFriction", &PairLaw::sliding, 0) + "fix m4" +
                     by_pair(matrix, "coefficientRestitution", nullptr, matrix.restitution);
  if (prefactor > 0)
    text += "fix m5" + by_pair(matrix, "coefficientRollingFriction", &PairLaw::rolling, 0) + "fix m6" +
            by_pair(matrix, "coefficientRollingViscousDamping", nullptr, 0) +
            "fix m7 all property/global rollingStiffness scalar " + text_number(prefactor) + "\n";
  return text + "pair_style gran " + model + "\npair_coeff * *\ntimestep " +
         text_number(time_step_of(matrix).advised) +
         "\n\n# A plane of type j: fix floor all wall/gran ${on_plane} primitive type j zplane 0.0\nvariable "
         "on_plane string \"" +
         model + "\"\n";
}

}  // namespace asperity
