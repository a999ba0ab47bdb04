// What a derivation finds, as numbers with their meaning; each fact is said in words by report/sentences
// alone. SI units.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/cases/motion_mode.h"
#include "dem_compare/derive/length_choice.h"
#include "dem_compare/derive/power_law.h"
#include "dem_compare/numbers/statistics.h"
#include "dem_compare/numbers/uncertain.h"

namespace asperity {

/// What a number is of.
enum class Derived { modulus, normal_stiffness, resistance, stiffness };
/// Where the stiffness of a motion comes from: `solve` probed it without slip; from rolling back in a second
/// pass; slope after the reversal.
enum class StiffnessSource { probe, second_pass, reversal };

/// E* of Hertz fits beside that of the materials [Pa].
struct ModulusFact {
  Uncertain value;
  double materials = 0;
  bool with_offset = false;         ///< of the approach, where bodies are rough
  double attraction = 0;            ///< that the contact bears beside the load [N]
  std::vector<CaseNumber> numbers;  ///< of all cases
};
/// The same as a radius [m].
struct RadiusFact {
  double value = 0, particle = 0;
};
struct ExponentFact {
  Uncertain value;
  bool with_offset = false;
  Uncertain offset;  ///< [m]
};
/// k_n beside 2 E* a [N/m].
struct NormalStiffnessFact {
  PowerLaw law;
  double hertz = 0;
  std::vector<CaseNumber> used;
};
/// A stiffness grows as a^n; n of the law taken.
struct GrowthFact {
  Derived what;
  PowerLaw law;
  double taken = 1;
};
/// Plastic flow makes the first loading another law than all that follow.
struct YieldFact {
  std::size_t yielded = 0, cases = 0;
  double from = 0, largest = 0;  ///< load at which it is first seen [N], plastic volume [m^3]
};
/// Stiffness depends on how fast a contact is pressed.
struct RelaxationFact {
  std::size_t relaxed = 0, cases = 0;
};
/// An elasto-plastic law beside what was solved at one load, each less one.
struct ElastoplasticErrors {
  double load = 0;    ///< the largest of the case [N]
  double misfit = 0;  ///< root mean square of the force over the largest
  double unloading_stiffness = 0, imprint = 0, dissipated = 0;
};
/// An elasto-plastic normal law, fitted to load and unload at the largest load.
struct ElastoplasticFact {
  enum class Law { thornton_ning, luding } law = Law::thornton_ning;
  Uncertain first, second;                  ///< E* and p_y [Pa]; k1 and k_p [N/m]
  double third = 0;                         ///< w [J/m^2]; k_c [N/m]; zero without a pull
  double at_load = 0;                       ///< [N]
  double good_from = 0;                     ///< load from which on the force of loading is within a tenth [N]
  std::vector<ElastoplasticErrors> errors;  ///< of the load it was fitted at, then of smaller loads
  std::vector<CaseNumber> numbers;          ///< of all cases at that load
};
struct PullOffFact {
  Uncertain value;  ///< [N]
};
struct ScatterFact {
  Derived what;
  RealisationScatter scatter;
};
struct MeshFact {
  Derived what;
  DiscretisationError error;
};
/// Mean of the cases of one load; fluctuation along their paths, relative, and blocks that count as
/// independent.
struct MeanResistanceFact {
  const MotionMode* mode;
  double load = 0;
  Uncertain mean;
  int cases = 0;
  double fluctuation = 0, independent = 0;
};
/// The resistance is what is dissipated: the conservative topographic part is not in it.
struct DissipationFact {
  const MotionMode* mode;
};
struct LawFact {
  ResistanceLaw law;
};
struct LengthFact {
  LengthChoice choice;
};
struct MisfitFact {
  double misfit = 0;  ///< relative
  int cases = 0;
};
/// Local friction is an input of the cases: of the effective one, only what departs from it is found.
struct LocalFrictionFact {
  std::string coefficient;
};
struct StiffnessFact {
  const MotionMode* mode;
  StiffnessSource source;
  PowerLaw law;
  std::vector<CaseNumber> used;
};
struct ReversalFact {
  const MotionMode* mode;
  PowerLaw law;
};
/// G* of k_l = 8 G* a beside that of the materials [Pa].
struct ShearModulusFact {
  Uncertain value;
  double materials = 0;
};
/// mu of torsion over that of sliding friction spread as Hertz' pressure (Lubkin 1951).
struct TorsionFact {
  double ratio = 0;
};
using Fact = std::variant<ModulusFact, RadiusFact, ExponentFact, NormalStiffnessFact, GrowthFact, YieldFact,
                          RelaxationFact, ElastoplasticFact, PullOffFact, ScatterFact, MeshFact,
                          MeanResistanceFact, DissipationFact, LawFact, LengthFact, MisfitFact,
                          LocalFrictionFact, StiffnessFact, ReversalFact, ShearModulusFact, TorsionFact>;

/// What the cases cannot tell, each with the cases that would.
struct OpenQuestion {
  enum class About {
    hertz_fit,  ///< no case has enough load steps
    exponent,   ///< of the normal law
    normal_stiffness,
    elastoplastic,  ///< no case that yielded tells an elasto-plastic law
    pull_off,
    growth,   ///< of a stiffness with the load
    scatter,  ///< between realisations
    mesh_error,
    experiment,     ///< no case of this motion
    slip,           ///< cases that did not slip fully
    end_of_change,  ///< number: largest drift
    long_paths,     ///< number: shortest steady path in contact diameters
    offset,
    test_of_law,
    length,
    stiffness,          ///< no case was reversed
    rolling_stiffness,  ///< likewise, nor by enough
    shear_modulus       ///< number: that of the materials [Pa]
  } about;
  Derived what = Derived::resistance;
  const MotionMode* mode = nullptr;
  double number = unknown;
  std::vector<std::string> folders{};
};

/// Where a quantity comes from, in the order in which it is said.
struct Origin {
  enum class From {
    materials,       ///< E* where no case told it
    material_shear,  ///< G* likewise
    hertz_fit,
    hertz_fit_with_offset,
    largest_load,  ///< elastic stiffness there
    yielded,       ///< material did
    thornton_ning_fit,
    luding_fit,
    pull,             ///< number: cases
    attraction,       ///< the entry, where no case was drawn apart
    with_attraction,  ///< number: what the contact bears beside the load [N]
    stiffness,        ///< `source`
    smooth_growth,    ///< number: exponent of a smooth contact
    lateral_stiffness,
    dissipation_per_length,
    dissipation_per_angle,
    steady_resistance,
    cases,        ///< `numbers`: how many, loads, realisations, mesh
    odds,         ///< number: natural logarithm of those for a over r
    other_radii,  ///< of the particle told lambda
    no_offset,
    local_friction,  ///< text: the coefficient
    solver           ///< text: versions
  } from;
  double number = unknown;
  std::string text{};
  std::vector<CaseNumber> numbers{};
  StiffnessSource source = StiffnessSource::probe;
};

}  // namespace asperity
