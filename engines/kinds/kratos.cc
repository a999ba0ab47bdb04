// Kratos DEMApplication: MaterialsDEM.json. JSON has no comments: the header is a list of texts under a key
// of its own.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/printable.h"
#include "engines/engine_registry.h"
#include "engines/input_notes.h"
#include "engines/many_particles/matrix_inputs.h"

namespace asperity {
namespace {

std::string kratos_input(InputNotes& notes) {
  const ContactParameters& p = notes.record();
  const EngineElasticity elasticity = engine_elasticity(notes);
  notes.meaning("YOUNG_MODULUS", elasticity.youngs_modulus[0], "Pa",
                "of the particle; Kratos makes E* and k_l = 8 G* a of both materials");
  const double mu = notes.sliding(),
               lever = p.target.is_plane() ? p.particle.radius : std::min(p.particle.radius, p.target.radius);
  notes.meaning("STATIC_FRICTION, DYNAMIC_FRICTION", mu, "",
                "|f_l| <= mu F; equal, so that FRICTION_DECAY does nothing");
  nlohmann::ordered_json relation;
  relation["COEFFICIENT_OF_RESTITUTION"] = 0.5;
  notes.meaning("COEFFICIENT_OF_RESTITUTION", 0.5, "", "not in the record: choose it");
  relation["STATIC_FRICTION"] = mu;
  relation["DYNAMIC_FRICTION"] = mu;
  relation["FRICTION_DECAY"] = 500.0;
  if (notes.has_rolling()) {
    const double rolling = notes.rolling() / lever;
    notes.meaning("ROLLING_FRICTION", rolling, "",
                  "C_ro over the smaller radius, |M| <= mu min(R) F; at walls the lever is R - delta");
    relation["ROLLING_FRICTION"] = rolling;
    relation["ROLLING_FRICTION_WITH_WALLS"] = rolling;
    relation["DEM_ROLLING_FRICTION_MODEL_NAME"] = "DEMRollingFrictionModelConstantTorque";
    notes.cannot("rolling stiffness: the torque is constant and has no spring");
  }
  if (notes.has_torsion())
    notes.cannot(
        "torsion: the rolling torque acts along the whole angular velocity, spin included, with rolling's "
        "coefficient");
  notes.leaves_out_pull_off("needs the DMT or JKR law of its own");
  relation["DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME"] = "DEM_D_Hertz_viscous_Coulomb";
  const std::string particle = notes.particle_name(), target = notes.target_name();
  nlohmann::ordered_json json;
  for (const auto& line : notes.lines()) json["asperity_notes"].push_back(printable(line));
  json["asperity_notes"].push_back(
      "'asperity_notes' is no key of Kratos: take it out where it is in the way. 'material_relations' has "
      "this pair alone; every other pair that can meet, and 'material_assignation_table', which says what "
      "is of which material, are yours.");
  const auto material = [&](const std::string& name, int id, const ContactBody& body) {
    nlohmann::ordered_json variables;
    if (body.density > 0) variables["PARTICLE_DENSITY"] = body.density;
    variables["YOUNG_MODULUS"] = elasticity.youngs_modulus[id - 1];
    variables["POISSON_RATIO"] = elasticity.poissons_ratio[id - 1];
    return nlohmann::ordered_json{{"material_name", name}, {"material_id", id}, {"Variables", variables}};
  };
  json["materials"] = {material(particle, 1, p.particle), material(target, 2, p.target)};
  json["material_relations"] = nlohmann::ordered_json::array();
  json["material_relations"].push_back(
      {{"material_names_list", {particle, target}}, {"material_ids_list", {1, 2}}, {"Variables", relation}});
  constexpr bool ascii_only = true;  // whatever reads it, and in whatever encoding
  return json.dump(1, ' ', ascii_only, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

namespace engines {
std::unique_ptr<WrittenEngine> make_kratos() {
  return written_engine("kratos", "Kratos DEMApplication", {kratos_input, kratos_matrix});
}
}  // namespace engines

}  // namespace asperity
