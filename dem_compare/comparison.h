// Rough, yielding contact against Hertz: ratios at each load with their scatter, and the verdict in words.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dem_compare/case_collection.h"
#include "dem_compare/statistics.h"

namespace asperity {

/// Ratios to Hertz at one load of the first loading, over realisations.
struct LoadComparison {
  double force = 0;          ///< [N]
  Scatter force_ratio;       ///< force over Hertz's at the same approach
  Scatter stiffness_ratio;   ///< tangent stiffness over Hertz's at the same load
  Scatter area_ratio;        ///< real contact area over Hertz's at the same load
  Scatter pressure_ratio;    ///< largest pressure over Hertz's at the same load
};

/// Numbers of a group at its largest load.
struct GroupNumbers {
  double force = 0;             ///< [N]
  Hertz hertz;
  Scatter approach;             ///< [m]
  Scatter loading_stiffness;    ///< [N/m]
  Scatter unloading_stiffness;  ///< at the start of unloading [N/m]
  Scatter contact_area;         ///< [m^2]
  Scatter largest_pressure;     ///< [Pa]
  Scatter plastic_volume;       ///< [m^3]
  Scatter residual_imprint;     ///< [m]
  Scatter dissipated_energy;    ///< [J]
  Scatter fitted_radius, fitted_radius_with_offset;  ///< what a Hertz fit would report [m]
  Scatter exponent, exponent_with_offset;
  double differencing_error = 0;  ///< largest relative bound on the loading stiffness from the finite load steps
};

struct GroupComparison {
  std::string label;
  std::vector<std::string> values;
  int realisations = 0;
  double interface_spacing = 0;     ///< [m]
  GroupNumbers numbers;
  std::vector<LoadComparison> loads;
  /// Of the loading stiffness at the largest load, where the same contact was solved on several spacings.
  std::optional<MeshError> mesh;
  /// Load from which on the stiffness stays within the tolerance; NaN if it does not at the largest load.
  double hertzian_from = 0;
  std::string verdict;
};

struct Comparison {
  std::string title;
  double tolerance = 0;
  std::vector<GroupComparison> groups;
  std::vector<MissingCase> missing;
  std::size_t planned = 0;
};

Comparison compare_with_hertz(const CaseCollection& collection, double tolerance);

nlohmann::ordered_json to_json(const Comparison& comparison);
std::string to_markdown(const Comparison& comparison);

/// "0.93 +- 0.02" in `digits` significant digits of the scatter's mean; "-" if it is not known.
std::string plus_minus(const Scatter& scatter, double unit = 1, int digits = 3);

}  // namespace asperity
