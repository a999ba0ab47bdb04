// Rough, yielding contact against Hertz: ratios at each load with their scatter, and what they are judged to
// be.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/cases/case_collection.h"
#include "dem_compare/numbers/judged.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {

/// One load of the first loading, over realisations. Ratios are to Hertz for the same bodies, smooth and
/// elastic.
struct LoadComparison {
  double force = 0;              ///< [N]
  Estimate approach;             ///< [m]
  Estimate stiffness;            ///< tangent of loading [N/m]
  Estimate unloading_stiffness;  ///< tangent of the first unloading at the same load [N/m]
  Estimate contact_area;         ///< real [m^2]
  Estimate mean_pressure;        ///< load over real area [Pa]
  Estimate largest_pressure;     ///< [Pa]
  Estimate plastic_volume;       ///< [m^3]
  Estimate force_ratio;          ///< force over Hertz's at the same approach
  Estimate stiffness_ratio;      ///< tangent stiffness over Hertz's at the same load
  Estimate unloading_ratio;      ///< that of unloading
  Estimate area_ratio;           ///< real contact area over Hertz's at the same load
  Estimate pressure_ratio;       ///< largest pressure over Hertz's at the same load
  double step_error = 0;  ///< largest relative bound on the loading stiffness from the finite load steps
  /// Half widths of the intervals that hold the true means 19 times in 20: scatter of the mean (Student),
  /// mesh error and step error; NaN where nothing is known of it.
  /// In the unit of the ratios [-].
  double stiffness_half_width = 0, unloading_half_width = 0, force_half_width = 0;
  Judged stiffness_judged = Judged::not_known;  ///< stiffness_ratio against 1
};

/// What is known at a load: its name in files, SI unit, and where cases and comparison hold it.
struct LoadColumn {
  const char *name, *unit;
  Estimate LoadComparison::*estimate;
  double LoadPoint::*of_case;
};
const std::vector<LoadColumn>& load_columns();

/// Numbers of a group at its largest load.
struct GroupNumbers {
  double force = 0;  ///< [N]
  Hertz hertz;
  Estimate approach;                                  ///< [m]
  Estimate loading_stiffness;                         ///< [N/m]
  Estimate unloading_stiffness;                       ///< at the start of unloading [N/m]
  Estimate contact_area;                              ///< [m^2]
  Estimate mean_pressure;                             ///< [Pa]
  Estimate largest_pressure;                          ///< [Pa]
  Estimate plastic_volume;                            ///< [m^3]
  Estimate residual_imprint;                          ///< [m]
  Estimate dissipated_energy;                         ///< [J]
  Estimate fitted_radius, fitted_radius_with_offset;  ///< what a Hertz fit would report [m]
  Estimate exponent, exponent_with_offset;
  double differencing_error =
      0;  ///< largest relative bound on the loading stiffness from the finite load steps
};

/// One group of cases against Hertz.
struct GroupComparison {
  std::string label;
  std::vector<std::string> values;
  int realisations = 0;
  double interface_spacing = 0;  ///< [m]
  GroupNumbers numbers;
  std::vector<LoadComparison> loads;
  /// Spacings the same contact was solved on too [m]; the mesh errors come from them.
  std::vector<double> other_spacings;
  bool is_finest = true;  ///< no smaller one is among them: this is the result, the others judge it
  /// The least compared load from which on the stiffness is within the tolerance, errors included; NaN
  /// without one.
  /// In [N].
  double hertzian_from = 0;
  /// Smooth bodies that stay elastic: what departs from Hertz is the error of the computation, and says
  /// nothing of roughness.
  bool is_control = false;
  /// At every load: within; at one load at least: outside; else not known.
  Judged judged_at_all_loads = Judged::not_known;
};

struct Comparison {
  std::string title;
  double tolerance = 0;  ///< relative, of the stiffness
  std::vector<GroupComparison> groups;
  std::vector<MissingCase> missing;
  std::vector<std::string> remarks;  ///< on cases whose numbers are in doubt
  std::size_t planned = 0;
};

/// tolerance: relative.
Comparison compare_with_hertz(const CaseCollection& collection, double tolerance);

}  // namespace asperity
