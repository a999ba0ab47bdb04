#include "results/known_entries.h"

#include <cctype>

namespace asperity {

const std::vector<KnownEntry>& known_quantities() {
  static const std::vector<KnownEntry> entries{
      {"Particle/Radius", Dimension::length, ""},
      {"Particle/Young modulus", Dimension::pressure, ""},
      {"Particle/Poisson ratio", Dimension::none, ""},
      {"Particle/Yield stress", Dimension::pressure, "inf"},
      {"Particle/Hardening modulus", Dimension::pressure, "0"},
      {"Particle/Voce saturation", Dimension::pressure, "0"},
      {"Particle/Voce rate", Dimension::none, "0"},
      {"Substrate/Young modulus", Dimension::pressure, ""},
      {"Substrate/Poisson ratio", Dimension::none, ""},
      {"Substrate/Yield stress", Dimension::pressure, "inf"},
      {"Substrate/Hardening modulus", Dimension::pressure, "0"},
      {"Substrate/Voce saturation", Dimension::pressure, "0"},
      {"Substrate/Voce rate", Dimension::none, "0"},
      {"Interface/Friction coefficient", Dimension::none, "0"},
      {"Interface/Shear strength", Dimension::pressure, "0"},
      {"Interface/Work of adhesion", Dimension::surface_energy, "0"},
      {"Interface/Work of adhesion on separation", Dimension::surface_energy, "0"},
      {"Interface/Adhesion range", Dimension::length, "0"}};
  return entries;
}

const std::vector<KnownEntry>& known_words() {
  static const std::vector<KnownEntry> words{{"Particle/Hardening", Dimension::none, "isotropic"},
                                             {"Particle/Topography", Dimension::none, "smooth"},
                                             {"Substrate/Hardening", Dimension::none, "isotropic"},
                                             {"Substrate/Topography", Dimension::none, "smooth"},
                                             {"Interface/Adhesion law", Dimension::none, "dugdale"}};
  return words;
}

bool is_known_entry(const std::string& path) {
  for (const auto* entries : {&known_quantities(), &known_words()})
    for (const auto& entry : *entries)
      if (path == entry.path) return true;
  return false;
}

std::string result_name(std::string entry) {
  for (char& c : entry) c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return entry;
}

}  // namespace asperity
