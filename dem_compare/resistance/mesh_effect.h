// What a finer mesh makes of a resistance: the same contact, surfaces and motion on two spacings. SI units.
#pragma once

#include <vector>

#include "dem_compare/resistance/moving_study.h"

namespace asperity {

struct MeshEffect {
  const MovingContact* contact = nullptr;
  const MovingState* state = nullptr;
  double coarse = 0, fine = 0;  ///< spacings [m]
  bool counts_fine = false;     ///< whether the study's answers are those on the finer one
  int realisations = 0;         ///< compared, each with itself
  Uncertain ratio;              ///< resistance on the finer mesh over that on the coarser one

  /// By how much of itself the resistance on the counted mesh exceeds that on ever finer ones, were its error
  /// of first order in the spacing (Roache 1994, J. Fluids Eng. 116, 405, with p = 1, the cautious choice).
  Uncertain excess() const;
};

/// For each state that was solved on several spacings: the counted one beside each finer, from the next to
/// the finest; beside the next coarser where it is the finest. Were the error of first order, each pair would
/// tell the same excess.
std::vector<MeshEffect> mesh_effects(const MovingStudy& study);

}  // namespace asperity
