#include "dem_compare/derive/normal_derivation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.h"
#include "dem_compare/cases/half_space_surfaces.h"
#include "dem_compare/cases/normal_numbers.h"
#include "dem_compare/derive/elastoplastic_derivation.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using About = OpenQuestion::About;
using From = Origin::From;
using P = ContactParameters;

/// Hertz fits of one case's first loading.
struct NormalFit {
  const SolvedCase* solved = nullptr;
  CaseNumber modulus, radius;  ///< E* for the radius given, R for the moduli given
  double exponent = unknown, exponent_error = unknown, offset = 0, misfit = 0;
  LoadRange loads;
  std::size_t steps = 0;
};

std::optional<NormalFit> fit_of(const SolvedCase& solved) {
  const Hertz hertz = solved.hertz();
  const NormalNumbers numbers = normal_numbers(solved.history, hertz);
  std::vector<double> approach, force;
  for (const auto& point : numbers.loads) approach.push_back(point.approach), force.push_back(point.force);
  // Asperities touch before the spheres would: only an offset gives back the stiffness of a rough contact.
  const bool with_offset = solved.is_rough();
  const std::size_t fewest = with_offset ? 4 : 3;
  if (force.size() < fewest) return std::nullopt;
  NormalFit fit;
  fit.solved = &solved;
  try {
    const RadiusFit radius = fit_radius(approach, force, hertz.reduced_modulus, with_offset);
    const double ratio = radius.radius.value / hertz.radius;
    const CaseNumber common{numbers.largest_force, realisation_of(solved), solved.interface_spacing(), 0, 0};
    fit.radius = fit.modulus = common;
    fit.radius.value = radius.radius.value;
    fit.radius.sd = radius.radius.standard_error;
    fit.modulus.value = hertz.reduced_modulus * std::sqrt(ratio);
    fit.modulus.sd = fit.modulus.value * radius.radius.standard_error / (2 * radius.radius.value);
    fit.offset = radius.offset.value;
    fit.misfit = radius.relative_rms;
  } catch (const WorkError&) {
    return std::nullopt;  // no Hertzian curve describes it; the caller says which cases were fitted
  }
  if (numbers.has_fits) {
    const ExponentFit& exponent = with_offset ? numbers.exponent_with_offset : numbers.exponent;
    fit.exponent = exponent.exponent.value;
    fit.exponent_error = exponent.exponent.standard_error;
  }
  fit.loads = {*std::min_element(force.begin(), force.end()), *std::max_element(force.begin(), force.end())};
  fit.steps = force.size();
  return fit;
}

/// Loading to a smaller load is a part of loading to a larger one: of each realisation and mesh the largest
/// load counts, of equal loads the one with the most steps.
std::vector<NormalFit> largest_loads(std::vector<NormalFit> fits) {
  std::sort(fits.begin(), fits.end(), [](const NormalFit& a, const NormalFit& b) {
    return same_load(a.modulus.load, b.modulus.load) ? a.steps > b.steps : a.modulus.load > b.modulus.load;
  });
  std::vector<NormalFit> chosen;
  for (const auto& fit : fits)
    if (std::none_of(chosen.begin(), chosen.end(), [&](const NormalFit& other) {
          return other.modulus.realisation == fit.modulus.realisation &&
                 other.modulus.spacing == fit.modulus.spacing;
        }))
      chosen.push_back(fit);
  return chosen;
}

/// Elastic stiffness at the largest load of a case, as `solve` measured it; else the start of its unloading.
std::optional<CaseNumber> stiffness_of(const SolvedCase& solved) {
  const NormalNumbers numbers = normal_numbers(solved.history, solved.hertz());
  CaseNumber number{numbers.largest_force, realisation_of(solved), solved.interface_spacing(), unknown,
                    unknown};
  if (solved.finished() && solved.result->has("normal_stiffness")) {
    const EffectiveNumber stiffness = solved.effective("normal_stiffness");
    number.value = stiffness.value, number.sd = stiffness.sd;
  } else {
    number.value = numbers.unloading_stiffness();
    if (!numbers.unloading.empty()) number.sd = numbers.unloading.front().error;
  }
  return number.value > 0 ? std::optional(number) : std::nullopt;
}

/// A mean that is at least as uncertain as what it is made of.
Uncertain mean_of(const std::vector<double>& values, double own_sd) {
  const Scatter mean = scatter_of(values);
  return {mean.mean, mean.count > 1 ? std::max(mean.standard_error, own_sd) : own_sd};
}

void derive_modulus(const ParameterSet& set, Derivation& derivation, LawFindings& findings) {
  const Hertz hertz = set.cases.front().hertz();
  EffectiveQuantity& modulus = derivation.parameters.reduced_modulus.emplace();
  std::vector<Origin>& origin = derivation.origin_of(&P::reduced_modulus);
  std::vector<NormalFit> fits;
  for (const auto& solved : set.cases)
    if (const auto fit = fit_of(solved)) fits.push_back(*fit);
  fits = largest_loads(fits);
  if (fits.empty()) {
    modulus.value = hertz.reduced_modulus;
    origin = {{From::materials}};
    findings.open.push_back({About::hertz_fit});
    return;
  }
  std::vector<CaseNumber> all;
  for (const auto& fit : fits) all.push_back(fit.modulus);
  std::vector<double> moduli, radii, exponents, offsets;
  double errors = 0;
  modulus.load_range = fits.front().loads;
  const auto used = on_one_mesh(all);
  for (const auto i : used) {
    const NormalFit& fit = fits[i];
    moduli.push_back(fit.modulus.value), radii.push_back(fit.radius.value);
    exponents.push_back(fit.exponent), offsets.push_back(fit.offset);
    errors += fit.modulus.sd * fit.modulus.sd;
    modulus.load_range->low = std::min(modulus.load_range->low, fit.loads.low);
    modulus.load_range->high = std::max(modulus.load_range->high, fit.loads.high);
    findings.details["fits"].push_back({{"folder", fit.solved->folder.string()},
                                        {"reduced_modulus", fit.modulus.value},
                                        {"radius", fit.radius.value},
                                        {"exponent", fit.exponent},
                                        {"offset", fit.offset},
                                        {"relative_misfit", fit.misfit}});
  }
  const Uncertain mean = mean_of(moduli, std::sqrt(errors) / static_cast<double>(used.size()));
  modulus.value = mean.value, modulus.sd = mean.sd;
  const bool with_offset = fits.front().solved->is_rough();
  origin = {{with_offset ? From::hertz_fit_with_offset : From::hertz_fit}, {From::cases, unknown, "", all}};
  findings.found.push_back(ModulusFact{mean, hertz.reduced_modulus, with_offset, all});
  findings.found.push_back(RadiusFact{scatter_of(radii).mean, hertz.radius});
  const Scatter exponent = scatter_of(exponents), offset = scatter_of(offsets);
  if (exponent.count > 0)
    findings.found.push_back(ExponentFact{
        {exponent.mean, exponent.count > 1 ? exponent.standard_error : fits[used.front()].exponent_error},
        with_offset,
        {offset.mean, offset.standard_error}});
  else
    findings.open.push_back({About::exponent});
  find_scatter_and_mesh(all, Derived::modulus, findings);
}

void derive_normal_stiffness(const ParameterSet& set, Derivation& derivation, LawFindings& findings) {
  std::vector<CaseNumber> all;
  for (const auto& solved : set.cases)
    if (const auto number = stiffness_of(solved)) all.push_back(*number);
  for (const auto& number : by_half_spaces(set, "normal_stiffness")) all.push_back(number);
  if (all.empty()) return findings.open.push_back({About::normal_stiffness});
  P& parameters = derivation.parameters;
  const std::vector<CaseNumber> used = counted_of(all);
  const PowerLaw law = fit_power(used, [&](double load) { return parameters.contact_radius(load); });
  parameters.normal_stiffness =
      EffectiveQuantity{law.value, law.sd, law.loads, LengthScale::contact_radius, law.at_load};
  derivation.origin_of(&P::normal_stiffness) = {{From::largest_load}, {From::cases, unknown, "", all}};
  const double hertz = 2 * parameters.reduced_modulus->value * parameters.contact_radius(law.at_load);
  findings.found.push_back(NormalStiffnessFact{law, hertz, used});
  for (const auto& number : used)
    findings.details["stiffness"].push_back(
        {{"load", number.load}, {"value", number.value}, {"realisation", number.realisation}});
  find_growth(law, 1, Derived::normal_stiffness, findings);
}

/// Plastic flow makes the first loading another law than all that follow: it must not go unsaid.
void find_yielding(const ParameterSet& set, Derivation& derivation, LawFindings& findings) {
  YieldFact fact{0, set.cases.size(), std::numeric_limits<double>::infinity(), 0};
  for (const auto& solved : set.cases) {
    const History& history = solved.history;
    bool here = false;
    for (std::size_t i = 0; i < history.size(); ++i) {
      if (!(history.plastic_volume[i] > 0)) continue;
      if (!here) fact.from = std::min(fact.from, history.normal_force[i]);
      here = true;
      fact.largest = std::max(fact.largest, history.plastic_volume[i]);
    }
    fact.yielded += here;
  }
  findings.details["yielded"] = {{"cases", fact.yielded}, {"largest_plastic_volume", fact.largest}};
  if (fact.yielded == 0) return;
  findings.details["yielded"]["from_load"] = fact.from;
  findings.found.push_back(fact);
  for (const auto member : {&P::reduced_modulus, &P::normal_stiffness})
    if (derivation.parameters.*member) derivation.origin_of(member).push_back({From::yielded});
}

void derive_pull_off(const ParameterSet& set, Derivation& derivation, LawFindings& findings) {
  std::vector<double> pulls;
  bool adhesive = false;
  LoadRange loads{std::numeric_limits<double>::infinity(), 0};
  for (const auto& solved : set.cases) {
    const auto& force = solved.history.normal_force;
    adhesive =
        adhesive || solved.entries.quantity("Interface/Work of adhesion", Dimension::surface_energy, 0) > 0;
    const double least = *std::min_element(force.begin(), force.end()),
                 largest = *std::max_element(force.begin(), force.end());
    // Solved to about 1e-6 of the load: smaller pulls are none.
    constexpr double noise_share = 1e-5;
    if (!(-least > noise_share * largest) || solved.motion() != Motion::normal) continue;
    pulls.push_back(-least);
    loads.low = std::min(loads.low, largest), loads.high = std::max(loads.high, largest);
  }
  // Of a surface that is drawn off from several loads the mean: half-spaces give it the same force each time.
  std::map<std::string, std::vector<double>> of_surface;
  double shared = 0;
  for (const auto& number : by_half_spaces(set, "pull_off_force")) {
    of_surface[number.realisation].push_back(number.value);
    shared = std::max(shared, number.shared_sd / number.value);
  }
  for (const auto& [surface, values] : of_surface) pulls.push_back(scatter_of(values).mean);
  if (pulls.empty()) {
    if (adhesive) findings.open.push_back({About::pull_off});
    return;
  }
  const Scatter pull = scatter_of(pulls);
  const double sd = std::hypot(pull.standard_error, shared * pull.mean);
  derivation.parameters.pull_off_force = EffectiveQuantity{pull.mean, sd, loads};
  derivation.origin_of(&P::pull_off_force) = {{From::pull, static_cast<double>(pull.count)}};
  findings.found.push_back(PullOffFact{{pull.mean, sd}});
}

}  // namespace

void derive_normal(const ParameterSet& set, Derivation& derivation) {
  LawFindings findings;
  derive_modulus(set, derivation, findings);
  derive_normal_stiffness(set, derivation, findings);
  find_yielding(set, derivation, findings);
  derive_elastoplastic(set, derivation, findings);
  derive_pull_off(set, derivation, findings);
  derivation.laws.push_back(std::move(findings));
}

}  // namespace asperity
