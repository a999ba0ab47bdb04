// Lines of a MUSEN job script that set properties of its materials database, after its ScriptAnalyzer (2020)
// and "Example 7 - Modified material parameters": a compound is named by the key that the materials editor
// shows, which is the user's own, so that a placeholder stands for it.
#pragma once

#include <cstddef>
#include <string>

#include "core/printable.h"
#include "engines/text_number.h"

namespace asperity {

/// Placeholder for the key of a compound, counted from 1.
inline std::string musen_key(std::size_t number) { return "KEY_" + std::to_string(number); }

/// Says which compound a placeholder stands for; the name may hold anything.
inline std::string musen_compound(std::size_t number, const std::string& name) {
  return "# " + musen_key(number) + ": put the compound key of " + printable(name) + "\n";
}

/// DENSITY [kg/m^3], YOUNG_MODULUS [Pa] or POISSON_RATIO [-] of a compound.
inline std::string musen_material(const std::string& property, std::size_t number, double value) {
  return "MATERIAL_PROPERTY " + property + " " + musen_key(number) + " " + text_number(value) + "\n";
}

/// SLIDING_FRICTION, ROLLING_FRICTION or RESTITUTION_COEFFICIENT [-] of two compounds.
inline std::string musen_interaction(const std::string& property, std::size_t one, std::size_t other,
                                     double value) {
  return "INTERACTION_PROPERTY " + property + " " + musen_key(one) + " " + musen_key(other) + " " +
         text_number(value) + "\n";
}

}  // namespace asperity
