// Quantities as people write them ("2.5 um", "3000 uN", "71 GPa") and as the program computes with them (SI).
#pragma once

#include <string>

namespace asperity {

/// What a number measures; each has one SI unit.
enum class Dimension {
  none,
  length,
  force,
  pressure,
  time,
  angle,
  speed,
  surface_energy,
  area,
  stiffness,
  temperature,
  voltage,
  molar_volume
};

/// SI symbol of a dimension: "m", "N", "Pa", "s", "rad", "m/s", "J/m^2", "m^2", "N/m", "K",
/// "V", "m^3/mol", "" for none.
std::string si_symbol(Dimension dimension);

/// Value in SI of a text such as "2.5 um" or "1e-6" (a plain number is SI; "inf" is allowed).
/// Throws InputError naming the text and the units that fit.
double parse_quantity(const std::string& text, Dimension dimension);

/// Factor from `unit` ("um", "GPa", ...) to SI. Throws InputError if the unit is not one of `dimension`.
double unit_factor(const std::string& unit, Dimension dimension);

/// "2.5 um" for (2.5e-6, length): `digits` significant digits and a prefix that keeps the number in [1,
/// 1000).
std::string format_quantity(double value, Dimension dimension, int digits = 3);

}  // namespace asperity
