#include "dem_compare/laws/law_registry.h"

#include <algorithm>
#include <sstream>

#include "core/error.h"
#include "core/nearest_name.h"
#include "reduced_law_headers.h"  // generated: every header of this folder

namespace asperity {
namespace {

std::vector<LawDescription>& registered() {
  static std::vector<LawDescription> laws;  // in a function: filled while other files' constants are still being set up
  return laws;
}

template <class Named>
[[noreturn]] void refuse_unknown(const std::string& what, const std::string& written, const std::vector<Named>& known) {
  std::vector<std::string> names;
  for (const auto& entry : known) names.push_back(entry.name);
  const std::string nearest = nearest_name(written, names);
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  throw InputError("no " + what + " '" + written + "'" +
                   (nearest.empty() ? "; there are: " + list : "; did you mean '" + nearest + "'?"));
}

}  // namespace

namespace law_registry_detail {

void add(const LawDescription& description) { registered().push_back(description); }

std::size_t index_of(const LawDescription& description, const std::string& parameter) {
  for (std::size_t i = 0; i < description.parameters.size(); ++i)
    if (description.parameters[i].name == parameter) return i;
  refuse_unknown("parameter of the law '" + description.name + "' named", parameter, description.parameters);
}

void check(const LawDescription& description, std::size_t parameter, double value) {
  const LawParameter& p = description.parameters[parameter];
  if (value >= p.low && value <= p.high) return;
  std::ostringstream message;
  message << p.name << " of the law '" << description.name << "' is " << value << " " << p.unit << "; give a value from "
          << p.low << " to " << p.high;
  throw InputError(message.str());
}

}  // namespace law_registry_detail

std::vector<LawDescription> reduced_laws() {
  std::vector<LawDescription> laws = registered();
  std::sort(laws.begin(), laws.end(), [](const LawDescription& one, const LawDescription& other) {
    return std::tie(one.mode, one.name) < std::tie(other.mode, other.name);
  });
  return laws;
}

LawDescription reduced_law(const std::string& name) {
  for (const auto& law : registered())
    if (law.name == name) return law;
  refuse_unknown("reduced law", name, reduced_laws());
}

std::string reduced_laws_manual() {
  std::ostringstream page;
  page << "# Reduced laws of one contact\n";
  for (const auto& law : reduced_laws()) {
    page << "\n## " << law.mode << ": `" << law.name << "`\n\n" << law.equation << "\n\nSource: " << law.source
         << "\n\nValid: " << law.validity << "\n";
    if (law.parameters.empty()) continue;
    page << "\n| parameter | unit | meaning | admissible |\n| --- | --- | --- | --- |\n";
    for (const auto& p : law.parameters)
      page << "| `" << p.name << "` | " << (p.unit.empty() ? "-" : p.unit) << " | " << p.meaning << " | " << p.low
           << " to " << p.high << " |\n";
  }
  return page.str();
}

}  // namespace asperity
