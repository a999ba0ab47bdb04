// Elasto-plastic, adhesive normal laws from one load and unload of a contact that has yielded: Thornton &
// Ning (1998) with E* and p_y free, Luding (2008) with k1 and k_p free; least squares in force over both
// branches. SI units.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/hertz.h"
#include "dem_compare/laws/luding.h"
#include "dem_compare/laws/normal_law.h"
#include "dem_compare/laws/thornton_ning.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

/// First loading of a contact and the unloading behind it.
struct LoadUnload {
  std::vector<double> approach;  ///< [m]
  std::vector<double> force;     ///< [N]
  std::size_t loading = 0;       ///< so many steps of loading come first; the last has the largest load

  /// At the turning point [N], [m].
  double largest_force() const { return force.at(loading - 1); }
  double largest_approach() const { return approach.at(loading - 1); }
  /// Largest pull of the unloading [N]; zero where there is none.
  double pull_off() const;
};

/// What counts in a particle simulation, of the solved curve or of a law.
struct ElastoplasticNumbers {
  double unloading_stiffness = 0;  ///< where unloading starts [N/m]
  double imprint = 0;              ///< approach that has not come back where the force vanishes [m]
  double dissipated = 0;           ///< work of the path from first to last step [J]
};

/// How well a law describes the curve.
struct ElastoplasticQuality {
  double misfit = 0;  ///< root mean square of the force over the largest force [-]
  ElastoplasticNumbers solved, law;
  /// Loads of the first loading from which on, up to the largest, the law's force is within a tenth; empty
  /// where it is not even there.
  std::optional<LoadRange> good;
};

template <class Law>
struct ElastoplasticFit {
  Law law;
  double offset = 0;  ///< of the approach: asperities touch before the spheres would [m]
  /// Standard errors of E* [Pa] and p_y [Pa], or k1 and k_p [N/m].
  double first_sd = 0, second_sd = 0;
  ElastoplasticQuality quality;
};

/// `start`: the bodies, smooth and elastic. `with_offset`: of rough bodies. Empty where the curve does not
/// tell the parameters: no yield, fewer than four steps of loading or three of unloading.
std::optional<ElastoplasticFit<ThorntonNing>> fit_thornton_ning(const LoadUnload& curve, const Hertz& start,
                                                                bool with_offset);
std::optional<ElastoplasticFit<Luding>> fit_luding(const LoadUnload& curve, double radius, bool with_offset);

/// Forces of a law along the curve's approaches less `offset` [N].
std::vector<double> forces_along(const NormalLaw& law, const LoadUnload& curve, double offset);
ElastoplasticQuality quality_of(const NormalLaw& law, const LoadUnload& curve, double offset);
/// From forces along the curve's approaches.
ElastoplasticNumbers numbers_of(const LoadUnload& curve, const std::vector<double>& force);

}  // namespace asperity
