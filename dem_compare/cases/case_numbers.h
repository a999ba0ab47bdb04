// A number of each of several cases with what tells them apart, and what their comparison says: scatter
// between realisations and error of the mesh, two numbers that are never mixed.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A number of one case, in its unit.
struct CaseNumber {
  double load = 0;           ///< [N]
  std::string realisation;   ///< the same for the same surfaces
  double spacing = 0;        ///< of the interface mesh [m]; NaN if it is not known
  double value = 0, sd = 0;  ///< sd of the case alone
  double shared_sd = 0;      ///< the part of sd that others of the same load share: it does not average out
  bool by_half_spaces = false;  ///< no case was solved: half_space_surfaces.h
};

/// Two loads [N], but for rounding.
bool same_load(double one, double other);
/// Of two meshes [m], but for rounding; two that are not known (NaN) are the same.
bool same_spacing(double one, double other);

/// Relative sample standard deviation between realisations at the same load, pooled over loads.
struct RealisationScatter {
  double relative = 0;
  int realisations = 0;  ///< the most at one load
};
/// Empty where no load was solved for more than one realisation on the same spacing.
std::optional<RealisationScatter> realisation_scatter(const std::vector<CaseNumber>& numbers);

/// One of each load and realisation, all on one mesh: the finest that all of them have. Each on its own
/// finest where they have none in common.
std::vector<std::size_t> on_one_mesh(const std::vector<CaseNumber>& numbers);
std::vector<CaseNumber> counted_of(const std::vector<CaseNumber>& numbers);

/// From the same load and realisation on several spacings (statistics.h), mean over such families.
struct DiscretisationError {
  double relative_error = 0;  ///< of the mesh that counts, see on_one_mesh [-]
  int families = 0;
};
std::optional<DiscretisationError> discretisation_error(const std::vector<CaseNumber>& numbers);

}  // namespace asperity
