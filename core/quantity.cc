#include "core/quantity.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/printed.h"
#include "core/text_pieces.h"

namespace asperity {
namespace {

using Units = std::vector<std::pair<std::string, double>>;

constexpr double degree = 3.14159265358979323846 / 180.0;

/// Units of each dimension, the SI unit first.
const Units& units_of(Dimension dimension) {
  static const Units none{{"", 1.0}, {"%", 0.01}};
  static const Units length{{"m", 1.0},   {"mm", 1e-3}, {"um", 1e-6},  {"µm", 1e-6},
                            {"μm", 1e-6}, {"nm", 1e-9}, {"pm", 1e-12}, {"A", 1e-10},
                            {"Å", 1e-10}, {"cm", 1e-2}, {"km", 1e3}};
  static const Units force{{"N", 1.0},   {"mN", 1e-3}, {"uN", 1e-6},  {"µN", 1e-6},
                           {"μN", 1e-6}, {"nN", 1e-9}, {"pN", 1e-12}, {"kN", 1e3}};
  static const Units pressure{{"Pa", 1.0}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}, {"TPa", 1e12}};
  static const Units time{{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60.0}, {"h", 3600.0}};
  static const Units angle{{"rad", 1.0}, {"mrad", 1e-3}, {"urad", 1e-6}, {"deg", degree}, {"°", degree}};
  static const Units speed{{"m/s", 1.0}, {"mm/s", 1e-3}, {"um/s", 1e-6}, {"nm/s", 1e-9}};
  static const Units surface_energy{{"J/m^2", 1.0}, {"mJ/m^2", 1e-3}, {"N/m", 1.0}, {"mN/m", 1e-3}};
  static const Units area{{"m^2", 1.0}, {"mm^2", 1e-6}, {"um^2", 1e-12}, {"nm^2", 1e-18}};
  static const Units stiffness{{"N/m", 1.0}, {"kN/m", 1e3}, {"MN/m", 1e6}, {"uN/nm", 1e3}, {"mN/um", 1e3}};
  static const Units temperature{{"K", 1.0}};
  static const Units voltage{{"V", 1.0}, {"mV", 1e-3}, {"uV", 1e-6}, {"kV", 1e3}};
  static const Units molar_volume{{"m^3/mol", 1.0}, {"cm^3/mol", 1e-6}};
  switch (dimension) {
    case Dimension::none:
      return none;
    case Dimension::length:
      return length;
    case Dimension::force:
      return force;
    case Dimension::pressure:
      return pressure;
    case Dimension::time:
      return time;
    case Dimension::angle:
      return angle;
    case Dimension::speed:
      return speed;
    case Dimension::surface_energy:
      return surface_energy;
    case Dimension::area:
      return area;
    case Dimension::stiffness:
      return stiffness;
    case Dimension::temperature:
      return temperature;
    case Dimension::voltage:
      return voltage;
    case Dimension::molar_volume:
      return molar_volume;
  }
  return none;
}

using Prefixes = std::vector<std::pair<std::string, double>>;

/// Largest first.
const Prefixes& prefixes() {
  static const Prefixes prefixes{{"T", 1e12}, {"G", 1e9},  {"M", 1e6},  {"k", 1e3},  {"", 1.0},
                                 {"m", 1e-3}, {"u", 1e-6}, {"n", 1e-9}, {"p", 1e-12}};
  return prefixes;
}

bool takes_prefixes(Dimension dimension) {
  return dimension != Dimension::none && dimension != Dimension::area && dimension != Dimension::angle &&
         dimension != Dimension::molar_volume;
}

std::string list_of(const Units& units) {
  std::string list;
  for (const auto& [name, factor] : units)
    if (!name.empty()) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

std::string si_symbol(Dimension dimension) { return units_of(dimension).front().first; }

double unit_factor(const std::string& unit, Dimension dimension) {
  for (const auto& [name, factor] : units_of(dimension))
    if (name == unit) return factor;
  if (takes_prefixes(dimension))  // what format_quantity writes
    for (const auto& [prefix, factor] : prefixes())
      if (unit == prefix + si_symbol(dimension)) return factor;
  throw InputError("unit '" + unit + "' does not fit; use one of " + list_of(units_of(dimension)));
}

double parse_quantity(const std::string& text, Dimension dimension) {
  const std::string plain = trimmed(text);
  char* end = nullptr;
  const double number = std::strtod(plain.c_str(), &end);
  if (plain.empty() || end == plain.c_str() || std::isnan(number))
    throw InputError("'" + text + "' is not a number with a unit; write for example '2.5 " +
                     si_symbol(dimension) + "'");
  const std::string unit = trimmed(plain.substr(static_cast<std::size_t>(end - plain.c_str())));
  if (unit.empty()) return number;
  try {
    return number * unit_factor(unit, dimension);
  } catch (const InputError& error) {
    throw InputError("in '" + plain + "' the " + error.what());
  }
}

std::string format_quantity(double si_value, Dimension dimension, int digits) {
  std::string number = printed("%.*g", digits, si_value);
  if (dimension == Dimension::none || !std::isfinite(si_value)) return number;
  const std::string symbol = si_symbol(dimension);
  // What rounds to 1000 of a prefix is 1 of the next: 0.9999 nm in three digits is 1 nm, not 1000 pm (nor
  // 1e+03 pm).
  const double rounded = std::strtod(number.c_str(), nullptr);
  if (rounded != 0.0 && takes_prefixes(dimension))
    for (const auto& [prefix, factor] : prefixes())
      if (std::abs(rounded) >= factor * (1 - 1e-12))
        // Two digits of 316 um are 320 um, not 3.2e+02 um.
        return printed("%.*g ", std::max(digits, 3), rounded / factor) + prefix + symbol;
  return number + " " + symbol;
}

}  // namespace asperity
