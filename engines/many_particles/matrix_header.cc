#include "engines/many_particles/matrix_header.h"

#include <cmath>

#include "core/joined.h"
#include "core/printed.h"
#include "engines/many_particles/time_step.h"
#include "engines/text_number.h"

namespace asperity {
namespace {

std::string short_number(double value) { return std::isfinite(value) ? printed("%.4g", value) : "not known"; }

std::string material_line(const MatrixMaterial& m, std::size_t index) {
  return "  type " + std::to_string(index + 1) + " = " + m.name + ": E = " + short_number(m.youngs_modulus) +
         " Pa, nu = " + short_number(m.poissons_ratio) + ", density = " + short_number(m.density) + " kg/m^3";
}

std::string normal_law_of(const PairLaw& law) {
  if (!law.luding)
    return "E* = " + short_number(law.reduced_modulus) + " Pa, G* = " + short_number(law.shear_modulus) +
           " Pa";
  const LudingPair& luding = *law.luding;
  return "k1 = " + short_number(luding.k1) + " R_e, k_p = " + short_number(luding.kp) +
         " R_e, k_c = " + short_number(luding.kc) + " R_e, k_l = " + short_number(luding.lateral) +
         " R_e [N/m, R_e in m], phi_f = " + short_number(luding.phi);
}

void add_pairs(std::vector<std::string>& all, const MaterialMatrix& matrix) {
  all.push_back("Pairs; limits over the normal force F, R_e = R1 R2/(R1 + R2), at a plane R:");
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const MaterialPair& pair = matrix.pair(i, j);
    const PairLaw& law = pair.law;
    std::string text = "  " + pair_name(matrix, i, j) + ": " + normal_law_of(law) + ", friction " +
                       short_number(law.sliding);
    text += law.rolling > 0 ? ", rolling " + short_number(law.rolling) + " R_e, " +
                                  short_number(law.rolling_stiffness) + " N/m R_e^2"
                            : ", no rolling resistance";
    text += law.torsion > 0 ? ", torsion " + short_number(law.torsion) + " R_e, " +
                                  short_number(law.torsion_stiffness) + " N/m R_e^2"
                            : ", no torsion resistance";
    all.push_back(text);
    all.push_back("    from " + pair.origin);
    for (const auto& line : pair.not_expressed) all.push_back("    not expressed: " + line);
  });
}

}  // namespace

std::string pair_name(const MaterialMatrix& matrix, std::size_t i, std::size_t j) {
  const auto name = [&](std::size_t k) {
    return "type " + std::to_string(k + 1) + " (" + matrix.materials[k].name + ")";
  };
  return name(i) + " and " + name(j);
}

double damping_ratio(double restitution) {
  const double l = std::log(restitution);
  return -l / std::sqrt(l * l + M_PI * M_PI);
}

std::string one_size_of_stiffness(const MaterialMatrix& matrix) {
  const double largest = matrix.largest_radius, smallest = matrix.smallest_radius;
  std::string text =
      "Stiffness goes with R_e and is one number for a pair here: that of two particles of R = " +
      short_number(largest) +
      " m, R_e = R/2, or, of a pair with a plane's material, of one of them on a plane, R_e = R; a particle "
      "on "
      "a plane of its own material has half of what it should have";
  if (smallest < largest)
    text += "; between particles of R = " + short_number(smallest) + " m it is " +
            printed("%.3g", largest / smallest) + " times what it should be";
  return text + ".";
}

std::vector<std::string> header_lines(const MaterialMatrix& matrix, const MatrixHeader& header) {
  std::vector<std::string> all;
  all.push_back("Written by asperity for " + header.engine + " from " + joined(matrix.files, ", "));
  all.push_back("SI units. Materials:");
  for (std::size_t i = 0; i < matrix.materials.size(); ++i)
    all.push_back(material_line(matrix.materials[i], i));
  all.push_back("");
  add_pairs(all, matrix);
  all.push_back("");
  all.push_back("Sizes: particles of R = " + short_number(matrix.smallest_radius) + " to " +
                short_number(matrix.largest_radius) + " m. " +
                (matrix.yields() ? "" : "E* and G* hold at every size. ") + header.sizes);
  all.push_back(std::string("Loads: meant for up to ") + short_number(matrix.load) + " N" +
                (matrix.load_is_given ? ", as asked for." : ", the highest that a record was fitted on."));
  const TimeStep step = time_step_of(matrix);
  all.push_back("Time step advised: " + text_number(step.advised) +
                " s, the smaller of a fifth of the Rayleigh time (" + short_number(step.rayleigh) +
                " s) and a thirtieth of the shortest period (" + short_number(step.shortest_period) + " s, " +
                step.spring + ", at the highest load).");
  all.push_back(
      "Restitution " + text_number(matrix.restitution) +
      (matrix.restitution_is_given ? ", as asked for: " : ": in no record, choose it with --restitution: ") +
      header.damping + (matrix.yields() ? " Yielding dissipates besides." : ""));
  for (const auto& line : header.not_expressed)
    all.push_back("Not expressed by " + header.engine + ": " + line);
  return all;
}

std::string header_text(const MaterialMatrix& matrix, const MatrixHeader& header,
                        const CommentStyle& comment) {
  std::string text;
  for (const auto& line : header_lines(matrix, header)) text += comment.line(line) + "\n";
  return text;
}

}  // namespace asperity
