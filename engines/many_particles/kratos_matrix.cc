#include <nlohmann/json.hpp>

#include "core/printable.h"
#include "engines/many_particles/matrix_header.h"
#include "engines/many_particles/matrix_inputs.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// Kratos takes the smaller radius as the arm of rolling: for two of one size twice R_e.
Json relation(const MaterialMatrix& matrix, const PairLaw& law) {
  Json json;
  json["COEFFICIENT_OF_RESTITUTION"] = matrix.restitution;
  json["STATIC_FRICTION"] = law.sliding;
  json["DYNAMIC_FRICTION"] = law.sliding;
  json["FRICTION_DECAY"] = 500.0;
  if (law.rolling > 0) {
    json["ROLLING_FRICTION"] = law.rolling / 2;
    json["ROLLING_FRICTION_WITH_WALLS"] = law.rolling;
    json["DEM_ROLLING_FRICTION_MODEL_NAME"] = "DEMRollingFrictionModelConstantTorque";
  }
  json["DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME"] = "DEM_D_Hertz_viscous_Coulomb";
  return json;
}

}  // namespace

std::string kratos_matrix(const MaterialMatrix& matrix) {
  matrix.require_elasticity("Kratos");
  MatrixHeader header;
  header.engine = "Kratos DEMApplication";
  header.sizes = "Rolling has the smaller radius as its arm: right for pairs of one size and at walls.";
  header.damping = "COEFFICIENT_OF_RESTITUTION.";
  header.not_expressed = {"E* and G* of a record, which follow from E and nu",
                          "stiffness of rolling: the torque is constant",
                          "torsion: the rolling torque acts along the whole angular velocity"};
  Json json;
  for (const auto& line : header_lines(matrix, header)) json["asperity_notes"].push_back(printable(line));
  json["asperity_notes"].push_back(
      "'asperity_notes' is no key of Kratos: take it out where it is in the way.");
  json["materials"] = json["material_relations"] = Json::array();
  for (std::size_t i = 0; i < matrix.materials.size(); ++i) {
    const MatrixMaterial& m = matrix.materials[i];
    Json variables;
    if (m.density > 0) variables["PARTICLE_DENSITY"] = m.density;
    variables["YOUNG_MODULUS"] = m.youngs_modulus;
    variables["POISSON_RATIO"] = m.poissons_ratio;
    json["materials"].push_back(
        {{"material_name", m.name}, {"material_id", i + 1}, {"Variables", variables}});
  }
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    json["material_relations"].push_back(
        {{"material_names_list", {matrix.materials[i].name, matrix.materials[j].name}},
         {"material_ids_list", {i + 1, j + 1}},
         {"Variables", relation(matrix, matrix.pair(i, j).law)}});
  });
  constexpr bool ascii_only = true;  // whatever reads it, and in whatever encoding
  return json.dump(1, ' ', ascii_only, Json::error_handler_t::replace) + "\n";
}

}  // namespace asperity
