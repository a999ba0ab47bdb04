// What a law says of itself in its own file: by that it is listed, its parameters are read from a case, and
// it is made.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/quantity.h"
#include "core/range.h"
#include "core/registry.h"

namespace asperity {

/// Parameters of laws in SI units, by the names of their entries in a case file.
using LawValues = std::map<std::string, double>;

/// One parameter of a law, as an entry of a case file.
struct ParameterEntry {
  std::string entry;                 ///< name in the case file; laws that share it declare it alike
  std::vector<std::string> symbols;  ///< in the law's equation; of a joined parameter, in those of all laws
  Dimension dimension = Dimension::none;
  std::string
      documentation{};  ///< for the manual; {symbols} stands for those of all laws that take the entry
  std::string default_text = "0";
  Range range = not_negative;
  std::vector<std::string>
      words{};               ///< of a choice, whose value is the word's place among them; empty: a number
  bool optional = false;     ///< the law can be meant by a case that leaves it at its default
  std::string if_missing{};  ///< what to do where a law that needs it lacks it, as the end of a sentence
};

struct LawDeclaration {
  std::string name, equation, source, validity;
  std::vector<ParameterEntry> parameters;

  /// Whether the law has a parameter of this entry.
  bool takes(const std::string& entry) const {
    return std::any_of(parameters.begin(), parameters.end(), [&](const auto& p) { return p.entry == entry; });
  }
};

/// All laws of a kind, by name: what `Registered<Declaration>` in their files has declared.
template <class Declaration>
const std::vector<Declaration>& declared_laws() {
  static const std::vector<Declaration> laws =
      in_order_of_names(Registered<Declaration>::all(), [](const auto& law) { return law.name; });
  return laws;
}

/// Adds the parameters of one more law to those of others, each entry once. Throws std::logic_error if it is
/// declared otherwise.
void join_parameters(const LawDeclaration& law, std::vector<ParameterEntry>& parameters);

/// Parameters of all laws of a kind, each once, in the order of the laws; their documentation names all
/// symbols.
template <class Declaration>
std::vector<ParameterEntry> parameters_of(const std::vector<Declaration>& laws) {
  std::vector<ParameterEntry> parameters;
  for (const auto& law : laws) join_parameters(law, parameters);
  return parameters;
}
/// "The length h0, rho or z0 of the law": the documentation with the joined symbols.
std::string documentation_of(const ParameterEntry& parameter);

/// Its default as a number in SI units; of a choice, the word's place among `words`.
double default_of(const ParameterEntry& parameter);

/// `values` and the defaults of those parameters that they lack.
LawValues with_defaults(const std::vector<ParameterEntry>& parameters, LawValues values);

/// Entries of these parameters whose values are not their defaults.
std::vector<std::string> given_entries(const std::vector<ParameterEntry>& parameters,
                                       const LawValues& values);

/// "Coulomb (Friction coefficient)".
std::string law_in_words(const LawDeclaration& law);

/// First parameter without which the law is not meant that `values` leave at its default; null: they have
/// all.
const ParameterEntry* first_missing(const LawDeclaration& law, const LawValues& values);

/// "a", "a or b", "a, b or c".
std::string alternatives(const std::vector<std::string>& words, const std::string& last = " or ");

/// The law that takes all that `values` give and has what it needs. Throws InputError, calling laws a `kind`,
/// if that is none or several.
template <class Declaration>
const Declaration& the_law_meant(const std::vector<Declaration>& laws, const LawValues& values,
                                 const std::string& kind) {
  const std::vector<std::string> given = given_entries(parameters_of(laws), values);
  std::vector<const Declaration*> meant;
  std::vector<std::string> all;
  for (const auto& law : laws) {
    const bool takes_all =
        std::all_of(given.begin(), given.end(), [&](const auto& entry) { return law.takes(entry); });
    if (takes_all && !first_missing(law, values)) meant.push_back(&law);
    all.push_back(law_in_words(law));
  }
  if (meant.size() == 1) return *meant.front();
  throw InputError((meant.empty() ? "no " : "more than one ") + kind + " takes just " +
                   alternatives(given, " and ") + "; give the entries of one: " + alternatives(all));
}

}  // namespace asperity
