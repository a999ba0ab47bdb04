#include "dem_compare/resistance/contact_inputs.h"

#include <cmath>
#include <set>

#include "core/quantity.h"
#include "dem_compare/surface_text.h"

namespace asperity {
namespace {

/// Number of an entry; `otherwise` where it is missing.
double number_of_entry(const ContactInputs& inputs, const std::string& entry, Dimension dimension, double otherwise) {
  const auto found = inputs.find(entry);
  return found == inputs.end() ? otherwise : parse_quantity(found->second, dimension);
}

}  // namespace

bool yields(const ContactInputs& inputs, const std::string& body) {
  return std::isfinite(number_of_entry(inputs, body + "/Yield stress", Dimension::pressure, INFINITY));
}

ContactInputs inputs_of(const SolvedCase& solved) {
  ContactInputs inputs;
  for (const auto& [path, text] : solved.entries.all()) {
    const std::string section = path.substr(0, path.find('/'));
    if (section == "Particle" || section == "Substrate" || section == "Interface") inputs[path] = surface_without_seed(text);
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
