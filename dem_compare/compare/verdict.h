// From ratios to words: by how much a simplification misses, at which loads, and where it is good enough.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/compare/row.h"
#include "dem_compare/parameters/contact_parameters.h"

namespace asperity {

/// A law's departure at one load: law over reference, minus one.
struct Departure {
  double load = 0;  ///< [N]
  double value = 0;
  double sd = std::numeric_limits<double>::quiet_NaN();
  double mesh_error = 0;  ///< of the finite elements, relative; a bound beside the sd

  /// Of the interval about it: two standard deviations and the mesh's error; NaN where neither is known.
  double half_width() const;
};

/// Neighbouring compared loads at which a simplification is within the tolerance, as far as its errors allow
/// to say so.
struct GoodRange : LoadRange {
  bool reaches_lowest = false,
       reaches_highest = false;  ///< of the loads compared: what is beyond was not looked at
};

struct LawVerdict {
  std::string contact, law, reference;  ///< "finite elements" or "measurement"
  Quantity quantity = Quantity::approach;
  double rail_angle = std::numeric_limits<double>::quiet_NaN();
  LoadRange compared;           ///< lowest and highest load [N]
  std::vector<GoodRange> good;  ///< within them
  int outside = 0,
      not_known = 0;  ///< loads at which it is not good enough, and at which its errors do not allow to say
  bool is_own_fit = false;  ///< the law's numbers were fitted to this very measurement: it judges nothing
  std::string text;
};

/// "overstates the lateral stiffness by 12 ± 3 % from 100 uN to 200 uN; whether within 5 % is not known at
/// 400 uN (5.5 ± 1.0 %)". Departures in order of load; nothing is said of loads between those compared.
std::string departure_words(const std::vector<Departure>& departures, const std::string& quantity,
                            double tolerance);
std::vector<GoodRange> good_ranges(const std::vector<Departure>& departures, double tolerance);

/// " at 25 deg"; "" for NaN.
std::string rail_words(double angle);

/// "from 135 uN on", "at all loads compared", "not known at any load compared", ...
std::string good_words(const LawVerdict& verdict);

/// One for each law, quantity and reference of each contact.
std::vector<LawVerdict> verdicts(const std::vector<ComparisonRow>& rows, double tolerance);

/// The law against finite elements, otherwise against the measurement, at this row's load; "" where neither
/// is known.
std::string row_verdict(const ComparisonRow& row, double tolerance);

}  // namespace asperity
