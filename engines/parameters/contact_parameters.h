// What a contact hands over to a discrete element engine: parameters.json, "format": "asperity-parameters/1".
// Linear-elastic contact with yield limits for each mode of motion (Luding 2008; Fuchs, Weinhart et al. 2014,
// sec. 3.2):
//   |f_l| <= mu_l (f + h_l),   |M_ro| <= mu_ro lambda_ro (f + h_ro),   |M_to| <= mu_to lambda_to (f + h_to),
// f the normal load, h the offset of each mode, lambda its length scale: the particle's radius r or the
// contact radius a. SI units. Meant for the loads it was found on (load range of each quantity); outside of
// them it extrapolates.
#pragma once

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/hertz.h"
#include "core/length_scale.h"

namespace asperity {

/// Normal loads [N].
struct LoadRange {
  double low = 0, high = 0;
};

/// One number with what must be known to use it.
struct EffectiveQuantity {
  double value = 0;                                      ///< SI
  double sd = std::numeric_limits<double>::quiet_NaN();  ///< standard deviation; NaN: not known
  std::optional<LoadRange> load_range{};                 ///< loads it was found on
  /// Of a friction coefficient: lambda. Of a stiffness: whether it is constant (r) or grows with the contact
  /// radius (a).
  LengthScale length_scale = LengthScale::none;
  double at_load = std::numeric_limits<double>::quiet_NaN();  ///< of a stiffness: the load it belongs to [N]
  std::string provenance{};                                   ///< where it comes from, in words
};
/// Zero for what is not known.
inline double value_or_zero(const std::optional<EffectiveQuantity>& quantity) {
  return quantity ? quantity->value : 0;
}

/// One of the two bodies. What is not known is NaN.
struct ContactBody {
  std::string material;
  double radius = std::numeric_limits<double>::quiet_NaN();          ///< [m]; infinite for a plane
  double youngs_modulus = std::numeric_limits<double>::quiet_NaN();  ///< [Pa]
  double poissons_ratio = std::numeric_limits<double>::quiet_NaN();
  double density = std::numeric_limits<double>::quiet_NaN();  ///< [kg/m^3]
  double rms = std::numeric_limits<double>::quiet_NaN();      ///< roughness of its surface [m]; 0: smooth

  bool is_plane() const { return std::isinf(radius); }
  bool has_elasticity() const { return std::isfinite(youngs_modulus) && std::isfinite(poissons_ratio); }
};

struct ContactParameters {
  std::string file;  ///< where it was read, for messages
  std::string title;
  ContactBody particle, target;
  std::optional<EffectiveQuantity> reduced_modulus;  ///< E* [Pa]
  std::optional<EffectiveQuantity>
      reduced_shear_modulus;                          ///< G* of k_l = 8 G* a [Pa]: a number, never recomputed
  std::optional<EffectiveQuantity> normal_stiffness;  ///< k_n [N/m]
  std::optional<EffectiveQuantity> lateral_stiffness;  ///< k_l [N/m]
  std::optional<EffectiveQuantity> rolling_stiffness;  ///< k_ro [N m/rad]
  std::optional<EffectiveQuantity> torsion_stiffness;  ///< k_to [N m/rad]
  std::optional<EffectiveQuantity> sliding_friction;   ///< mu_l
  std::optional<EffectiveQuantity> sliding_offset;     ///< h_l [N]
  std::optional<EffectiveQuantity> rolling_friction;   ///< mu_ro, times lambda_ro
  std::optional<EffectiveQuantity> rolling_offset;     ///< h_ro [N]
  std::optional<EffectiveQuantity> torsion_friction;   ///< mu_to, times lambda_to
  std::optional<EffectiveQuantity> torsion_offset;     ///< h_to [N]
  std::optional<EffectiveQuantity> pull_off_force;     ///< h_n [N]
  // Elasto-plastic normal laws, of contacts that yield; right up to their at_load.
  std::optional<EffectiveQuantity> unloading_modulus;         ///< E* of Thornton & Ning 1998 [Pa]
  std::optional<EffectiveQuantity> yield_pressure;            ///< p_y likewise [Pa]
  std::optional<EffectiveQuantity> yielded_work_of_adhesion;  ///< w likewise [J/m^2]
  std::optional<EffectiveQuantity> luding_k1;                 ///< k1 of Luding 2008 [N/m]
  std::optional<EffectiveQuantity> luding_kp;                 ///< k_p likewise [N/m]
  std::optional<EffectiveQuantity> luding_kc;                 ///< k_c likewise [N/m]
  std::optional<EffectiveQuantity> luding_delta_p;            ///< approach from which k_p holds [m]
  nlohmann::ordered_json
      derivation;  ///< how the quantities were found (`asperity derive`); passed through, null if not said

  /// R_e = R1 R2/(R1 + R2), the radius that Hertz sees [m]; R for a plane.
  double effective_radius() const;
  /// [kg]; throws InputError where the density is not known.
  double particle_mass() const;
  Hertz hertz() const;
  /// a [m]
  double contact_radius(double load) const { return hertz().contact_radius(load); }
  /// k_n = 2 E* a unless a number is given, which then grows with a [N/m].
  double normal_stiffness_at(double load) const;
  /// k_l = 8 G* a (Mindlin 1949) unless a number is given, which then grows with a [N/m].
  double lateral_stiffness_at(double load) const;
  /// [N m/rad]; throws InputError where the record has none.
  double rolling_stiffness_at(double load) const;
  double torsion_stiffness_at(double load) const;
  /// Largest lateral force mu_l (f + h_l) [N] and torques mu lambda (f + h) [N m]; throw InputError where the
  /// record has none.
  double sliding_limit(double load) const;
  double rolling_limit(double load) const;
  double torsion_limit(double load) const;
  /// lambda at a load [m].
  double length(LengthScale scale, double load) const;

  /// Loads on which a friction coefficient and its offset were both found; empty where neither says so.
  /// Throws InputError if they have no load in common.
  std::optional<LoadRange> load_range(std::optional<EffectiveQuantity> ContactParameters::*friction,
                                      std::optional<EffectiveQuantity> ContactParameters::*offset) const;
};

/// One entry of "quantities" and the member that holds it.
struct QuantityEntry {
  const char* key;
  const char* unit;
  const char* meaning;
  const char* told_by;  ///< Experiment/Type of the cases that `asperity derive` finds it from
  std::optional<EffectiveQuantity> ContactParameters::*member;
  bool needs_yield = false;  ///< only a contact that has yielded has it
};
const std::vector<QuantityEntry>& quantity_entries();

/// Throws InputError naming file, key and what was meant.
ContactParameters read_contact_parameters(const std::filesystem::path& file);
ContactParameters parse_contact_parameters(const nlohmann::ordered_json& json, const std::string& file);

/// As the format says, and the same written into a file.
nlohmann::ordered_json to_json(const ContactParameters& parameters);
void write_contact_parameters(const ContactParameters& parameters, const std::filesystem::path& file);

}  // namespace asperity
