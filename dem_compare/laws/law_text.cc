#include "dem_compare/laws/law_text.h"

#include <algorithm>
#include <sstream>

#include "core/error.h"
#include "core/joined.h"
#include "core/nearest_name.h"
#include "core/quantity.h"
#include "core/text_pieces.h"

namespace asperity {
namespace {

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
  WrittenLaw law{reduced_law(trimmed(part)), {}};
  while (std::getline(parts, part, ',')) {
    const auto equals = part.find('=');
    if (equals == std::string::npos)
      throw InputError("in '" + text + "' the part '" + trimmed(part) + "' is not 'parameter = value'");
    const std::string name = trimmed(part.substr(0, equals));
    const LawParameter& parameter = law_parameter(law.description, name);
    law.values[name] = value_of(parameter, trimmed(part.substr(equals + 1)));
  }
  return law;
}

}  // namespace asperity
