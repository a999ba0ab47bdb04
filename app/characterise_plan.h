// Which cases `asperity characterise` solves: the finest mesh, the most loads and realisations that the time
// allows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scanned_surface.h"
#include "core/parameter_file.h"

namespace asperity {

/// How much is solved: rungs of a ladder, each dearer and more accurate than the one before.
struct Rung {
  double cells_per_radius =
      0;             ///< of the smooth contact at the lowest load: contact radius over spacing, at least [-]
  double waves = 0;  ///< roll-off of the spectrum over the shortest wave, at least [-]
  int loads = 1, realisations = 1;
};

/// One way of motion with its entries, solved at each load and for each realisation.
struct PlannedMotion {
  std::string label;            ///< "rolling", "sliding, local friction 0.1"
  Settings settings;            ///< entries of the case file
  int realisations = 1;         ///< those of the rung, or more where the time allows
  int half_space_surfaces = 0;  ///< realisations by half-spaces, which tell what few solved ones do not
};

struct CharacterisePlan {
  Rung rung;
  std::vector<double> loads;  ///< [N]
  double spacing = 0;         ///< of the interface mesh [m]
  double cutoff = 0;          ///< shortest wave of the surfaces [m]
  Settings base;              ///< entries that all cases have
  std::vector<PlannedMotion> motions;
  int cases = 0;
  double seconds = 0;     ///< on two cores, to a factor of two [s]
  bool is_least = false;  ///< the lowest rung
  /// What the next rung would be and take, where there is one [s].
  std::optional<Rung> next;
  double next_seconds = 0;
};

/// The highest rung whose cost fits `request.time`; the lowest where none does (`seconds` then says what it
/// takes). Throws InputError where a case would be refused.
CharacterisePlan plan_of(const CharacteriseRequest& request, const MeasuredScan& substrate,
                         const std::optional<MeasuredScan>& particle);

/// The study file of the plan, for `asperity study`.
std::string study_text(const CharacterisePlan& plan);
/// The motions that half-spaces tell something of, on as many surfaces as they solve, for `asperity study
/// --preview`; empty where there are none. Its cases have the names of the plan's.
std::string preview_text(const CharacterisePlan& plan);

/// What will be done, what will not be known, and how long it takes, in sentences.
std::vector<std::string> plan_sentences(const CharacteriseRequest& request, const CharacterisePlan& plan);

}  // namespace asperity
