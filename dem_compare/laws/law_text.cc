#include "dem_compare/laws/law_text.h"

#include <algorithm>
#include <sstream>

#include "core/error.h"
#include "core/joined.h"
#include "core/nearest_name.h"
#include "core/quantity.h"

namespace asperity {
namespace {

std::string without_blanks_around(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Of quantities that have one unit alone, none: plain numbers.
Dimension dimension_of(const std::string& unit) {
  for (const Dimension dimension : {Dimension::length, Dimension::force, Dimension::pressure,
                                    Dimension::surface_energy, Dimension::stiffness, Dimension::angle})
    if (si_symbol(dimension) == unit) return dimension;
  return Dimension::none;
}

double value_of(const LawParameter& parameter, const std::string& text) {
  if (parameter.choices.empty()) return parse_quantity(text, dimension_of(parameter.unit));
  const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
  if (found != parameter.choices.end()) return static_cast<double>(found - parameter.choices.begin());
  throw InputError("there is no " + parameter.name + " '" + text + "'; there are " +
                   joined(parameter.choices, ", "));
}

}  // namespace

WrittenLaw parse_law(const std::string& text) {
  std::istringstream parts(text);
  std::string part;
  std::getline(parts, part, ',');
  WrittenLaw law{reduced_law(without_blanks_around(part)), {}};
  while (std::getline(parts, part, ',')) {
    const auto equals = part.find('=');
    if (equals == std::string::npos)
      throw InputError("in '" + text + "' the part '" + without_blanks_around(part) +
                       "' is not 'parameter = value'");
    const std::string name = without_blanks_around(part.substr(0, equals));
    const LawParameter& parameter = law_parameter(law.description, name);
    law.values[name] = value_of(parameter, without_blanks_around(part.substr(equals + 1)));
  }
  return law;
}

}  // namespace asperity
