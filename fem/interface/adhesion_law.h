// Attraction across the gap of an interface point: traction and separation.
//
// A law is one small class in one file of this folder, which also says what it is. adhesion_law.cc lists them. Attraction acts beside
// the contact pressure, which is what keeps the surfaces from overlapping: friction is that of the contact pressure alone, so that
// attraction works like more load (Derjaguin 1934). With an opening work above the closing one, a point that has been in contact
// attracts by the law of the larger work until its gap leaves the law's range.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/case.h"

namespace asperity::fem {

class AdhesionLaw {
 public:
  virtual ~AdhesionLaw() = default;
  struct Attraction {
    double stress;  ///< [Pa], not negative
    double slope;   ///< its change with the gap [Pa/m]
    double work;    ///< left to be done to separate the surfaces from here [J/m^2]
  };
  /// At a gap [m], 0 or more.
  virtual Attraction at(double gap) const = 0;
  /// Gap beyond which attraction is gone, or next to nothing [m].
  virtual double range() const = 0;
};

/// What a law is, for the manual, and the word by which a case asks for it.
struct AdhesionLawEntry {
  std::string name, equation, source, parameters, validity;
  /// work: of separation from contact [J/m^2]; length: the law's own [m].
  std::unique_ptr<AdhesionLaw> (*make)(double work, double length);
};
const std::vector<AdhesionLawEntry>& adhesion_laws();

/// The law of that name. Throws InputError with the names there are.
std::unique_ptr<AdhesionLaw> make_adhesion_law(const std::string& name, double work, double length);

/// Laws of closing and of opening surfaces; both null: no adhesion.
struct AdhesionLaws {
  std::shared_ptr<const AdhesionLaw> closing, opening;
};
AdhesionLaws make_adhesion_laws(const InterfaceInput& input);

}  // namespace asperity::fem
