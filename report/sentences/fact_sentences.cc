#include <cmath>
#include <set>

#include "core/joined.h"
#include "core/printed.h"
#include "report/sentences/derivation_sentences.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

std::string plain(double value) { return quantity_text({value}, Dimension::none); }
std::string pressure(const Uncertain& value) { return quantity_text(value, Dimension::pressure); }
std::string at_load(const Uncertain& value, const std::string& unit, double load) {
  return quantity_text(value, unit) + " at " + force_text(load);
}
struct InWords {
  std::string operator()(const ModulusFact& f) const {
    return say(
        "E* = {} (materials: {}), {}{}; {}",
        {pressure(f.value), pressure({f.materials}), f.with_offset ? hertz_with_offset : hertz_fit,
         f.attraction > 0 ? say(" over the load and an attraction of {}", {force_text(f.attraction)}) : "",
         source_words(f.numbers)});
  }
  std::string operator()(const RadiusFact& f) const {
    return say("the same as a radius: R_effective = {} (particle: {}) with the materials' E*",
               {quantity_text({f.value}, Dimension::length), length_text(f.particle)});
  }
  std::string operator()(const ExponentFact& f) const {
    return "exponent of the load over the approach: " + quantity_text(f.value, Dimension::none) +
           " (Hertz: 1.5)" + (f.with_offset ? ", offset " + quantity_text(f.offset, Dimension::length) : "");
  }
  std::string operator()(const NormalStiffnessFact& f) const {
    return say("k_n = {}, growing with a (2 E* a: {}); {}",
               {at_load({f.law.value, f.law.sd}, "N/m", f.law.at_load),
                format_quantity(f.hertz, Dimension::stiffness), extent_words(f.used)});
  }
  std::string operator()(const GrowthFact& f) const {
    return say("{} grows as a^n, n = {} (the law taken has {})",
               {asperity::report::words_of(f.what),
                quantity_text({f.law.exponent, f.law.exponent_sd}, Dimension::none), plain(f.taken)});
  }
  std::string operator()(const YieldFact& f) const {
    constexpr double um3 = 1e-18;
    return say(
        "material yielded in {} of {} cases, seen first at {} (plastic volume up to {}): E* and its exponent "
        "are those of the first loading; unloading and reloading are stiffer, and k_n is theirs",
        {std::to_string(f.yielded), std::to_string(f.cases), force_text(f.from),
         printed("%.2g um^3", f.largest / um3)});
  }
  std::string operator()(const RelaxationFact& f) const {
    return say(
        "bodies relax with time in {} of {} cases: E* and its exponent are those of loading in the cases' "
        "own "
        "Load time, and k_n is that of fast changes",
        {std::to_string(f.relaxed), std::to_string(f.cases)});
  }
  std::string operator()(const ElastoplasticFact& f) const {
    const bool is_luding = f.law == ElastoplasticFact::Law::luding;
    constexpr double many = 2;
    const auto beside = [](double error) {
      return error > many ? say("{} times", {number_text({1 + error})}) : change_percent({error});
    };
    const auto pull = [&](const std::string& name, const std::string& value) {
      return f.third > 0 ? ", " + name + " = " + value : "";
    };
    std::string text = is_luding ? say("elasto-plastic, Luding 2008: k1 = {}, k_p = {}{}",
                                       {quantity_text(f.first, "N/m"), quantity_text(f.second, "N/m"),
                                        pull("k_c", quantity_text({f.third}, "N/m"))})
                                 : say("elasto-plastic, Thornton & Ning 1998: E* = {}, p_y = {}{}",
                                       {pressure(f.first), pressure(f.second),
                                        pull("w", quantity_text({f.third}, Dimension::surface_energy))});
    text += f.good_from < f.at_load
                ? say("; force of loading within 10 % from {} to {}",
                      {force_text(f.good_from), force_text(f.at_load)})
                : say("; force of loading nowhere within 10 % up to {}", {force_text(f.at_load)});
    for (const auto& e : f.errors)
      text +=
          say("; from {}: unloading stiffness {}, imprint {}, dissipated energy {} beside the solved ones",
              {force_text(e.load), beside(e.unloading_stiffness), beside(e.imprint), beside(e.dissipated)});
    return text + "; " + source_words(f.numbers);
  }
  std::string operator()(const PullOffFact& f) const {
    return "pull-off force " + quantity_text(f.value, Dimension::force);
  }
  std::string operator()(const ScatterFact& f) const {
    return say("scatter between realisations ({}): {} of one, from up to {} at a load",
               {asperity::report::words_of(f.what), share_text(f.scatter.relative),
                std::to_string(f.scatter.realisations)});
  }
  std::string operator()(const MeshFact& f) const {
    return say(
        "error of the mesh ({}): {}{}; not part of the uncertainty above",
        {asperity::report::words_of(f.what), share_text(f.error.relative_error),
         f.error.families > 1 ? say(", mean of {} contacts", {std::to_string(f.error.families)}) : ""});
  }
  std::string operator()(const MeanResistanceFact& f) const {
    return say("at {}: {}{}; fluctuation along the path {}, {} independent blocks",
               {force_text(f.load), quantity_text(f.mean, f.mode->resistance_unit),
                f.cases > 1 ? say(", mean of {} realisations", {std::to_string(f.cases)}) : "",
                share_text(f.fluctuation), plain(std::round(f.independent))});
  }
  std::string operator()(const DissipationFact& f) const {
    return say(
        "The resistance is the energy dissipated per {}: the conservative topographic part is not in it.",
        {f.mode == &sliding_mode() ? "path length" : "angle"});
  }
  std::string operator()(const LawFact& f) const { return law_words(f.law, "mu"); }
  std::string operator()(const LengthFact& f) const {
    const LengthChoice& choice = f.choice;
    constexpr double most_that_matters = 1e6;
    const double odds = std::exp(std::abs(choice.log_odds));
    return say("odds {} to 1 for lambda = {}{}",
               {odds > most_that_matters ? "more than 10^6" : printed("%.3g", odds),
                choice.log_odds >= 0 ? "a" : "r",
                std::isfinite(choice.contact_error)
                    ? say("; a contact predicted from the others is off by {} with a, {} with r",
                          {share_text(choice.contact_error), share_text(choice.radius_error)})
                    : ""});
  }
  std::string operator()(const MisfitFact& f) const {
    return say("misfit of the law: {} (root mean square of {} contacts)",
               {share_text(f.misfit), std::to_string(f.cases)});
  }
  std::string operator()(const LocalFrictionFact& f) const {
    return say("The local friction coefficient of {} went in; what comes out follows from it.",
               {f.coefficient});
  }
  std::string operator()(const StiffnessFact& f) const {
    return say(
        "stiffness {}: {}; {}",
        {asperity::report::words_of(f.source),
         at_load({f.law.value, f.law.sd}, f.mode->stiffness_unit, f.law.at_load), extent_words(f.used)});
  }
  std::string operator()(const ReversalFact& f) const {
    return "slope after the reversal, partial slip taken out: " +
           at_load({f.law.value, f.law.sd}, f.mode->stiffness_unit, f.law.at_load);
  }
  std::string operator()(const ShearModulusFact& f) const {
    return say("G* of k_l = 8 G* a: {} (materials, Mindlin 1949: {})",
               {pressure(f.value), pressure({f.materials})});
  }
  std::string operator()(const TorsionFact& f) const {
    return "mu of torsion over that of sliding friction spread as Hertz' pressure, 3 pi/16 mu_l (Lubkin "
           "1951): " +
           plain(f.ratio);
  }
};

}  // namespace

std::string words_of(Derived what) {
  static const char* const names[] = {"E*", "k_n", "the resistance", "the stiffness"};
  return names[static_cast<int>(what)];
}

std::string words_of(StiffnessSource source) {
  static const char* const words[] = {"without slip",
                                      "of rolling back in a second pass, to half the loop's width",
                                      "slope after the reversal"};
  return words[static_cast<int>(source)];
}

std::string words_of(const Fact& fact) { return std::visit(InWords{}, fact); }

std::string source_words(const std::vector<CaseNumber>& all) {
  const auto error = discretisation_error(all);
  return extent_words(counted_of(all)) + "; error of the mesh " +
         (error ? share_text(error->relative_error) + ", not in the sd" : "not known");
}

std::string extent_words(const std::vector<CaseNumber>& numbers) {
  std::set<std::string> realisations, spacings, by_half_spaces;
  double low = numbers.front().load, high = low;
  std::size_t cases = 0;
  for (const auto& number : numbers) {
    (number.by_half_spaces ? by_half_spaces : realisations).insert(number.realisation);
    cases += !number.by_half_spaces;
    if (std::isfinite(number.spacing)) spacings.insert(length_text(number.spacing));
    low = std::min(low, number.load), high = std::max(high, number.load);
  }
  const auto counted = [](std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  return say("{}, load {}{}, {}{}{}",
             {counted(cases, "case"), force_text(low), same_load(low, high) ? "" : " to " + force_text(high),
              counted(realisations.size(), "realisation"),
              spacings.empty() ? "" : ", spacing " + joined({spacings.begin(), spacings.end()}, " and "),
              by_half_spaces.empty()
                  ? ""
                  : ", and " + counted(by_half_spaces.size(), "surface") +
                        " more by half-spaces, corrected by what finite elements differ from them"});
}

}  // namespace asperity::report
