#include "dem_compare/resistance/contact_inputs.h"

#include <cmath>
#include <cstdio>
#include <regex>
#include <set>

#include "core/quantity.h"

namespace asperity {
namespace {

/// Number of an entry; `otherwise` where it is missing.
double number_of_entry(const ContactInputs& inputs, const std::string& entry, Dimension dimension, double otherwise) {
  const auto found = inputs.find(entry);
  return found == inputs.end() ? otherwise : parse_quantity(found->second, dimension);
}

/// Without the seed, and with lengths in metres: further realisations are written anew, "0.7 nm" as "700 pm".
std::string without_seed(std::string text) {
  static const std::regex seed(R"(,?\s*seed\s*=\s*\d+)"), blanks(R"(\s+)"),
      length(R"(([0-9.]+(?:e[+-]?[0-9]+)?) ?(pm|nm|um|mm|m)\b)");
  text = std::regex_replace(std::regex_replace(text, seed, ""), blanks, " ");
  std::smatch found;
  std::string rest = text, result;
  while (std::regex_search(rest, found, length)) {
    char metres[32];
    std::snprintf(metres, sizeof metres, "%.6g", parse_quantity(found.str(), Dimension::length));
    result += found.prefix().str() + metres;
    rest = found.suffix().str();
  }
  return result + rest;
}

}  // namespace

bool yields(const ContactInputs& inputs, const std::string& body) {
  return std::isfinite(number_of_entry(inputs, body + "/Yield stress", Dimension::pressure, INFINITY));
}

ContactInputs inputs_of(const SolvedCase& solved) {
  ContactInputs inputs;
  for (const auto& [path, text] : solved.entries.all()) {
    const std::string section = path.substr(0, path.find('/'));
    if (section == "Particle" || section == "Substrate" || section == "Interface") inputs[path] = without_seed(text);
  }
  for (const std::string body : {"Particle", "Substrate"})
    if (!yields(inputs, body))
      for (const char* entry : {"/Yield stress", "/Hardening modulus", "/Hardening", "/Voce saturation", "/Voce rate"})
        inputs.erase(body + entry);
  if (number_of_entry(inputs, "Interface/Work of adhesion", Dimension::surface_energy, 0) == 0)
    for (const char* entry : {"Work of adhesion", "Opening work", "Adhesion law", "Adhesion range"})
      inputs.erase(std::string("Interface/") + entry);
  return inputs;
}

std::vector<std::string> differing_entries(const ContactInputs& one, const ContactInputs& other) {
  std::set<std::string> entries;
  for (const auto* inputs : {&one, &other})
    for (const auto& [entry, text] : *inputs) entries.insert(entry);
  std::vector<std::string> names;
  for (const auto& entry : entries) {
    const auto a = one.find(entry), b = other.find(entry);
    if (a == one.end() || b == other.end() || a->second != b->second) names.push_back(entry);
  }
  return names;
}

}  // namespace asperity
