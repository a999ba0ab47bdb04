// The mechanics of a recording's simulation with effects of given values.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "diagnosis/catalogue/effect.h"
#include "diagnosis/mechanics/mechanics.h"

namespace asperity::test {

/// friction: of sliding, rolling and torsion [-].
inline Mechanics with(const Experiment& e,
                      const std::vector<std::pair<std::string, std::vector<double>>>& effects,
                      double friction = 0.2) {
  SimulationChoice choice;
  for (const auto& name : {"sliding_friction", "rolling_friction", "torsion_friction"})
    choice.parameters[name] = {friction, true};
  Mechanics m = baseline_mechanics(e, choice);
  for (const auto& [id, values] : effects) effect_of(id).assemble(m, values.data());
  return m;
}

}  // namespace asperity::test
