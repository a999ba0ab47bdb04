// One line of the comparison: a quantity of one contact at one load, from four sources side by side. SI
// units.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/motion.h"
#include "dem_compare/numbers/uncertain.h"

namespace asperity {

enum class Quantity {
  approach,
  normal_stiffness,              ///< dF/d(delta) while the load grows
  lateral_stiffness,             ///< tangent from rest, before any slip
  lateral_stiffness_to_sliding,  ///< of the spring that stores as much as the contact does on its way to
                                 ///< sliding
  sliding_friction,              ///< largest lateral force over the load
  rolling_stiffness,
  rolling_friction,  ///< largest moment over load and particle's radius
  torsion_stiffness,
  torsion_friction,  ///< largest moment over load and particle's radius
  rail_friction,     ///< eq:murail: lateral over normal force of one slope, without offsets
  rail_force,        ///< the same with offsets: mu_rail (1 + h_rail/f)
};

/// How a quantity is named and shown.
struct QuantityDisplay {
  Quantity quantity;
  Motion mode;
  const char* key;    ///< in files
  const char* words;  ///< in tables and sentences
  const char* si;
  const char* unit;  ///< in tables
  double factor;     ///< SI per that unit
};
const QuantityDisplay& display_of(Quantity quantity);

/// A number of one source, or the reason why there is none.
struct ComparedValue {
  double value = std::numeric_limits<double>::quiet_NaN();
  double sd = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known
  std::string source{};  ///< name of the law, engine and version, place in the paper
  std::string reason{};  ///< where the value is not known

  bool known() const { return std::isfinite(value); }
};
inline ComparedValue absent(const std::string& reason) { return {NAN, NAN, "", reason}; }

/// The finite elements' value, from so many realisations.
struct FiniteElementValue : ComparedValue {
  int realisations = 0;
  double mesh_error = std::numeric_limits<double>::quiet_NaN();  ///< relative; never part of the sd
};

/// One line of the table.
struct ComparisonRow {
  std::string contact;
  Quantity quantity = Quantity::approach;
  double load = 0;                                        ///< on the substrate, in a rail on each slope [N]
  double rms = std::numeric_limits<double>::quiet_NaN();  ///< of the substrate [m]; 0: smooth
  double rail_angle = std::numeric_limits<double>::quiet_NaN();  ///< of a rail [rad]
  FiniteElementValue finite_elements;
  ComparedValue reduced_law, engine, published;

  Motion mode() const { return display_of(quantity).mode; }
};

/// The engine gets the law's number as it is: without the number's sd.
inline double engine_over_law(const ComparisonRow& row) { return row.engine.value / row.reduced_law.value; }

/// One value over another, their sds to first order; not known where either is not.
Uncertain ratio(const ComparedValue& value, const ComparedValue& over);

}  // namespace asperity
