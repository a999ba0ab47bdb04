#include "fem/interface/friction_law.h"

#include "core/error.h"
#include "friction_law_files.h"  // all of friction/; what they declare is linked for being included here

namespace asperity::fem {
namespace {

std::vector<std::string> entries_of(const std::vector<ParameterEntry>& parameters) {
  std::vector<std::string> entries;
  for (const auto& parameter : parameters) entries.push_back(parameter.entry);
  return entries;
}

std::string laws_in_words() {
  std::vector<std::string> laws;
  for (const auto& law : friction_laws())
    laws.push_back(law.name + " (" + alternatives(entries_of(law.parameters), " and ") + ")");
  return alternatives(laws);
}

}  // namespace

ShearLimit FrictionLaw::initial_limit(double pressure) const {
  InterfacePoint point;
  point.pressure = pressure;
  return limit(point, std::vector<double>(history().size(), 0.0).data());
}

const std::vector<FrictionLawDeclaration>& friction_laws() {
  return Registered<FrictionLawDeclaration>::all();
}

std::unique_ptr<FrictionLaw> make_friction_law(const InterfaceInput& input) {
  const auto parameters = parameters_of(friction_laws());
  const LawValues values = with_defaults(parameters, input.parameters);
  std::vector<std::string> given;
  for (const auto& parameter : parameters)
    if (values.at(parameter.entry) != default_of(parameter)) given.push_back(parameter.entry);
  if (given.empty()) return nullptr;
  std::vector<const FrictionLawDeclaration*> meant;
  for (const auto& law : friction_laws()) {
    const bool takes_all =
        std::all_of(given.begin(), given.end(), [&](const auto& entry) { return law.takes(entry); });
    if (takes_all && !first_missing(law, values)) meant.push_back(&law);
  }
  if (meant.size() != 1)
    throw InputError((meant.empty() ? "no law" : "more than one law") +
                     std::string(" of friction takes just Interface/") + alternatives(given, " and ") +
                     "; give the entries of one: " + laws_in_words());
  return meant.front()->make(values);
}

}  // namespace asperity::fem
