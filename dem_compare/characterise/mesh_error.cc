#include "dem_compare/characterise/mesh_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "dem_compare/derive/resistance_law.h"

namespace asperity {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// The number of result.json that a quantity of parameters.json rests on, and the power of it in that.
struct RestsOn {
  const char* quantity;
  const char* effective;
  double power = 1;
};
constexpr RestsOn rests_on[] = {
    {"reduced_modulus", "approach", 1.5},       {"reduced_shear_modulus", "lateral_stiffness"},
    {"normal_stiffness", "normal_stiffness"},   {"lateral_stiffness", "lateral_stiffness"},
    {"torsion_stiffness", "torsion_stiffness"}, {"sliding_friction", "sliding_friction"},
    {"sliding_offset", "sliding_friction"},     {"torsion_friction", "torsion_moment"},
    {"torsion_offset", "torsion_moment"},       {"rolling_friction", "rolling_dissipation"},
    {"rolling_offset", "rolling_dissipation"},  {"pull_off_force", "pull_off_force"}};

/// Relative discretisation error of a number at one load, mean of its cases.
struct ErrorAtLoad {
  double load, relative;
  int cases;
};

double largest_load(const SolvedCase& solved) {
  const auto& forces = solved.history.normal_force;
  return forces.empty() ? 0 : *std::max_element(forces.begin(), forces.end());
}

std::vector<ErrorAtLoad> errors_by_load(const ParameterSet& set, Motion motion, const char* effective) {
  std::vector<ErrorAtLoad> errors;
  for (const auto& solved : set.cases) {
    const EffectiveNumber number = solved.effective(effective);
    if (solved.motion() != motion || !std::isfinite(number.sd) || number.value == 0) continue;
    const double load = largest_load(solved);
    auto found = std::find_if(errors.begin(), errors.end(),
                              [&](const ErrorAtLoad& error) { return same_load(error.load, load); });
    if (found == errors.end()) found = errors.insert(found, {load, 0, 0});
    found->relative += number.sd / std::abs(number.value);
    ++found->cases;
  }
  for (ErrorAtLoad& error : errors) error.relative /= error.cases;
  return errors;
}

/// Mean over all cases of some loads.
double mean_error(const std::vector<ErrorAtLoad>& errors, const std::vector<CaseNumber>& behind) {
  double sum = 0, count = 0;
  for (const ErrorAtLoad& error : errors) {
    const bool is_behind = std::any_of(
        behind.begin(), behind.end(), [&](const CaseNumber& one) { return same_load(one.load, error.load); });
    if (is_behind || behind.empty()) sum += error.cases * error.relative, count += error.cases;
  }
  return count > 0 ? sum / count : not_known;
}

const LawFindings* findings_of(const Derivation& derivation, Motion motion) {
  for (const LawFindings& findings : derivation.laws)
    if (findings.mode && findings.motion() == motion && !findings.points.empty()) return &findings;
  return nullptr;
}

/// Of the load that is nearest: a mean along a path is not exactly the load that was asked for.
const ErrorAtLoad& nearest(const std::vector<ErrorAtLoad>& errors, double load) {
  return *std::min_element(errors.begin(), errors.end(), [&](const ErrorAtLoad& a, const ErrorAtLoad& b) {
    return std::abs(std::log(a.load / load)) < std::abs(std::log(b.load / load));
  });
}

/// Coefficient and offset where the resistances are off by their errors, at one load or at all (null).
struct Coefficients {
  double friction, offset;
};
Coefficients refitted(std::vector<ResistancePoint> points, LengthScale scale,
                      const std::vector<ErrorAtLoad>& errors, const ErrorAtLoad* only_at) {
  for (ResistancePoint& point : points) {
    const ErrorAtLoad& error = nearest(errors, point.load);
    if (!only_at || only_at == &error) point.value *= 1 + error.relative, point.sd *= 1 + error.relative;
  }
  const ResistanceLaw law = fit_resistance(points, scale);
  return {law.coefficient, law.offset};
}

double sd_of_law(const LawFindings& findings, const ContactParameters& parameters,
                 const std::vector<ErrorAtLoad>& errors, bool is_offset) {
  if (errors.empty()) return not_known;
  const LengthScale scale = (parameters.*findings.mode->friction)->length_scale;
  const auto of = [&](const Coefficients& law) { return is_offset ? law.offset : law.friction; };
  const ResistanceLaw law = fit_resistance(findings.points, scale);
  const double fitted = of({law.coefficient, law.offset}),
               together = of(refitted(findings.points, scale, errors, nullptr)) - fitted;
  double squares = 0;
  for (const ErrorAtLoad& error : errors)
    squares += std::pow(of(refitted(findings.points, scale, errors, &error)) - fitted, 2);
  return std::max(std::abs(together), std::sqrt(squares));
}

}  // namespace

double sd_by_mesh(const ParameterSet& set, const Derivation& derivation, const QuantityEntry& entry,
                  const std::vector<CaseNumber>& behind) {
  const std::string key = entry.key;
  const auto found = std::find_if(std::begin(rests_on), std::end(rests_on),
                                  [&](const RestsOn& one) { return key == one.quantity; });
  if (found == std::end(rests_on)) return not_known;
  const Motion motion = motion_named(entry.told_by).value();
  const std::vector<ErrorAtLoad> errors = errors_by_load(set, motion, found->effective);
  const ContactParameters& parameters = derivation.parameters;
  const LawFindings* findings = findings_of(derivation, motion);
  const bool is_of_law =
      findings && (entry.member == findings->mode->friction || entry.member == findings->mode->offset);
  if (is_of_law) return sd_of_law(*findings, parameters, errors, entry.member == findings->mode->offset);
  return found->power * mean_error(errors, behind) * std::abs((parameters.*entry.member)->value);
}

}  // namespace asperity
