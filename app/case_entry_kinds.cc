#include "app/case_entry_kinds.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/printed.h"
#include "results/known_entries.h"

namespace asperity {
namespace {

std::string in_words(const Range& range, Dimension dimension) {
  const auto number = [&](double x) { return format_quantity(x, x == 0 ? Dimension::none : dimension, 6); };
  if (std::isinf(range.high)) {
    const std::string words = range.low_open ? "above " + number(range.low) : number(range.low) + " or more";
    return range.high_open ? words : words + ", or inf";
  }
  return std::string("from ") + number(range.low) + (range.low_open ? " (excluded)" : "") + " to " +
         number(range.high) + (range.high_open ? " (excluded)" : "");
}

std::string kind_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
      return "a length [m, um, nm], ";
    case Dimension::force:
      return "a force [N, mN, uN, nN], ";
    case Dimension::pressure:
      return "a pressure [Pa, MPa, GPa], ";
    case Dimension::surface_energy:
      return "an energy per area [J/m^2, mJ/m^2], ";
    case Dimension::angle:
      return "an angle [rad, deg], ";
    case Dimension::time:
      return "a time [s, ms, min], ";
    case Dimension::speed:
      return "a speed [m/s, um/s, nm/s], ";
    case Dimension::temperature:
      return "a temperature [K], ";
    case Dimension::voltage:
      return "a voltage [V, mV], ";
    case Dimension::molar_volume:
      return "a volume per mole [m^3/mol, cm^3/mol], ";
    default:
      return "a number, ";
  }
}

std::string canonical_number(double value) { return printed("%.14g", value); }

}  // namespace

CaseEntry quantity(std::string section, std::string name, const Member<double>& member, Dimension dimension,
                   Range range, std::string default_text, std::string example, std::string documentation) {
  const std::string admissible = kind_of(dimension) + in_words(range, dimension);
  return {std::move(section),
          std::move(name),
          std::move(default_text),
          std::move(example),
          admissible,
          std::move(documentation),
          [=](CaseInput& input, const std::string& text) {
            const double value = parse_quantity(text, dimension);
            if (!range.holds(value))
              throw InputError("'" + text + "' is not admissible; it must be " + admissible);
            member(input) = value;
          },
          [=](const std::string& text) { return canonical_number(parse_quantity(text, dimension)); }};
}

CaseEntry whole_number(std::string section, std::string name, const Member<int>& member, int low,
                       std::string default_text, std::string documentation) {
  const std::string admissible = "a whole number, " + std::to_string(low) + " or more";
  return {std::move(section),
          std::move(name),
          std::move(default_text),
          "",
          admissible,
          std::move(documentation),
          [=](CaseInput& input, const std::string& text) {
            char* end = nullptr;
            const long value = std::strtol(text.c_str(), &end, 10);
            if (text.empty() || *end != '\0' || value < low || value > std::numeric_limits<int>::max())
              throw InputError("'" + text + "' is not admissible; it must be " + admissible);
            member(input) = static_cast<int>(value);
          },
          [](const std::string& text) { return std::to_string(std::strtol(text.c_str(), nullptr, 10)); }};
}

CaseEntry not_physical(CaseEntry entry) {
  entry.is_physical = false;
  return entry;
}

CaseEntry flag(std::string section, std::string name, const Member<bool>& member, std::string default_text,
               std::string documentation) {
  return choice<bool>(std::move(section), std::move(name), member, {{"true", true}, {"false", false}},
                      std::move(default_text), std::move(documentation));
}

CaseEntry law_entry(const std::string& section, const ParameterEntry& parameter,
                    const Member<LawValues>& values) {
  const Member<double> member = [=, name = parameter.entry](CaseInput& input) -> double& {
    return values(input)[name];
  };
  CaseEntry entry = quantity(section, parameter.entry, member, parameter.dimension, parameter.range,
                             parameter.default_text, "", documentation_of(parameter));
  if (!parameter.words.empty()) {
    std::vector<std::pair<std::string, double>> words;
    for (const auto& word : parameter.words) words.emplace_back(word, static_cast<double>(words.size()));
    entry = choice<double>(section, parameter.entry, member, words, parameter.default_text,
                           documentation_of(parameter));
  }
  entry.counts_if_given = !is_known_entry(section + "/" + parameter.entry);
  return entry;
}

}  // namespace asperity
