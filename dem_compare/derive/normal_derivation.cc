#include "dem_compare/derive/normal_derivation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "dem_compare/cases/half_space_surfaces.h"
#include "dem_compare/derive/elastoplastic_derivation.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using About = OpenQuestion::About;
using From = Origin::From;
using P = ContactParameters;

/// Loading to a smaller load is a part of loading to a larger one: of each realisation and mesh the largest
/// load counts, of equal loads the one with the most steps.
std::vector<const ReducedCase*> largest_loads(const std::vector<ReducedCase>& cases) {
  std::vector<const ReducedCase*> fitted, chosen;
  for (const auto& reduced : cases)
    if (reduced.normal_fit) fitted.push_back(&reduced);
  std::sort(fitted.begin(), fitted.end(), [](const ReducedCase* a, const ReducedCase* b) {
    return same_load(a->largest_force, b->largest_force) ? a->normal_fit->steps > b->normal_fit->steps
                                                         : a->largest_force > b->largest_force;
  });
  for (const ReducedCase* one : fitted)
    if (std::none_of(chosen.begin(), chosen.end(), [&](const ReducedCase* other) {
          return other->realisation == one->realisation && other->spacing == one->spacing;
        }))
      chosen.push_back(one);
  return chosen;
}

/// Mean of moduli, those of half-spaces included: with what these share beside their scatter, and at least as
/// uncertain as the fits that it is made of.
Uncertain mean_of(const std::vector<double>& fitted, double own_sd, const std::vector<CaseNumber>& surfaces) {
  std::vector<double> values = fitted;
  for (const CaseNumber& one : surfaces) values.push_back(one.value);
  const Scatter mean = scatter_of(values);
  const double shared =
      surfaces.empty() ? 0 : surfaces.front().shared_sd / surfaces.front().value * mean.mean;
  return {mean.mean, mean.count > 1 ? std::max(std::hypot(mean.standard_error, shared), own_sd) : own_sd};
}

void derive_modulus(const ReducedCases& cases, Derivation& derivation, LawFindings& findings) {
  const Hertz& hertz = cases.front().hertz;
  EffectiveQuantity& modulus = derivation.parameters.reduced_modulus.emplace();
  std::vector<Origin>& origin = derivation.origin_of(&P::reduced_modulus);
  const std::vector<const ReducedCase*> fitted = largest_loads(cases);
  if (fitted.empty()) {
    modulus.value = hertz.reduced_modulus;
    origin = {{From::materials}};
    findings.open.push_back({About::hertz_fit});
    return;
  }
  std::vector<CaseNumber> all;
  for (const ReducedCase* one : fitted) all.push_back(one->normal_fit->modulus);
  std::vector<double> moduli, radii, exponents, offsets;
  double errors = 0;
  modulus.load_range = fitted.front()->normal_fit->loads;
  const auto used = on_one_mesh(all);
  for (const auto i : used) {
    const NormalFit& fit = *fitted[i]->normal_fit;
    moduli.push_back(fit.modulus.value), radii.push_back(fit.radius.value);
    exponents.push_back(fit.exponent), offsets.push_back(fit.offset);
    errors += fit.modulus.sd * fit.modulus.sd;
    modulus.load_range->low = std::min(modulus.load_range->low, fit.loads.low);
    modulus.load_range->high = std::max(modulus.load_range->high, fit.loads.high);
    findings.details["fits"].push_back({{"folder", fitted[i]->folder()},
                                        {"reduced_modulus", fit.modulus.value},
                                        {"radius", fit.radius.value},
                                        {"exponent", fit.exponent},
                                        {"offset", fit.offset},
                                        {"relative_misfit", fit.misfit}});
  }
  std::vector<SolvedNumber> solved;
  for (const auto i : used) solved.push_back({fitted[i]->solved, all[i].load, all[i].value, all[i].sd});
  const std::vector<CaseNumber> surfaces = by_half_spaces(solved, modulus_by_half_spaces);
  all.insert(all.end(), surfaces.begin(), surfaces.end());
  const Uncertain mean = mean_of(moduli, std::sqrt(errors) / static_cast<double>(used.size()), surfaces);
  modulus.value = mean.value, modulus.sd = mean.sd;
  const bool with_offset = fitted.front()->is_rough;
  origin = {{with_offset ? From::hertz_fit_with_offset : From::hertz_fit}, {From::cases, unknown, "", all}};
  const double attraction = fitted.front()->attraction;
  if (attraction > 0) origin.push_back({From::with_attraction, attraction});
  findings.found.push_back(ModulusFact{mean, hertz.reduced_modulus, with_offset, attraction, all});
  findings.found.push_back(RadiusFact{scatter_of(radii).mean, hertz.radius});
  const Scatter exponent = scatter_of(exponents), offset = scatter_of(offsets);
  if (exponent.count > 0)
    findings.found.push_back(
        ExponentFact{{exponent.mean, exponent.count > 1 ? exponent.standard_error
                                                        : fitted[used.front()]->normal_fit->exponent_error},
                     with_offset,
                     {offset.mean, offset.standard_error}});
  else
    findings.open.push_back({About::exponent});
  find_scatter_and_mesh(all, Derived::modulus, findings);
}

void derive_normal_stiffness(const ReducedSet& set, Derivation& derivation, LawFindings& findings) {
  std::vector<CaseNumber> all;
  for (const auto& reduced : set.cases)
    if (reduced.normal_stiffness) all.push_back(*reduced.normal_stiffness);
  for (const auto& number : set.by_half_spaces.at(normal_stiffness_key)) all.push_back(number);
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
void find_yielding(const ReducedCases& cases, Derivation& derivation, LawFindings& findings) {
  YieldFact fact{0, cases.size(), std::numeric_limits<double>::infinity(), 0};
  for (const auto& reduced : cases) {
    if (!reduced.yields()) continue;
    ++fact.yielded;
    fact.from = std::min(fact.from, reduced.yielded_from);
    fact.largest = std::max(fact.largest, reduced.plastic_volume);
  }
  findings.details["yielded"] = {{"cases", fact.yielded}, {"largest_plastic_volume", fact.largest}};
  if (fact.yielded == 0) return;
  findings.details["yielded"]["from_load"] = fact.from;
  findings.found.push_back(fact);
  for (const auto member : {&P::reduced_modulus, &P::normal_stiffness})
    if (derivation.parameters.*member) derivation.origin_of(member).push_back({From::yielded});
}

/// Of bodies that relax no one stiffness holds for all rates.
void find_relaxation(const ReducedCases& cases, LawFindings& findings) {
  RelaxationFact fact{0, cases.size()};
  for (const auto& reduced : cases) fact.relaxed += reduced.relaxes ? 1 : 0;
  if (fact.relaxed > 0) findings.found.push_back(fact);
}

void derive_pull_off(const ReducedSet& set, Derivation& derivation, LawFindings& findings) {
  std::vector<double> pulls;
  bool adhesive = false;
  LoadRange loads{std::numeric_limits<double>::infinity(), 0};
  for (const auto& reduced : set.cases) {
    adhesive = adhesive || reduced.is_adhesive;
    const double pull = -reduced.smallest_force, largest = reduced.largest_force;
    // Solved to about 1e-6 of the load: smaller pulls are none.
    constexpr double noise_share = 1e-5;
    if (!(pull > noise_share * largest) || !reduced.is_pressed()) continue;
    pulls.push_back(pull);
    loads.low = std::min(loads.low, largest), loads.high = std::max(loads.high, largest);
  }
  // Of a surface that is drawn off from several loads the mean: half-spaces give it the same force each time.
  std::map<std::string, std::vector<double>> of_surface;
  double shared = 0;
  for (const auto& number : set.by_half_spaces.at(pull_off_key)) {
    of_surface[number.realisation].push_back(number.value);
    shared = std::max(shared, number.shared_sd / number.value);
  }
  for (const auto& [surface, values] : of_surface) pulls.push_back(scatter_of(values).mean);
  const double attraction = set.cases.front().solved->attraction_force();
  if (pulls.empty() && attraction > 0) {
    derivation.parameters.pull_off_force.emplace().value = attraction;
    derivation.origin_of(&P::pull_off_force) = {{From::attraction}};
    return findings.found.push_back(PullOffFact{{attraction}});
  }
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

void derive_normal(const ReducedSet& set, Derivation& derivation) {
  LawFindings findings;
  derive_modulus(set.cases, derivation, findings);
  derive_normal_stiffness(set, derivation, findings);
  find_yielding(set.cases, derivation, findings);
  find_relaxation(set.cases, findings);
  derive_elastoplastic(set.cases, derivation, findings);
  derive_pull_off(set, derivation, findings);
  derivation.laws.push_back(std::move(findings));
}

}  // namespace asperity
