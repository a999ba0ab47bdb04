#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/time_step.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

constexpr const char* damping =
    "setDissipation has a definition of its own in each version: set it on every species.";

/// Lines that set what a species is told.
class SpeciesLines {
 public:
  explicit SpeciesLines(std::string object) : object_(std::move(object)) {}
  void set(const std::string& what, double value) {
    text_ += object_ + "->set" + what + "(" + text_number(value) + ");\n";
  }
  const std::string& text() const { return text_; }

 private:
  std::string object_, text_;
};

void add_hertz(const MaterialMatrix& matrix, std::size_t i, std::size_t j, SpeciesLines& lines) {
  const PairLaw& law = matrix.pair(i, j).law;
  // Its lateral stiffness is (2/3) 8 G a; torsion has the arm 2 R_e.
  constexpr double mercury_share = 2.0 / 3;
  lines.set("EffectiveElasticModulus", law.reduced_modulus);
  lines.set("EffectiveShearModulus", law.shear_modulus / mercury_share);
  lines.set("SlidingFrictionCoefficient", law.sliding);
  if (law.rolling > 0) lines.set("RollingFrictionCoefficient", law.rolling);
  if (law.torsion > 0) lines.set("TorsionFrictionCoefficient", law.torsion / 2);
}

/// Luding's law, whose springs are constant.
void add_luding(const MaterialMatrix& matrix, std::size_t i, std::size_t j, SpeciesLines& lines) {
  const PairLaw& law = matrix.pair(i, j).law;
  const LudingPair& luding = *law.luding;
  const double R = matrix.constant_radius(i, j);
  lines.set("LoadingStiffness", luding.k1 * R);
  lines.set("UnloadingStiffnessMax", luding.kp * R);
  lines.set("CohesionStiffness", luding.kc * R);
  lines.set("PenetrationDepthMax", luding.phi);
  lines.set("SlidingStiffness", luding.lateral * R);
  lines.set("SlidingFrictionCoefficient", law.sliding);
  if (law.rolling > 0) {
    lines.set("RollingStiffness", law.rolling_stiffness);
    lines.set("RollingFrictionCoefficient", law.rolling);
  }
  if (law.torsion > 0) {  // the arm is 2 R_e
    lines.set("TorsionStiffness", law.torsion_stiffness / 4);
    lines.set("TorsionFrictionCoefficient", law.torsion / 2);
  }
}

using AddPair = void (*)(const MaterialMatrix&, std::size_t, std::size_t, SpeciesLines&);

/// Header, species and mixed species of all pairs.
std::string all_species(const MaterialMatrix& matrix, const MatrixHeader& header, const std::string& species,
                        AddPair add) {
  std::string text = header_text(matrix, header, cplusplus_comment) + "\n#include <Species/" + species +
                     ".h>\n\nproblem.setTimeStep(" + text_number(time_step_of(matrix).advised) + ");\n";
  const auto name = [](std::size_t i) { return "type_" + std::to_string(i + 1); };
  const auto settings = [&](std::size_t i, std::size_t j, const std::string& object) {
    SpeciesLines lines(object);
    add(matrix, i, j, lines);
    return lines.text();
  };
  for (std::size_t i = 0; i < matrix.materials.size(); ++i) {
    text += "auto " + name(i) + " = problem.speciesHandler.copyAndAddObject(" + species + "());\n";
    if (matrix.materials[i].density > 0)
      text += name(i) + "->setDensity(" + text_number(matrix.materials[i].density) + ");\n";
    text += settings(i, i, name(i));
  }
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    if (i == j) return;
    const std::string mixed = name(i) + "_" + std::to_string(j + 1);
    text += "auto " + mixed + " = problem.speciesHandler.getMixedObject(" + name(i) + ", " + name(j) +
            ");\n" + settings(i, j, mixed);
  });
  return text;
}

}  // namespace

std::string mercurydpm_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "MercuryDPM";
  header.sizes = "Limits of rolling and torsion go with R_e.";
  header.damping = damping;
  header.not_expressed = {
      "stiffness of rolling and torsion, 8 G a R_e^2 and 8 G a (2 R_e)^2, which cannot be set",
      "torsion that reverses: in copies of July 2024 the torsion spring of the Mindlin species doubles every "
      "step and never unloads; check yours"};
  return all_species(matrix, header, "HertzianViscoelasticMindlinRollingTorsionSpecies", add_hertz);
}

std::string mercurydpm_luding_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "MercuryDPM";
  header.sizes = one_size_of_stiffness(matrix) + " Limits of rolling and torsion go with R_e.";
  header.damping = damping;
  header.not_expressed = {"nothing more is known to be missing, but this input was not run here"};
  return all_species(matrix, header, "LinearPlasticViscoelasticFrictionSpecies", add_luding);
}

}  // namespace asperity
