// Which contact a line of the comparison is about: bodies, roughness, and the numbers a discrete element
// engine gets for it.
#pragma once

#include <optional>
#include <string>

#include "dem_compare/cases/case_collection.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

struct ComparedContact {
  std::string label;
  ElasticBody particle, plane;
  double radius = 0;                                      ///< [m]
  double rms = std::numeric_limits<double>::quiet_NaN();  ///< of the substrate [m]; 0: smooth; NaN: not known
  double friction = 0;                      ///< coefficient at the interface of the solved case; 0: none [-]
  std::optional<ContactParameters> record;  ///< where a file was given for this contact
  std::optional<ContactParameters>
      indenter;  ///< contact with the moving plate; the record's own where not given

  // Of the bodies, smooth and elastic, whatever a record says.
  Hertz hertz() const { return {reduced_modulus(particle, plane), radius}; }
  double reduced_shear_modulus() const;  ///< G* [Pa]
  double torsion_modulus() const;        ///< Gt [Pa]
  const ContactParameters& plate() const { return indenter ? *indenter : *record; }
};

/// What the cases of a group agree in.
ComparedContact contact_of(const CaseGroup& group);
/// Throws InputError for a record without elastic constants or with a sphere as its target.
ComparedContact contact_of(const ContactParameters& record, const std::optional<ContactParameters>& indenter);

/// Same bodies within one percent of each number.
bool same_bodies(const ComparedContact& one, const ComparedContact& other);
/// Substrates of the same RMS within a tenth; one that is not known is the same as none.
bool same_roughness(const ComparedContact& one, const ComparedContact& other);

}  // namespace asperity
