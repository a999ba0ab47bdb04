// What a law says of itself in its own file: by that it is listed, its parameters are read from a case, and
// it is made.
#pragma once

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/quantity.h"
#include "core/range.h"

namespace asperity {

/// Parameters of laws in SI units, by the names of their entries in a case file.
using LawValues = std::map<std::string, double>;

struct ParameterEntry {
  std::string entry;          ///< name in the case file; laws that share it declare it alike
  std::vector<std::string> symbols;  ///< in the law's equation; of a joined parameter, in those of all laws
  Dimension dimension = Dimension::none;
  std::string documentation;  ///< for the manual; {symbols} stands for those of all laws that take the entry
  std::string default_text = "0";
  Range range = not_negative;
  bool optional = false;      ///< the law can be meant by a case that leaves it at its default
  std::string if_missing;     ///< what to do where a law that needs it lacks it, as the end of a sentence
};

struct LawDeclaration {
  std::string name, equation, source, validity;
  std::vector<ParameterEntry> parameters;

  bool takes(const std::string& entry) const {
    return std::any_of(parameters.begin(), parameters.end(), [&](const auto& p) { return p.entry == entry; });
  }
};

/// Adds a law to those of its kind, before main: `inline const Registered<Declaration> name{declaration};` in
/// the law's file.
template <class Declaration>
class Registered {
 public:
  explicit Registered(Declaration declaration) {
    auto& laws = list();
    const auto at = std::lower_bound(laws.begin(), laws.end(), declaration,
                                     [](const auto& a, const auto& b) { return a.name < b.name; });
    if (at != laws.end() && at->name == declaration.name)
      throw std::logic_error("there are two laws '" + declaration.name + "'");
    laws.insert(at, std::move(declaration));
  }
  /// By name, whatever the order of linking.
  static const std::vector<Declaration>& all() { return list(); }

 private:
  static std::vector<Declaration>& list() {
    static std::vector<Declaration> laws;
    return laws;
  }
};

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

double default_of(const ParameterEntry& parameter);

/// `values` and the defaults of those parameters that they lack.
LawValues with_defaults(const std::vector<ParameterEntry>& parameters, LawValues values);

/// First parameter without which the law is not meant that `values` leave at its default; null: they have
/// all.
const ParameterEntry* first_missing(const LawDeclaration& law, const LawValues& values);

/// "a", "a or b", "a, b or c".
std::string alternatives(const std::vector<std::string>& words, const std::string& last = " or ");

}  // namespace asperity
