#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/time_step.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

/// What one pair's species is told; `object` is a pointer to it.
std::string settings(const MaterialMatrix& matrix, std::size_t i, std::size_t j, const std::string& object) {
  const PairLaw& law = matrix.pair(i, j).law;
  // Its lateral stiffness is (2/3) 8 G a; torsion has the arm 2 R_e.
  constexpr double mercury_share = 2.0 / 3;
  std::string text;
  const auto set = [&](const std::string& what, double value) {
    text += object + "->set" + what + "(" + text_number(value) + ");\n";
  };
  set("EffectiveElasticModulus", law.reduced_modulus);
  set("EffectiveShearModulus", law.shear_modulus / mercury_share);
  set("SlidingFrictionCoefficient", law.sliding);
  if (law.rolling > 0) set("RollingFrictionCoefficient", law.rolling);
  if (law.torsion > 0) set("TorsionFrictionCoefficient", law.torsion / 2);
  return text;
}

}  // namespace

std::string mercurydpm_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "MercuryDPM";
  header.sizes = "Limits of rolling and torsion go with R_e.";
  header.damping = "setDissipation has a definition of its own in each version: set it on every species.";
  header.not_expressed = {
      "stiffness of rolling and torsion, 8 G a R_e^2 and 8 G a (2 R_e)^2, which cannot be set",
      "torsion that reverses: in copies of July 2024 the torsion spring of the Mindlin species doubles every "
      "step and never unloads; check yours"};
  const std::string species = "HertzianViscoelasticMindlinRollingTorsionSpecies";
  std::string text = header_text(matrix, header, cplusplus_comment) + "\n#include <Species/" + species +
                     ".h>\n\nproblem.setTimeStep(" + text_number(time_step_of(matrix).advised) + ");\n";
  const auto name = [](std::size_t i) { return "type_" + std::to_string(i + 1); };
  for (std::size_t i = 0; i < matrix.materials.size(); ++i) {
    text += "auto " + name(i) + " = problem.speciesHandler.copyAndAddObject(" + species + "());\n";
    if (matrix.materials[i].density > 0)
      text += name(i) + "->setDensity(" + text_number(matrix.materials[i].density) + ");\n";
    text += settings(matrix, i, i, name(i));
  }
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    if (i == j) return;
    const std::string mixed = name(i) + "_" + std::to_string(j + 1);
    text += "auto " + mixed + " = problem.speciesHandler.getMixedObject(" + name(i) + ", " + name(j) +
            ");\n" + settings(matrix, i, j, mixed);
  });
  return text;
}

}  // namespace asperity
