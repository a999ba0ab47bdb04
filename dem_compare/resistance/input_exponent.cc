#include "dem_compare/resistance/input_exponent.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/quantity.h"
#include "dem_compare/cases/path_averages.h"
#include "dem_compare/resistance/paired_paths.h"

namespace asperity {
namespace {

/// Entries that stand for one input; where several differ, all have the same factor.
struct VariedInput {
  const char* name;
  Dimension dimension;
  std::vector<std::string> entries;
};

const std::vector<VariedInput>& varied_inputs() {
  static const std::vector<VariedInput> list{
      {"local friction", Dimension::none, {"Interface/Friction coefficient"}},
      {"works of adhesion",
       Dimension::surface_energy,
       {"Interface/Work of adhesion", "Interface/Work of adhesion on separation"}},
      {"yield stresses", Dimension::pressure, {"Particle/Yield stress", "Substrate/Yield stress"}}};
  return list;
}

/// One over the other; none where an entry is missing, zero or without bound.
std::optional<double> factor_of(const MovingContact& one, const MovingContact& other,
                                const std::string& entry, Dimension dimension) {
  const auto a = one.inputs.find(entry), b = other.inputs.find(entry);
  if (a == one.inputs.end() || b == other.inputs.end()) return std::nullopt;
  const double x = parse_quantity(a->second, dimension), y = parse_quantity(b->second, dimension);
  if (!(x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y))) return std::nullopt;
  return x / y;
}

/// Factor by which `input`, and nothing else, is larger in one contact than in the other.
std::optional<double> larger_by(const VariedInput& input, const MovingContact& one,
                                const MovingContact& other) {
  const auto differ = differing_inputs(one, other);
  std::optional<double> factor;
  for (const auto& entry : differ) {
    if (std::find(input.entries.begin(), input.entries.end(), entry) == input.entries.end())
      return std::nullopt;
    const auto own = factor_of(one, other, entry, input.dimension);
    constexpr double rounding = 1e-3;
    if (!own || (factor && std::abs(*own / *factor - 1) > rounding)) return std::nullopt;
    factor = own;
  }
  return factor && *factor > 1 ? factor : std::nullopt;
}

Uncertain exponent_of(const MovingState& larger, const MovingState& smaller, double factor,
                      int& realisations) {
  std::vector<Uncertain> exponents;
  for (const auto& one : larger.cases)
    for (const auto& other : smaller.cases) {
      if (!same_realisation(one.seeds, other.seeds)) continue;
      const Uncertain over = paired_ratio(one.first, other.first);
      if (over.value > 0)
        exponents.push_back(
            {std::log(over.value) / std::log(factor), over.sd / over.value / std::log(factor)});
      break;
    }
  realisations = static_cast<int>(exponents.size());
  return mean_of_realisations(exponents);
}

}  // namespace

std::vector<InputExponent> input_exponents(const MovingStudy& study) {
  std::vector<InputExponent> found;
  for (const auto& input : varied_inputs())
    for (const auto& larger : study.contacts)
      for (const auto& smaller : study.contacts) {
        const auto factor = larger_by(input, larger, smaller);
        if (!factor) continue;
        for (const auto& state : larger.states) {
          const MovingState* other = smaller.find(*state.mode, state.load);
          if (!other) continue;
          InputExponent one;
          one.input = input.name;
          one.larger = &larger, one.smaller = &smaller;
          one.mode = state.mode, one.load = state.load, one.factor = *factor;
          one.exponent = exponent_of(state, *other, *factor, one.realisations);
          if (one.realisations > 0) found.push_back(one);
        }
      }
  return found;
}

}  // namespace asperity
