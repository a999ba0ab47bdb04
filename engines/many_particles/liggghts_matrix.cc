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

/// K/(k_n mu^2 R_e^2), one number for all pairs: the geometric mean. k_n is 4/3 E* a, or Luding's k1.
double rolling_prefactor(const MaterialMatrix& matrix, MatrixHeader& header) {
  const auto wanted = [&](std::size_t i, std::size_t j) {
    const PairLaw& law = matrix.pair(i, j).law;
    const double a = Hertz{law.reduced_modulus, matrix.pair_radius()}.contact_radius(matrix.load),
                 normal = law.luding ? law.luding->k1 * matrix.constant_radius(i, j)
                                     : 4.0 / 3 * law.reduced_modulus * a;
    return law.rolling_stiffness / (normal * law.rolling * law.rolling);
  };
  double sum = 0;
  int count = 0;
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    if (matrix.pair(i, j).law.rolling > 0) sum += std::log(wanted(i, j)), ++count;
  });
  if (count == 0) return 0;
  const double prefactor = std::exp(sum / count);
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    if (matrix.pair(i, j).law.rolling > 0)
      header.not_expressed.push_back(
          pair_name(matrix, i, j) +
          ": rolling stiffness, prefactor k_n mu^2 R_e^2 with one prefactor for all pairs: " +
          percent(prefactor / wanted(i, j) - 1) +
          (matrix.yields() ? "" : " at " + printed("%.3g", matrix.load) + " N"));
  });
  return prefactor;
}

void say_that_torsion_is_missing(const MaterialMatrix& matrix, MatrixHeader& header) {
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    if (matrix.pair(i, j).law.torsion > 0)
      header.not_expressed.push_back(
          pair_name(matrix, i, j) +
          ": torsion: there is none beside rolling by 'luding'; -100 % at every load");
  });
}

template <class OfPair>
std::string by_pair(const MaterialMatrix& matrix, const std::string& name, const OfPair& of_pair) {
  const std::size_t n = matrix.materials.size();
  std::string text = " all property/global " + name + " peratomtypepair " + std::to_string(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) text += " " + text_number(of_pair(i, j));
  return text + "\n";
}

std::string by_pair(const MaterialMatrix& matrix, const std::string& name, double PairLaw::*member) {
  return by_pair(matrix, name, [&](auto i, auto j) { return matrix.pair(i, j).law.*member; });
}

std::string for_all(const MaterialMatrix& matrix, const std::string& name, double value) {
  return by_pair(matrix, name, [&](auto, auto) { return value; });
}

std::string by_type(const MaterialMatrix& matrix, const std::string& name, double MatrixMaterial::*member,
                    double where_not_known) {
  std::string text = " all property/global " + name + " peratomtype";
  for (const MatrixMaterial& m : matrix.materials)
    text += " " + text_number(std::isfinite(m.*member) ? m.*member : where_not_known);
  return text + "\n";
}

std::string luding_properties(const MaterialMatrix& matrix) {
  const auto of = [&](std::size_t i, std::size_t j) { return *matrix.pair(i, j).law.luding; };
  return "fix m8" +
         by_pair(matrix, "LoadingStiffness",
                 [&](auto i, auto j) { return of(i, j).k1 * matrix.constant_radius(i, j); }) +
         "fix m9" +
         by_pair(matrix, "UnloadingStiffness", [&](auto i, auto j) { return of(i, j).kp / of(i, j).k1; }) +
         "fix m10" +
         by_pair(matrix, "coefficientAdhesionStiffness",
                 [&](auto i, auto j) { return of(i, j).kc / of(i, j).k1; }) +
         "fix m11" +
         by_pair(matrix, "coefficientPlasticityDepth", [&](auto i, auto j) { return of(i, j).phi; }) +
         "fix m12" + for_all(matrix, "pullOffForce", 0);
}

/// All properties and styles; `normal`: the model of the normal force, with its own properties.
std::string liggghts_text(const MaterialMatrix& matrix, const MatrixHeader& header, const std::string& normal,
                          const std::string& own_properties, double prefactor) {
  const std::string model =
      "model " + normal + " tangential history" + (prefactor > 0 ? " rolling_friction epsd3" : "");
  std::string text = header_text(matrix, header, lammps_comment) + "\n# Behind the box of " +
                     std::to_string(matrix.materials.size()) +
                     " types, before which must stand: hard_particles yes (moduli above 1e9 Pa)\nfix m1" +
                     by_type(matrix, "youngsModulus", &MatrixMaterial::youngs_modulus, 1e9) + "fix m2" +
                     by_type(matrix, "poissonsRatio", &MatrixMaterial::poissons_ratio, 0.3) + "fix m3" +
                     by_pair(matrix, "coefficientFriction", &PairLaw::sliding) + "fix m4" +
                     for_all(matrix, "coefficientRestitution", matrix.restitution) + own_properties;
  if (prefactor > 0)
    text += "fix m5" + by_pair(matrix, "coefficientRollingFriction", &PairLaw::rolling) + "fix m6" +
            for_all(matrix, "coefficientRollingViscousDamping", 0) +
            "fix m7 all property/global rollingStiffness scalar " + text_number(prefactor) + "\n";
  return text + "pair_style gran " + model + "\npair_coeff * *\ntimestep " +
         text_number(time_step_of(matrix).advised) +
         "\n\n# A plane of type j: fix floor all wall/gran ${on_plane} primitive type j zplane 0.0\nvariable "
         "on_plane string \"" +
         model + "\"\n";
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
  say_that_torsion_is_missing(matrix, header);
  return liggghts_text(matrix, header, "hertz", "", prefactor);
}

std::string liggghts_luding_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "LIGGGHTS";
  header.sizes = one_size_of_stiffness(matrix) + " Rolling goes with R_e, its stiffness with R_e^2.";
  header.damping = "coefficientRestitution.";
  const double prefactor = rolling_prefactor(matrix, header);
  say_that_torsion_is_missing(matrix, header);
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const LudingPair& luding = *matrix.pair(i, j).law.luding;
    header.not_expressed.push_back(pair_name(matrix, i, j) + ": lateral stiffness: it is k1 here, " +
                                   percent(luding.k1 / luding.lateral - 1));
  });
  return liggghts_text(matrix, header, "luding", luding_properties(matrix), prefactor);
}

}  // namespace asperity
