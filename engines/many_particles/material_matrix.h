// What particles of several materials need: a contact law for every pair of materials. n materials have n (n
// + 1)/2 pairs; each is taken from a record of its own (parameters.json), or mixed from those of both
// materials where there is none, which is said.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engines/parameters/contact_parameters.h"

namespace asperity {

/// A material as the records describe it; what none of them says is NaN.
struct MatrixMaterial {
  std::string name;
  double youngs_modulus = 0;  ///< [Pa]
  double poissons_ratio = 0;  ///< [-]
  double density = 0;         ///< [kg/m^3]
  bool is_plane = false;      ///< a record has it as a plane target: walls are of it
};

/// Luding's law (2008) of a pair that yields, without the size of its bodies: at the same approach over R_e
/// the force goes with R_e^2, so stiffness goes with R_e.
struct LudingPair {
  double k1 = 0, kp = 0, kc = 0;  ///< loading, unloading from delta_p on, pull; over R_e [Pa]
  double phi = 0;                 ///< phi_f of delta_p = k_p/(k_p - k1) phi_f 2 R_e [-]
  double lateral = 0;             ///< k_l over R_e, constant in the load [Pa]

  /// delta_p [m]
  double full_approach(double effective_radius) const { return kp / (kp - k1) * phi * 2 * effective_radius; }
};

/// The law of a pair, without the size of its bodies: limits over the normal force F and stiffness in terms
/// of the effective radius R_e.
struct PairLaw {
  double reduced_modulus = 0;          ///< E* of F = 4/3 E* R_e^(1/2) delta^(3/2) [Pa]
  double shear_modulus = 0;            ///< G* of k_l = 8 G* a [Pa]
  double sliding = 0;                  ///< mu of |f_l| <= mu F [-]
  double rolling = 0;                  ///< mu of |M| <= mu R_e F [-]; zero: no rolling resistance
  double rolling_stiffness = 0;        ///< K/R_e^2 [N/m]
  double torsion = 0;                  ///< mu of |M| <= mu R_e F [-]; zero: no torsion resistance
  double torsion_stiffness = 0;        ///< K/R_e^2 [N/m]
  std::optional<LudingPair> luding{};  ///< in place of E* and G*
};

/// One pair and where its law is from.
struct MaterialPair {
  PairLaw law;
  std::string origin;                      ///< the record's file, or how it was mixed
  bool is_mixed = false;                   ///< no record of its own
  std::vector<std::string> not_expressed;  ///< what of the record the law leaves out, with the error
};

/// What a user chooses for a matrix.
struct MatrixOptions {
  std::optional<double> load;         ///< [N], at which limits are right; else balanced over the fitted loads
  std::optional<LoadRange> radii;     ///< smallest and largest particle [m]; else those of the records
  std::optional<double> restitution;  ///< of a normal impact, above 0 and at most 1
  std::string normal_law = "hertz";   ///< or "luding", of pairs that yield
};

/// All pairs of all materials.
struct MaterialMatrix {
  std::vector<MatrixMaterial> materials;           ///< in the order in which the records name them
  std::vector<MaterialPair> pairs;                 ///< of i <= j, row by row
  std::vector<std::string> files;                  ///< of the records
  double smallest_radius = 0, largest_radius = 0;  ///< of the particles [m]
  double load = 0;                                 ///< highest load that the laws are meant for [N]
  double restitution = 0;                          ///< of a normal impact [-]
  bool restitution_is_given = false;
  bool load_is_given = false;
  std::string normal_law = "hertz";

  bool yields() const { return normal_law != "hertz"; }
  /// Of two materials by their indices, in either order.
  const MaterialPair& pair(std::size_t i, std::size_t j) const;
  /// Of a pair of particles of the largest size, and of one on a plane [m].
  double pair_radius() const { return largest_radius / 2; }
  double wall_radius() const { return largest_radius; }
  /// R_e where an engine takes one number for all sizes of a pair: on a plane where one material is a plane's
  /// alone, else of two particles [m].
  double constant_radius(std::size_t i, std::size_t j) const {
    return materials[i].is_plane != materials[j].is_plane ? wall_radius() : pair_radius();
  }
  /// For an engine that computes E* and G* itself; throws InputError for a material without E or nu.
  void require_elasticity(const std::string& engine) const;
  /// Index of the material of walls: the first plane of a record, else the last material.
  std::size_t wall() const;
};

/// Calls act(i, j) for every pair once: i <= j, row by row.
template <class Act>
void each_pair(const MaterialMatrix& matrix, const Act& act) {
  for (std::size_t i = 0; i < matrix.materials.size(); ++i)
    for (std::size_t j = i; j < matrix.materials.size(); ++j) act(i, j);
}

/// From one record or more. Throws InputError for a record without the names of its materials, two that say
/// different things of one material or one pair, a pair that can be neither found nor mixed, and a record
/// that lacks what an engine needs, Luding's numbers where they are asked for among it.
MaterialMatrix material_matrix(const std::vector<ContactParameters>& records, const MatrixOptions& options);

}  // namespace asperity
