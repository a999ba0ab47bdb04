#include "dem_compare/derive/normal_derivation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/printed.h"
#include "dem_compare/cases/normal_numbers.h"
#include "dem_compare/derive/power_law.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

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

void derive_modulus(const ParameterSet& set, ContactParameters& parameters, LawReport& report) {
  const Hertz hertz = set.cases.front().hertz();
  std::vector<NormalFit> fits;
  for (const auto& solved : set.cases)
    if (const auto fit = fit_of(solved)) fits.push_back(*fit);
  fits = largest_loads(fits);
  EffectiveQuantity modulus;
  if (fits.empty()) {
    modulus.value = hertz.reduced_modulus;
    modulus.provenance = "of the materials (Hertz 1882): no case has enough load steps for a fit";
    report.not_identifiable.push_back(
        "E* of the contact: no case has the three load steps (four if rough) that a Hertz fit needs; the "
        "materials' own value is written. Set Experiment/Load steps to 10");
  } else {
    std::vector<CaseNumber> all;
    for (const auto& fit : fits) all.push_back(fit.modulus);
    std::vector<double> moduli, radii, exponents, offsets;
    double errors = 0;
    modulus.load_range = fits.front().loads;
    const auto used = on_one_mesh(all);
    for (const auto i : used) {
      moduli.push_back(fits[i].modulus.value), radii.push_back(fits[i].radius.value);
      exponents.push_back(fits[i].exponent), offsets.push_back(fits[i].offset);
      errors += fits[i].modulus.sd * fits[i].modulus.sd;
      modulus.load_range->low = std::min(modulus.load_range->low, fits[i].loads.low);
      modulus.load_range->high = std::max(modulus.load_range->high, fits[i].loads.high);
      report.details["fits"].push_back({{"folder", fits[i].solved->folder.string()},
                                        {"reduced_modulus", fits[i].modulus.value},
                                        {"radius", fits[i].radius.value},
                                        {"exponent", fits[i].exponent},
                                        {"offset", fits[i].offset},
                                        {"relative_misfit", fits[i].misfit}});
    }
    const Scatter mean = scatter_of(moduli);
    const double of_fits = std::sqrt(errors) / static_cast<double>(used.size());
    modulus.value = mean.mean;
    modulus.sd = mean.count > 1 ? std::max(mean.standard_error, of_fits) : of_fits;
    modulus.provenance = std::string("Hertz fit of the first loading") +
                         (fits.front().solved->is_rough() ? " with an offset of the approach" : "") + "; " +
                         source_of(all);
    report.findings.push_back(
        "E* = " + with_error(modulus.value, modulus.sd, Dimension::pressure) + " (materials: " +
        format_quantity(hertz.reduced_modulus, Dimension::pressure, 4) + "), " + modulus.provenance);
    report.findings.push_back("the same as a radius: R_effective = " +
                              with_error(scatter_of(radii).mean, unknown, Dimension::length) +
                              " (particle: " + format_quantity(hertz.radius, Dimension::length) +
                              ") with the materials' E*");
    const Scatter exponent = scatter_of(exponents);
    if (exponent.count > 0)
      report.findings.push_back(
          "exponent of the load over the approach: " +
          with_error(exponent.mean,
                     exponent.count > 1 ? exponent.standard_error : fits[used.front()].exponent_error, "") +
          " (Hertz: 1.5)" +
          (fits.front().solved->is_rough()
               ? ", offset " + with_error(scatter_of(offsets).mean, scatter_of(offsets).standard_error,
                                          Dimension::length)
               : ""));
    else
      report.not_identifiable.push_back(
          "exponent of the normal law: it takes five load steps; set Experiment/Load steps to 10");
    tell_scatter_and_mesh(all, "E*", report);
  }
  parameters.reduced_modulus = modulus;
}

void derive_normal_stiffness(const ParameterSet& set, ContactParameters& parameters, LawReport& report) {
  std::vector<CaseNumber> all;
  for (const auto& solved : set.cases)
    if (const auto number = stiffness_of(solved)) all.push_back(*number);
  if (all.empty()) {
    report.not_identifiable.push_back(
        "k_n: no case has a stiffness at its largest load; set Experiment/Unload = true");
    return;
  }
  const std::vector<CaseNumber> used = counted_of(all);
  const PowerLaw law = fit_power(used, [&](double load) { return parameters.contact_radius(load); });
  parameters.normal_stiffness =
      EffectiveQuantity{law.value,   law.sd,
                        law.loads,   LengthScale::contact_radius,
                        law.at_load, "elastic stiffness at the largest load; " + source_of(all)};
  report.findings.push_back(
      "k_n = " + with_error(law.value, law.sd, Dimension::stiffness) + " at " +
      format_quantity(law.at_load, Dimension::force) + ", growing with a (2 E* a: " +
      format_quantity(2 * parameters.reduced_modulus->value * parameters.contact_radius(law.at_load),
                      Dimension::stiffness) +
      "); " + extent_of(used));
  for (const auto& number : used)
    report.details["stiffness"].push_back(
        {{"load", number.load}, {"value", number.value}, {"realisation", number.realisation}});
  tell_exponent(law, 1, "k_n", report);
}

/// Plastic flow makes the first loading another law than all that follow: it must not go unsaid.
void tell_yielding(const ParameterSet& set, ContactParameters& parameters, LawReport& report) {
  double largest = 0, from = std::numeric_limits<double>::infinity();
  int yielded = 0;
  for (const auto& solved : set.cases) {
    const History& history = solved.history;
    bool here = false;
    for (std::size_t i = 0; i < history.size(); ++i) {
      if (!(history.plastic_volume[i] > 0)) continue;
      if (!here) from = std::min(from, history.normal_force[i]);
      here = true;
      largest = std::max(largest, history.plastic_volume[i]);
    }
    yielded += here;
  }
  report.details["yielded"] = {{"cases", yielded}, {"largest_plastic_volume", largest}};
  if (yielded == 0) return;
  report.details["yielded"]["from_load"] = from;
  constexpr double um3 = 1e-18;
  report.findings.push_back("material yielded in " + std::to_string(yielded) + " of " +
                            std::to_string(set.cases.size()) + " cases, seen first at " +
                            format_quantity(from, Dimension::force) + " (plastic volume up to " +
                            printed("%.2g um^3", largest / um3) +
                            "): E* and its exponent are those of the first loading; unloading and reloading "
                            "are stiffer, and k_n is theirs");
  for (auto* quantity : {&parameters.reduced_modulus, &parameters.normal_stiffness})
    if (*quantity) (*quantity)->provenance += "; material yielded";
}

void derive_pull_off(const ParameterSet& set, ContactParameters& parameters, LawReport& report) {
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
  if (pulls.empty()) {
    if (adhesive)
      report.not_identifiable.push_back(
          "pull-off force: no case of experiment normal was drawn apart; set Experiment/Unload = true");
    return;
  }
  const Scatter pull = scatter_of(pulls);
  parameters.pull_off_force =
      EffectiveQuantity{pull.mean,
                        pull.standard_error,
                        loads,
                        LengthScale::none,
                        unknown,
                        "largest pull while unloading; the loads are those reached before, " +
                            std::to_string(pull.count) + " cases"};
  report.findings.push_back("pull-off force " + with_error(pull.mean, pull.standard_error, Dimension::force));
}

}  // namespace

LawReport derive_normal(const ParameterSet& set, ContactParameters& parameters) {
  LawReport report;
  report.title = "Normal";
  derive_modulus(set, parameters, report);
  derive_normal_stiffness(set, parameters, report);
  tell_yielding(set, parameters, report);
  derive_pull_off(set, parameters, report);
  return report;
}

}  // namespace asperity
