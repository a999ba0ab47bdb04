// How the yield stress of a body grows with its plastic strain, and with the rate of that: isotropic
// hardening of von Mises' surface.
//
// A law is one class in one file of hardening/, which also declares it: its entries of a case file, and how a
// body's plasticity is made from them. The return map is the same for all of them (j2_plasticity.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/law_declaration.h"
#include "fem/materials/relaxation.h"

namespace asperity::fem {

/// Of a step that is solved for (InterfacePoint says what time is).
struct StepTime {
  double time = 0;  ///< at its end [s]
  double step = 1;  ///< length of the step [s]
};

/// A point that yields, at the end of a step.
struct YieldingPoint {
  double initial;    ///< yield stress without plastic strain [Pa]
  double alpha;      ///< equivalent plastic strain [-]
  double increment;  ///< of it in this step; over time.step its rate [-]
  StepTime time;
};

/// The yield stress at a point, and its tangent.
struct FlowStress {
  double stress;  ///< uniaxial yield stress [Pa]
  double slope;   ///< its change with the increment of the equivalent plastic strain in this step [Pa], above
                  ///< -3 G - H_kin
};

class Hardening {
 public:
  virtual ~Hardening() = default;
  /// The initial yield stress where alpha and increment are 0. Newton's iteration of the return map needs it
  /// concave in the increment.
  virtual FlowStress flow(const YieldingPoint& point) const = 0;
  /// Energy stored per volume, of the integral of the growth of the yield stress over alpha what is not
  /// dissipated [J/m^3].
  virtual double stored_energy(double alpha) const = 0;
  /// The yield stress is linear in the increment.
  virtual bool is_linear() const { return false; }
};

/// What a body is beyond elastic, by its law.
struct Plasticity {
  double yield_stress;                           ///< initial [Pa]
  double kinematic_modulus = 0;                  ///< of Prager's hardening [Pa]
  std::shared_ptr<const Hardening> hardening{};  ///< null: perfectly plastic
  Relaxation relaxation{};
};

/// Why a body cannot be meant: the entry at fault, and a sentence that begins with the body's name.
struct MaterialObjection {
  std::string entry, sentence;
};

/// What a law of a body says of itself, how it is made and what it refuses.
struct MaterialDeclaration : LawDeclaration {
  /// From the values of all of its parameters.
  Plasticity (*make)(const LawValues&);
  /// Empty sentence: none. For a body's Young's modulus [Pa] and all of its values.
  MaterialObjection (*objection)(double youngs_modulus, const LawValues&);
};
/// All of them, by name.
const std::vector<MaterialDeclaration>& material_laws();

/// The yield stress, which every law takes: inf, elastic, where it is not given.
ParameterEntry yield_stress_parameter();
/// H of linear hardening; 0, none, where it is not given.
ParameterEntry hardening_modulus_parameter();

/// By the law whose parameters the body gives, all that it needs and none besides; an infinite yield stress
/// where it gives what none needs. Throws InputError where no law, or more than one, takes just those.
Plasticity make_plasticity(const BodyInput& body);

/// Whether either body relaxes with time.
bool relaxes(const CaseInput& input);

/// First objection of any law to a body; an empty sentence: none.
MaterialObjection objection_to(const BodyInput& body);

}  // namespace asperity::fem
