#include "surfaces/readers/length_unit.h"

#include <map>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {

std::string plain_unit(const std::string& unit) {
  static const std::map<std::string, std::string> spellings{
      {"~m", "um"},         {"\xB5m", "um"},     {"µm", "um"},         {"μm", "um"},
      {"micron", "um"},     {"microns", "um"},   {"micrometer", "um"}, {"micrometers", "um"},
      {"micrometre", "um"}, {"\xC5", "A"},       {"Å", "A"},           {"Ang", "A"},
      {"Angstrom", "A"},    {"angstrom", "A"},   {"nanometer", "nm"},  {"nanometers", "nm"},
      {"nanometre", "nm"},  {"meter", "m"},      {"meters", "m"},      {"metre", "m"},
      {"millimeter", "mm"}, {"millimetre", "mm"}};
  const std::string trimmed = trimmed_text(unit);
  const auto found = spellings.find(trimmed);
  return found == spellings.end() ? trimmed : found->second;
}

std::optional<double> length_unit_factor(const std::string& unit) {
  const std::string plain = plain_unit(unit);
  if (plain.empty()) return std::nullopt;
  try {
    return unit_factor(plain, Dimension::length);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace asperity
