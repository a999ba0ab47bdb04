// Attraction across the gap of an interface point: traction and separation.
//
// A law is one class in one file of adhesion/, which also declares it: its entries of a case file, and how it
// is made from them. Attraction acts beside the contact pressure, which is what keeps the surfaces from
// overlapping: friction is that of the contact pressure alone, so that attraction works like more load
// (Derjaguin 1934). With a larger work of adhesion on separation than on approach, a point that has been in
// contact attracts by the law of the larger work until its gap leaves the law's range.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/law_declaration.h"

namespace asperity::fem {

class AdhesionLaw {
 public:
  virtual ~AdhesionLaw() = default;
  /// Traction at one gap.
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

/// Work of adhesion of surfaces on approach (closing) and on separation (opening) [J/m^2].
struct AdhesionWork {
  double closing = 0, opening = 0;
};

/// Its name is the word by which a case asks for it.
struct AdhesionLawDeclaration : LawDeclaration {
  std::string fall;  ///< how attraction falls with the gap, in a few words
  /// work: of separation from contact [J/m^2]; values: of all of its parameters.
  std::unique_ptr<AdhesionLaw> (*make)(double work, const LawValues& values);
  /// The work of adhesion that follows from the values, where the law is not given one; null: it is.
  AdhesionWork (*own_work)(const LawValues& values) = nullptr;
};
const std::vector<AdhesionLawDeclaration>& adhesion_laws();

/// The length of a law that has one, by its symbol in the law's equation.
ParameterEntry adhesion_range(const std::string& symbol);

/// The law of that name. Throws InputError with the names there are, or naming the entry that it lacks.
/// work: of adhesion [J/m^2].
std::unique_ptr<AdhesionLaw> make_adhesion_law(const std::string& name, double work, const LawValues& values);

/// Given by the case, or by the values of its law; none: no adhesion. Throws InputError as make_adhesion_law
/// does, and where a work is given to a law that has its own.
AdhesionWork work_of_adhesion(const InterfaceInput& input);

/// Entries of work of adhesion and their texts, where they follow from the law's own; none where the case is
/// to be refused.
std::map<std::string, std::string> work_entries_of_law(const InterfaceInput& input);

/// Laws of surfaces on approach (closing) and on separation (opening); both null: no adhesion.
struct AdhesionLaws {
  std::shared_ptr<const AdhesionLaw> closing, opening;
};
AdhesionLaws make_adhesion_laws(const InterfaceInput& input);

}  // namespace asperity::fem
