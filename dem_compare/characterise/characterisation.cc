#include "dem_compare/characterise/characterisation.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/characterise/mesh_error.h"
#include "results/contact_key.h"

namespace asperity {
namespace {

constexpr double sds_of_95_percent = 1.96;
constexpr const char* friction_entry = "Interface/Friction coefficient";
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool is_stiffness(const std::string& key) {
  return key.find("stiffness") != std::string::npos || key.find("modulus") != std::string::npos;
}

/// A coefficient that follows the local friction of the cases.
bool is_friction(const std::string& key) { return key.find("friction") != std::string::npos; }

/// Half of a 95 % interval over the standard deviation that few realisations scatter by.
double half_width_in_sds(int degrees_of_freedom) {
  if (degrees_of_freedom == 0) return sds_of_95_percent;
  constexpr double upper_end = 0.975;
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), upper_end);
}

/// Loads and realisations of the cases that tell a quantity: as the derivation names them, else all of the
/// motion that tells it.
std::vector<CaseNumber> cases_behind(const ParameterSet& set, const Derivation& derivation,
                                     const QuantityEntry& entry) {
  for (const auto& [member, origins] : derivation.origins)
    for (const Origin& origin : origins)
      if (member == entry.member && origin.from == Origin::From::cases) return counted_of(origin.numbers);
  std::vector<CaseNumber> cases;
  for (const auto& solved : set.cases) {
    if (solved.motion() != motion_named(entry.told_by) || solved.history.size() == 0) continue;
    const auto& forces = solved.history.normal_force;
    cases.push_back({*std::max_element(forces.begin(), forces.end()), realisation_of(solved)});
  }
  return cases;
}

/// Cases beyond the first of each load.
int repeated(const std::vector<CaseNumber>& cases) {
  std::vector<double> loads;
  for (const CaseNumber& one : cases)
    if (std::none_of(loads.begin(), loads.end(), [&](double other) { return same_load(other, one.load); }))
      loads.push_back(one.load);
  return static_cast<int>(cases.size() - loads.size());
}

std::size_t realisations_of(const std::vector<CaseNumber>& cases) {
  std::set<std::string> seen;
  for (const CaseNumber& one : cases) seen.insert(one.realisation);
  return seen.size();
}

bool is_rough(const ParameterSet& set) {
  return std::any_of(set.cases.begin(), set.cases.end(),
                     [](const auto& solved) { return solved.is_rough(); });
}

/// Numbers of the normal cases at the same load, as mean and standard deviation of the mean.
struct Pooled {
  double load = 0, mean = 0, variance_of_mean = not_a_number, mesh_sd = 0;
  std::size_t count = 0;
};

Pooled pooled(double load, const std::vector<EffectiveNumber>& numbers) {
  Pooled result;
  result.load = load, result.count = numbers.size();
  const auto n = static_cast<double>(numbers.size());
  for (const auto& number : numbers) result.mean += number.value / n, result.mesh_sd += number.sd / n;
  if (numbers.size() < 2) return result;
  double squares = 0;
  for (const auto& number : numbers) squares += (number.value - result.mean) * (number.value - result.mean);
  result.variance_of_mean = squares / ((n - 1) * n);
  return result;
}

/// What unloading leaves and costs, load by load.
void add_unloading(const ParameterSet& set, const char* key, const char* meaning, const char* unit,
                   Characterisation& table) {
  std::vector<std::pair<double, std::vector<EffectiveNumber>>> by_load;
  for (const auto& solved : set.cases) {
    const EffectiveNumber number = solved.effective(key);
    if (solved.motion() != Motion::normal || !std::isfinite(number.value) || solved.history.size() == 0)
      continue;
    const auto& forces = solved.history.normal_force;
    const double load = *std::max_element(forces.begin(), forces.end());
    auto found = std::find_if(by_load.begin(), by_load.end(),
                              [&](const auto& entry) { return same_load(entry.first, load); });
    if (found == by_load.end()) found = by_load.insert(found, {load, {}});
    found->second.push_back(number);
  }
  std::sort(by_load.begin(), by_load.end(),
            [](const auto& one, const auto& other) { return one.first < other.first; });
  for (const auto& [load, numbers] : by_load) {
    const Pooled mean = pooled(load, numbers);
    CharacterisedNumber number{key,         meaning, unit, mean.mean, load, std::sqrt(mean.variance_of_mean),
                               mean.mesh_sd};
    number.holds_scatter = mean.count > 1;
    number.degrees_of_freedom = static_cast<int>(mean.count) - 1;
    number.from = "unloading from the largest load, mean of " + std::to_string(mean.count) +
                  (mean.count == 1 ? " case" : " cases");
    table.numbers.push_back(number);
  }
}

}  // namespace

double CharacterisedNumber::half_width() const {
  if (value == 0 || !input_is_known) return not_a_number;
  if (!std::isfinite(fit_sd) && !std::isfinite(mesh_sd) && material_sd == 0) return not_a_number;
  const auto known = [](double sd) { return std::isfinite(sd) ? sd : 0.0; };
  return std::hypot(half_width_in_sds(degrees_of_freedom) * known(fit_sd), sds_of_95_percent * known(mesh_sd),
                    sds_of_95_percent * material_sd);
}

double CharacterisedNumber::relative_half_width() const { return half_width() / std::abs(value); }

Characterisation characterised(const ParameterSet& set, const Derivation& derivation, double modulus_spread,
                               bool friction_is_known) {
  Characterisation table;
  const ContactParameters& parameters = derivation.parameters;
  for (const QuantityEntry& entry : quantity_entries()) {
    const auto& quantity = parameters.*entry.member;
    if (!quantity) {
      if (!entry.needs_yield) table.not_known.emplace_back(entry.key);
      continue;
    }
    CharacterisedNumber number{entry.key,       entry.meaning,     entry.unit,
                               quantity->value, quantity->at_load, quantity->sd};
    if (is_stiffness(entry.key)) number.material_sd = modulus_spread * std::abs(quantity->value);
    const std::vector<CaseNumber> cases = cases_behind(set, derivation, entry);
    number.is_assumed = quantity->value == 0 && !std::isfinite(quantity->sd);
    if (!number.is_assumed) number.mesh_sd = sd_by_mesh(set, derivation, entry, cases);
    number.holds_scatter = !is_rough(set) || realisations_of(cases) > 1;
    if (is_rough(set) && number.holds_scatter) number.degrees_of_freedom = repeated(cases);
    number.from = quantity->provenance;
    if (is_friction(entry.key)) {
      number.local_friction = CaseEntries(set.inputs).quantity(friction_entry, Dimension::none, 0);
      number.input_is_known = friction_is_known;
    }
    table.numbers.push_back(number);
  }
  add_unloading(set, "residual_imprint", "imprint that unloading leaves", "m", table);
  add_unloading(set, "dissipated_energy", "energy that loading and unloading dissipate", "J", table);
  return table;
}

nlohmann::ordered_json to_json(const Characterisation& characterisation) {
  const auto known = [](double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  nlohmann::ordered_json json;
  if (!characterisation.label.empty()) json["label"] = characterisation.label;
  json["numbers"] = nlohmann::ordered_json::array();
  for (const auto& number : characterisation.numbers) {
    const double half = number.half_width();
    json["numbers"].push_back({{"key", number.key},
                               {"meaning", number.meaning},
                               {"value", number.value},
                               {"unit", number.unit},
                               {"at_load", known(number.at_load)},
                               {"interval_95", {known(number.value - half), known(number.value + half)}},
                               {"sd_of_fit_and_realisations", known(number.fit_sd)},
                               {"sd_of_mesh", known(number.mesh_sd)},
                               {"sd_of_materials", known(number.material_sd)},
                               {"holds_scatter_of_surfaces", number.holds_scatter},
                               {"assumed", number.is_assumed},
                               {"local_friction_that_went_in", known(number.local_friction)},
                               {"local_friction_is_known", number.input_is_known},
                               {"from", number.from}});
  }
  json["not_known"] = characterisation.not_known;
  return json;
}

}  // namespace asperity
