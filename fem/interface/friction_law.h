// The largest shear traction that a point of the interface transmits; what moves beyond it slips (slip.h).
//
// A law is one small class in one file of this folder, which also says what it is. friction_law.cc lists them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/case.h"

namespace asperity::fem {

class FrictionLaw {
 public:
  virtual ~FrictionLaw() = default;
  /// Largest shear traction [Pa] under a contact pressure [Pa], 0 or more; never falls as the pressure grows.
  virtual double limit(double pressure) const = 0;
};

/// What a law is, for the manual, and when a case asks for it.
struct FrictionLawEntry {
  std::string name, equation, source, parameters, validity;
  bool (*asked_for)(const InterfaceInput&);
  std::unique_ptr<FrictionLaw> (*make)(const InterfaceInput&);
};
const std::vector<FrictionLawEntry>& friction_laws();

/// The law that the entries ask for; null: frictionless.
std::unique_ptr<FrictionLaw> make_friction_law(const InterfaceInput& input);

}  // namespace asperity::fem
