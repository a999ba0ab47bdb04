#include "dem_compare/derive/elastoplastic_derivation.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/derive/elastoplastic_fit.h"

namespace asperity {
namespace {

using About = OpenQuestion::About;
using From = Origin::From;
using P = ContactParameters;

/// The fits of one law to all cases at the largest load.
template <class Law>
struct Fits {
  std::vector<ElastoplasticFit<Law>> fits;
  std::vector<CaseNumber> numbers;  ///< of the second parameter

  void add(const ReducedCase& reduced, const std::optional<ElastoplasticFit<Law>>& fit, double Law::*second) {
    if (!fit) return;
    fits.push_back(*fit);
    numbers.push_back({reduced.yielded->largest_force(), reduced.realisation, reduced.spacing,
                       fit->law.*second, fit->second_sd});
  }
  /// Keeps one of each realisation, on one mesh.
  void count_once() {
    std::vector<ElastoplasticFit<Law>> counted;
    for (const std::size_t i : on_one_mesh(numbers)) counted.push_back(fits[i]);
    fits = counted;
  }
  /// Mean of a parameter with the larger of the scatter's and the fits' own error.
  Uncertain mean(double Law::*parameter, double ElastoplasticFit<Law>::*sd) const {
    std::vector<double> values;
    double squares = 0;
    for (const auto& fit : fits) {
      values.push_back(fit.law.*parameter);
      if (sd) squares += fit.*sd * fit.*sd;
    }
    const Scatter scatter = scatter_of(values);
    const double own = sd ? std::sqrt(squares) / static_cast<double>(values.size()) : unknown;
    return {scatter.mean,
            scatter.count > 1 && !(own > scatter.standard_error) ? scatter.standard_error : own};
  }
};

/// The law's numbers over the solved ones, less one.
ElastoplasticErrors errors_of(const ElastoplasticQuality& quality, double load) {
  const auto relative = [&](double ElastoplasticNumbers::*member) {
    return quality.law.*member / (quality.solved.*member) - 1;
  };
  ElastoplasticErrors errors;
  errors.load = load;
  errors.misfit = quality.misfit;
  errors.unloading_stiffness = relative(&ElastoplasticNumbers::unloading_stiffness);
  errors.imprint = relative(&ElastoplasticNumbers::imprint);
  errors.dissipated = relative(&ElastoplasticNumbers::dissipated);
  return errors;
}

/// Mean over the cases fitted, then the law of mean parameters at each smaller load.
template <class Law>
void judge(const Fits<Law>& fits, const Law& law, const std::vector<LoadUnload>& smaller,
           ElastoplasticFact& fact) {
  ElastoplasticErrors mean;
  const double share = 1 / static_cast<double>(fits.fits.size());
  for (const auto& fit : fits.fits) {
    const ElastoplasticErrors one = errors_of(fit.quality, fact.at_load);
    mean.misfit += share * one.misfit;
    mean.unloading_stiffness += share * one.unloading_stiffness;
    mean.imprint += share * one.imprint;
    mean.dissipated += share * one.dissipated;
    if (fit.quality.good)
      fact.good_from = std::max(fact.good_from, fit.quality.good->low);
    else
      fact.good_from = fact.at_load;
  }
  mean.load = fact.at_load;
  fact.errors.push_back(mean);
  double offset = 0;
  for (const auto& fit : fits.fits) offset += share * fit.offset;
  for (const LoadUnload& curve : smaller)
    fact.errors.push_back(errors_of(quality_of(law, curve, offset), curve.largest_force()));
}

/// What the record holds of a parameter.
struct Entry {
  Derivation::Member member;
  Uncertain value;
};

void put(const std::vector<Entry>& entries, const ElastoplasticFact& fact, From from,
         Derivation& derivation) {
  for (const Entry& entry : entries) {
    derivation.parameters.*entry.member =
        EffectiveQuantity{entry.value.value, entry.value.sd, LoadRange{fact.good_from, fact.at_load},
                          LengthScale::none, fact.at_load};
    derivation.origin_of(entry.member) = {{from}, {From::cases, unknown, "", fact.numbers}};
  }
}

nlohmann::ordered_json to_json(const ElastoplasticFact& fact) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& errors : fact.errors)
    json.push_back({{"load", errors.load},
                    {"relative_misfit", errors.misfit},
                    {"unloading_stiffness_error", errors.unloading_stiffness},
                    {"imprint_error", errors.imprint},
                    {"dissipated_energy_error", errors.dissipated}});
  return json;
}

void derive_thornton_ning(const Fits<ThorntonNing>& fits, double radius,
                          const std::vector<LoadUnload>& smaller, ElastoplasticFact fact,
                          Derivation& derivation, LawFindings& findings) {
  using Fit = ElastoplasticFit<ThorntonNing>;
  const Uncertain modulus = fits.mean(&ThorntonNing::reduced_modulus, &Fit::first_sd),
                  pressure = fits.mean(&ThorntonNing::yield_pressure, &Fit::second_sd),
                  work = fits.mean(&ThorntonNing::work_of_adhesion, nullptr);
  fact.law = ElastoplasticFact::Law::thornton_ning;
  fact.first = modulus, fact.second = pressure, fact.third = work.value;
  fact.numbers = fits.numbers;
  judge(fits, {modulus.value, radius, pressure.value, work.value}, smaller, fact);
  std::vector<Entry> entries{{&P::unloading_modulus, modulus}, {&P::yield_pressure, pressure}};
  if (work.value > 0) entries.push_back({&P::yielded_work_of_adhesion, work});
  put(entries, fact, From::thornton_ning_fit, derivation);
  findings.details["thornton_ning"] = to_json(fact);
  findings.found.push_back(fact);
}

void derive_luding(const Fits<Luding>& fits, double radius, const std::vector<LoadUnload>& smaller,
                   ElastoplasticFact fact, Derivation& derivation, LawFindings& findings) {
  using Fit = ElastoplasticFit<Luding>;
  const Uncertain k1 = fits.mean(&Luding::loading_stiffness, &Fit::first_sd),
                  k_p = fits.mean(&Luding::unloading_stiffness, &Fit::second_sd),
                  k_c = fits.mean(&Luding::adhesion_stiffness, nullptr),
                  full = fits.mean(&Luding::full_approach, nullptr);
  fact.law = ElastoplasticFact::Law::luding;
  fact.first = k1, fact.second = k_p, fact.third = k_c.value;
  fact.numbers = fits.numbers;
  judge(fits, {k1.value, k_p.value, k_c.value, full.value, radius}, smaller, fact);
  std::vector<Entry> entries{{&P::luding_k1, k1}, {&P::luding_kp, k_p}, {&P::luding_delta_p, full}};
  if (k_c.value > 0) entries.push_back({&P::luding_kc, k_c});
  put(entries, fact, From::luding_fit, derivation);
  findings.details["luding"] = to_json(fact);
  findings.found.push_back(fact);
}

}  // namespace

void derive_elastoplastic(const ReducedCases& cases, Derivation& derivation, LawFindings& findings) {
  if (std::none_of(cases.begin(), cases.end(), [](const ReducedCase& one) { return one.yields(); })) return;
  double largest = 0;
  for (const ReducedCase& one : cases)
    if (one.yielded) largest = std::max(largest, one.yielded->largest_force());
  Fits<ThorntonNing> thornton_ning;
  Fits<Luding> luding;
  std::vector<LoadUnload> smaller;
  for (const ReducedCase& one : cases) {
    if (!one.yielded) continue;
    if (!same_load(one.yielded->largest_force(), largest)) {
      smaller.push_back(*one.yielded);
      continue;
    }
    thornton_ning.add(one, fit_thornton_ning(*one.yielded, one.hertz, one.is_rough),
                      &ThorntonNing::yield_pressure);
    luding.add(one, fit_luding(*one.yielded, one.hertz.radius, one.is_rough), &Luding::unloading_stiffness);
  }
  thornton_ning.count_once(), luding.count_once();
  ElastoplasticFact fact;
  fact.at_load = largest;
  const double radius = derivation.parameters.effective_radius();
  if (!thornton_ning.fits.empty())
    derive_thornton_ning(thornton_ning, radius, smaller, fact, derivation, findings);
  if (!luding.fits.empty()) derive_luding(luding, radius, smaller, fact, derivation, findings);
  if (thornton_ning.fits.empty()) findings.open.push_back({About::elastoplastic});
}

}  // namespace asperity
