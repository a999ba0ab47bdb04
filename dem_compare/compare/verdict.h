// From ratios to verdicts: by how much a simplification misses, at which loads, and where it is good enough.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dem_compare/compare/row.h"
#include "dem_compare/numbers/judged.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

/// A law's departure at one load: law over reference, minus one.
struct Departure {
  double load = 0;                                       ///< [N]
  double value = 0;                                      ///< relative
  double sd = std::numeric_limits<double>::quiet_NaN();  ///< relative
  double mesh_error = 0;  ///< of the finite elements, relative; a bound beside the sd

  /// Of the interval about it: two standard deviations and the mesh's error; NaN where neither is known.
  /// Relative.
  double half_width() const;
};

/// Neighbouring departures with the same judgement: the first and the last of them.
struct JudgedRange {
  Judged judged = Judged::not_known;
  bool is_above = false;  ///< outside: too much, not too little
  std::size_t first = 0, last = 0;
};
/// Departures in order of load.
/// tolerance: relative.
std::vector<JudgedRange> judged_ranges(const std::vector<Departure>& departures, double tolerance);

/// Neighbouring compared loads at which a simplification is within the tolerance, as far as its errors allow
/// to say so.
struct GoodRange : LoadRange {
  bool reaches_lowest = false,
       reaches_highest = false;  ///< of the loads compared: what is beyond was not looked at
};
/// tolerance: relative.
std::vector<GoodRange> good_ranges(const std::vector<Departure>& departures, double tolerance);

/// All departures of one law in one quantity, and where it is good enough.
struct LawVerdict {
  std::string contact, law, reference;  ///< "finite elements" or "measurement"
  Quantity quantity = Quantity::approach;
  double rail_angle = std::numeric_limits<double>::quiet_NaN();  ///< of a rail [rad]; NaN: none
  LoadRange compared;                                            ///< lowest and highest load [N]
  std::vector<Departure> departures{};                           ///< in order of load
  std::vector<GoodRange> good{};                                 ///< within them
  int outside = 0,
      not_known = 0;  ///< loads at which it is not good enough, and at which its errors do not allow to say
  bool is_own_fit = false;  ///< the law's numbers were fitted to this very measurement: it judges nothing
  /// The row whose mesh error is largest, where it alone exceeds the tolerance: its load and relative error.
  std::optional<std::pair<double, double>> discretisation_error{};
};

/// One for each law, quantity and reference of each contact.
/// tolerance: relative.
std::vector<LawVerdict> verdicts(const std::vector<ComparisonRow>& rows, double tolerance);

/// The law against finite elements, otherwise against the measurement, at this row's load.
struct RowVerdict {
  Departure departure;
  const char* reference;
};
/// None where neither reference is known.
std::optional<RowVerdict> row_verdict(const ComparisonRow& row);

}  // namespace asperity
