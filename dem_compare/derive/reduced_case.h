// What a parameter set tells a derivation: the history of each solved case reduced to numbers, once. Every
// law is derived from these numbers; no derivation reads a history or a file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/cases/half_space_surfaces.h"
#include "dem_compare/cases/motion_mode.h"
#include "dem_compare/cases/moving_case.h"
#include "dem_compare/cases/parameter_sets.h"
#include "dem_compare/derive/elastoplastic_fit.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {

/// Names in `effective` of result.json, as stiffness_key of MotionMode.
inline constexpr const char *normal_stiffness_key = "normal_stiffness", *pull_off_key = "pull_off_force";

/// Hertz fits of a case's first loading.
struct NormalFit {
  CaseNumber modulus, radius;  ///< E* for the radius given [Pa], R for the moduli given [m]
  double exponent = unknown, exponent_error = unknown;  ///< [-]; 3/2 of Hertz
  double offset = 0;                                    ///< of the approach [m]
  double misfit = 0;                                    ///< root mean square over the largest force [-]
  LoadRange loads;
  std::size_t steps = 0;
};

struct ReducedCase {
  const SolvedCase* solved = nullptr;
  Motion motion = Motion::normal;
  Hertz hertz;
  bool is_rough = false;
  bool relaxes = false;      ///< its bodies do with time
  bool is_adhesive = false;  ///< it attracts by more than a force that does not change
  std::string realisation;
  double spacing = unknown;  ///< of the interface mesh [m]
  /// What the contact bears beside the load, as one force [N]: `Interface/Attraction force`, and of a smooth
  /// contact that adheres the constant with which Hertz fits its loading best, F = K delta^(3/2) - F0
  /// (Derjaguin, Muller & Toporov 1975). A rough one's cannot be told from the offset of its approach.
  double attraction = 0;
  double largest_force = 0, smallest_force = 0;  ///< normal; a pull is negative [N]
  double yielded_from = unknown;  ///< normal force at the first plastic flow [N]; NaN without one
  double plastic_volume = 0;      ///< largest [m^3]

  std::optional<NormalFit> normal_fit;  ///< empty where no Hertzian curve describes the first loading
  /// Elastic, at the largest load, as `solve` measured it; else the start of the unloading [N/m].
  std::optional<CaseNumber> normal_stiffness;
  std::optional<LoadUnload> yielded;  ///< first loading and unloading of a pressed case that yielded
  std::optional<MovingCase> moving;   ///< of a case that slid, rolled or spun
  std::vector<std::string> doubts;    ///< why its numbers may be off, in words

  std::string folder() const { return solved->folder.string(); }
  bool yields() const { return plastic_volume > 0; }
  bool is_pressed() const { return motion == Motion::normal && !solved->history.normal_force.empty(); }
  /// A number at the largest load, as one of several cases.
  /// In the unit of the value.
  CaseNumber number(double value, double sd) const {
    return {largest_force, realisation, spacing, value, sd};
  }
  /// The same as `solve` states it under `effective`; NaN where it does not.
  CaseNumber effective(const char* name) const;
};

using ReducedCases = std::vector<ReducedCase>;

/// A parameter set, reduced.
struct ReducedSet {
  ContactInputs inputs;  ///< what all cases agree in
  ReducedCases cases;    ///< they point to those of the parameter set
  /// By their name in `effective`: numbers of surfaces that half-spaces alone have pressed.
  std::map<std::string, std::vector<CaseNumber>> by_half_spaces;
};
/// `set` must outlive the result. Throws InputError for a previews.json beside a case that cannot be read.
ReducedSet reduced_set(const ParameterSet& set);

}  // namespace asperity
