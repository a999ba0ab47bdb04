#include "dem_compare/laws/law_registry.h"

#include <algorithm>
#include <sstream>

#include "core/error.h"
#include "reduced_law_headers.h"  // generated: every header of this folder

namespace asperity {
namespace {

std::string name_of(const RegisteredLaw& law) { return law.description.name; }

const RegisteredLaw& find_law(const std::string& name) {
  static const auto laws = in_order_of_names(Registered<RegisteredLaw>::all(), name_of);
  return entry_named(laws, name, name_of, "no reduced law");
}

std::string admissible(const LawParameter& p) {
  std::ostringstream text;
  if (p.choices.empty()) text << p.low << " to " << p.high;
  for (std::size_t i = 0; i < p.choices.size(); ++i) text << (i ? ", " : "") << p.choices[i];
  return text.str();
}

std::string default_of(const LawParameter& p) {
  if (p.is_needed()) return "-";
  std::ostringstream text;
  text << p.otherwise;
  return p.choices.empty() ? text.str() : p.choices[static_cast<std::size_t>(p.otherwise)];
}

}  // namespace

namespace law_registry_detail {

double value_of(const LawParameter& p, const std::string& law, const LawValues& values) {
  const auto given = values.find(p.name);
  if (given == values.end() && p.is_needed())
    throw InputError("the law '" + law + "' needs '" + p.name + "'" +
                     (p.unit.empty() ? "" : " [" + p.unit + "]") + ", " + p.meaning + "; give it as in '" +
                     law + ", " + p.name + " = ...'");
  const double value = given == values.end() ? p.otherwise : given->second;
  if (value >= p.low && value <= p.high) return value;
  std::ostringstream message;
  message << p.name << " of the law '" << law << "' is " << value << " " << p.unit << "; give a value from "
          << p.low << " to " << p.high;
  throw InputError(message.str());
}

void refuse_mode(const std::string& law, const std::string& mode) {
  throw InputError("the law '" + law + "' is one of " + reduced_law(law).mode + ", not of " + mode);
}

}  // namespace law_registry_detail

std::vector<LawDescription> reduced_laws() {
  std::vector<LawDescription> laws;
  for (const auto& law : Registered<RegisteredLaw>::all()) laws.push_back(law.description);
  std::sort(laws.begin(), laws.end(), [](const LawDescription& one, const LawDescription& other) {
    return std::tie(one.mode, one.name) < std::tie(other.mode, other.name);
  });
  return laws;
}

LawDescription reduced_law(const std::string& name) { return find_law(name).description; }

const LawParameter& law_parameter(const LawDescription& law, const std::string& name) {
  return entry_named(
      law.parameters, name, [](const LawParameter& parameter) { return parameter.name; },
      "no parameter of the law '" + law.name + "' named");
}

ReducedLaw make_reduced_law(const std::string& name, const LawValues& values) {
  const RegisteredLaw& law = find_law(name);
  for (const auto& [given, value] : values) law_parameter(law.description, given);
  return law.make(values);
}

std::string reduced_laws_manual(Equations equations) {
  std::ostringstream page;
  page << "# Reduced laws of one contact\n\n"
          "A law is named with its parameters, as in `--law 'jkr, work_of_adhesion = 50 mJ/m^2'`: `asperity "
          "experiment` leads one\n"
          "particle by it, `asperity law-curve` writes its curve. What the contact's record holds need not "
          "be given.\n";
  for (const auto& law : reduced_laws()) {
    page << "\n## " << law.mode << ": `" << law.name << "`\n\n"
         << displayed(law.equation, equations) << "\n\nSource: " << law.source
         << "\n\nValid: " << law.validity << "\n";
    if (law.parameters.empty()) continue;
    page << "\n| parameter | unit | meaning | admissible | default |\n| --- | --- | --- | --- | --- |\n";
    for (const auto& p : law.parameters)
      page << "| `" << p.name << "` | " << (p.unit.empty() ? "-" : p.unit) << " | " << p.meaning << " | "
           << admissible(p) << " | " << default_of(p) << " |\n";
  }
  return page.str();
}

}  // namespace asperity
