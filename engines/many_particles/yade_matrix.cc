#include <cmath>

#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/time_step.h"
#include "engines/text_number.h"
#include "engines/yade_contacts.h"

namespace asperity {

std::string yade_matrix(const MaterialMatrix& matrix) {
  MatrixHeader header;
  header.engine = "YADE";
  header.sizes =
      "asperity_step() scales rolling and torsion with them: limit with R_e, stiffness with R_e^2.";
  const double betan = std::sqrt(5.0 / 6) * damping_ratio(matrix.restitution);
  header.damping =
      "betan = (5/6)^(1/2) -ln e/(ln^2 e + pi^2)^(1/2) of the functor (Antypov & Elliott 2011), betas alike.";
  std::string text = header_text(matrix, header, python_comment) + R"(
# O.engines: InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(),
#                             Ig2_Facet_Sphere_ScGeom()],
#                            [asperity_functor], [asperity_law]),
#            # behind it and before NewtonIntegrator(damping=0), at every step
#            PyRunner(command='asperity_step()', iterPeriod=1, initRun=True),
asperity_materials = []  # ids of the types, in their order
)";
  for (const MatrixMaterial& m : matrix.materials) {
    const auto known = [](double value, double otherwise) {
      return text_number(std::isfinite(value) ? value : otherwise);
    };
    text += "asperity_materials.append(O.materials.append(FrictMat(label=" + python_literal(m.name) +
            ", young=" + known(m.youngs_modulus, 1e9) + ", poisson=" + known(m.poissons_ratio, 0.3) +
            ",\n    density=" + known(m.density, 1000) +
            ", frictionAngle=0)))  # moduli and friction: replaced on each contact\n";
  }
  text += "asperity_functor = Ip2_FrictMat_FrictMat_MindlinPhys(betan=" + text_number(betan) +
          ", betas=" + text_number(betan) +
          ")\nasperity_law = Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)\nO.dt = " +
          text_number(time_step_of(matrix).advised) + "\n" + yade_functions() + "\n";
  const double R = matrix.pair_radius();
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const PairLaw& law = matrix.pair(i, j).law;
    YadeContact contact;
    contact.kno = 4.0 / 3 * law.reduced_modulus * std::sqrt(R);
    contact.kso = 8 * law.shear_modulus * std::sqrt(R);
    contact.friction = law.sliding;
    contact.kr = law.rolling_stiffness * R * R;
    contact.bend = law.rolling * R;
    contact.ktw = law.torsion_stiffness * R * R;
    contact.twist = law.torsion * R;
    contact.goes_with_size = true;
    text += yade_contact_entry(python_literal(matrix.materials[i].name),
                               python_literal(matrix.materials[j].name), R, contact);
  });
  return text;
}

}  // namespace asperity
