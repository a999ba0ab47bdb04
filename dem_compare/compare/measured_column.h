// What was measured of a contact: the last column of the comparison. Whoever has measurements derives from
// it.
#pragma once

#include <vector>

#include "dem_compare/cases/compared_contact.h"
#include "dem_compare/compare/law_column.h"
#include "dem_compare/compare/row.h"

namespace asperity {

class MeasuredColumn {
 public:
  virtual ~MeasuredColumn() = default;

  /// Of a contact under a load [N]; with the reason where it was not measured.
  virtual ComparedValue value(Quantity quantity, const ComparedContact& contact, double load) const = 0;
  /// Of a sphere in a rail whose flanks are inclined by `angle` [rad].
  virtual ComparedValue rail(Quantity quantity, const ComparedContact& contact, double angle,
                             double load) const = 0;
  /// The rails that were measured, with what they need of other measurements.
  virtual std::vector<RailCase> rails() const = 0;
  /// RMS height of a rail's flanks [m].
  virtual double rail_rms(double angle) const = 0;
};

}  // namespace asperity
