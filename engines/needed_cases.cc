#include "engines/needed_cases.h"

#include "core/joined.h"

namespace asperity {
namespace {

using Member = std::optional<EffectiveQuantity> ContactParameters::*;

/// What engines take of each motion; offsets are optional, G* is in every record.
struct Resistance {
  std::vector<Member> quantities;
  bool is_required;
};

const std::vector<Resistance>& resistances() {
  using P = ContactParameters;
  static const std::vector<Resistance> all{{{&P::sliding_friction}, true},
                                           {{&P::rolling_friction, &P::rolling_stiffness}, false},
                                           {{&P::torsion_friction, &P::torsion_stiffness}, false}};
  return all;
}

const QuantityEntry& entry_of(Member member) {
  for (const auto& entry : quantity_entries())
    if (entry.member == member) return entry;
  return quantity_entries().front();
}

}  // namespace

std::vector<NeededCase> needed_cases(const ContactParameters& parameters) {
  std::vector<NeededCase> needed;
  for (const Resistance& resistance : resistances()) {
    NeededCase missing;
    for (const Member member : resistance.quantities)
      if (!(parameters.*member)) missing.quantities.push_back(entry_of(member).key);
    missing.experiment = entry_of(resistance.quantities.front()).told_by;
    missing.is_required = resistance.is_required;
    if (!missing.quantities.empty()) needed.push_back(missing);
  }
  return needed;
}

std::string to_text(const NeededCase& needed) {
  return joined(needed.quantities, " and ") + " (a case with Experiment/Type = " + needed.experiment + ")";
}

std::string needed_cases_text(const ContactParameters& parameters) {
  const std::vector<NeededCase> needed = needed_cases(parameters);
  if (needed.empty()) return "";
  std::string text = "What an engine still needs\n";
  for (const auto& missing : needed)
    text += "  " + to_text(missing) +
            (missing.is_required ? ": no engine's input can be written without it\n"
                                 : ": without it engines get no " + missing.experiment + " resistance\n");
  return text +
         "  Solve these for the same bodies, surfaces and interface, best at several loads, and name their "
         "folders to derive beside those above.\n";
}

}  // namespace asperity
