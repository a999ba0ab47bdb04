#include "app/materials.h"

#include <cmath>
#include <limits>
#include <map>

#include "core/error.h"
#include "core/joined.h"
#include "core/nearest_name.h"
#include "core/quantity.h"

namespace asperity {
namespace {

constexpr double GPa = 1e9, infinite = std::numeric_limits<double>::infinity(), tabor_factor = 3;

PublishedNumber in_GPa(double value, double low, double high) { return {value * GPa, low * GPa, high * GPa}; }

const PublishedNumber stays_elastic{infinite, infinite, infinite};

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::size_t first = part.find_first_not_of(' ');
    parts.push_back(first == std::string::npos ? ""
                                               : part.substr(first, part.find_last_not_of(' ') - first + 1));
    begin = end + 1;
  }
  return parts;
}

Material named(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& material : named_materials()) {
    if (material.name == name) return material;
    names.push_back(material.name);
  }
  const std::string meant = nearest_name(name, names);
  throw InputError("there is no material '" + name + "'" +
                   (meant.empty() ? "" : "; did you mean '" + meant + "'?") + "; known are " +
                   joined(names, ", ") + ", or write its numbers: \"E=71 GPa, nu=0.17, hardness=9 GPa\"");
}

/// A number that is positive, and known as well as it is written.
PublishedNumber exact(const std::string& key, const std::string& text) {
  const double value = parse_quantity(text, Dimension::pressure);
  if (!(value > 0)) throw InputError(key + " of a material must be above 0; it is '" + text + "'");
  return {value, value, value};
}

/// In kg/m^3, with or without the unit.
double density_of(std::string text) {
  const std::string unit = "kg/m^3";
  const std::size_t at = text.find(unit);
  if (at != std::string::npos && at + unit.size() == text.size()) text.resize(at);
  const double density = parse_quantity(text, Dimension::none);
  if (!(density > 0)) throw InputError("density of a material must be above 0 kg/m^3");
  return density;
}

Material by_numbers(const std::vector<std::string>& parts, const std::string& text) {
  std::map<std::string, std::string> numbers;
  for (const auto& part : parts) {
    const std::size_t equals = part.find('=');
    const std::string key = part.substr(0, part.find_last_not_of(' ', equals - 1) + 1);
    if (equals == std::string::npos || (key != "E" && key != "nu" && key != "hardness" && key != "density"))
      throw InputError(
          "a material by numbers has E, nu, hardness and density, such as \"E=71 GPa, nu=0.17, "
          "hardness=9 GPa, density=2230 kg/m^3\"; '" +
          part + "' is none of them");
    if (!numbers.emplace(key, part.substr(equals + 1)).second)
      throw InputError("'" + text + "' gives " + key + " twice");
  }
  for (const char* needed : {"E", "nu"})
    if (numbers.count(needed) == 0)
      throw InputError("'" + text + "' lacks " + needed +
                       "; write \"E=71 GPa, nu=0.17\", with hardness=9 GPa where the body yields");
  Material material;
  material.name = text;
  material.youngs_modulus = exact("E", numbers["E"]);
  material.poisson_ratio = parse_quantity(numbers["nu"], Dimension::none);
  if (!(material.poisson_ratio >= 0 && material.poisson_ratio < 0.5))
    throw InputError("nu of a material lies from 0 to 0.5 (excluded); it is '" + numbers["nu"] + "'");
  material.hardness = numbers.count("hardness") > 0 ? exact("hardness", numbers["hardness"]) : stays_elastic;
  if (numbers.count("density") > 0) material.density = density_of(numbers["density"]);
  material.source = "given by the user";
  return material;
}

Material material_of_parts(const std::vector<std::string>& parts, const std::string& text) {
  return parts.size() == 1 && parts[0].find('=') == std::string::npos ? named(parts[0])
                                                                      : by_numbers(parts, text);
}

std::string range_text(const PublishedNumber& number) {
  if (std::isinf(number.value)) return "not modelled: elastic";
  std::string value = format_quantity(number.value, Dimension::pressure);
  if (number.low == number.high) return value;
  return value + " (" + format_quantity(number.low, Dimension::pressure) + " to " +
         format_quantity(number.high, Dimension::pressure) + ")";
}

}  // namespace

double Material::yield_stress() const { return hardness.value / tabor_factor; }

bool Material::yields() const { return std::isfinite(hardness.value); }

const std::vector<Material>& named_materials() {
  // Elastic constants with the name of Oliver & Pharr are those of their reference samples; ranges are what
  // handbooks and indentation give for such materials, wide enough for the usual grades.
  static const std::vector<Material> materials{
      {"borosilicate", in_GPa(71, 61, 75), 0.17, in_GPa(9, 6.5, 9.5), 2230,
       "Fuchs, Weinhart et al. (2014), Table 1 and sec. 4 (hardness: their silica); other borosilicates are "
       "softer, E 61 to 64 GPa"},
      {"diamond", in_GPa(1140, 1050, 1220), 0.07, stays_elastic, 3515,
       "Fuchs, Weinhart et al. (2014), Table 1"},
      {"fused silica", in_GPa(69.3, 69, 73), 0.17, in_GPa(9, 8.5, 9.8), 2200,
       "elastic: Oliver & Pharr (1992); hardness: the usual range of indentation"},
      {"polystyrene", in_GPa(3.4, 2.8, 4.5), 0.33, in_GPa(0.22, 0.17, 0.35), 1050,
       "the usual range of bulk and indentation; rates of strain matter and are not modelled"},
      {"sapphire", in_GPa(403, 390, 440), 0.234, in_GPa(28, 25, 31), 3980,
       "elastic: Oliver & Pharr (1992), c axis; hardness: the usual range of indentation"},
      {"silicon", in_GPa(179, 130, 188), 0.25, in_GPa(12, 10, 13), 2329,
       "elastic: Fuchs, Weinhart et al. (2014), Table 1, the range is that of the crystal's directions; "
       "hardness: the usual range of indentation"},
      {"soda-lime glass", in_GPa(69.9, 68, 74), 0.23, in_GPa(6, 5.5, 6.8), 2500,
       "elastic: Oliver & Pharr (1992); hardness: the usual range of indentation"},
      {"stainless steel", in_GPa(195, 190, 205), 0.29, in_GPa(3, 2, 4.5), 7900,
       "the usual range of austenitic steels; at small depths the hardness is higher"},
      {"tungsten", in_GPa(409.8, 400, 412), 0.28, in_GPa(4.5, 3.5, 7), 19250,
       "elastic: Oliver & Pharr (1992); hardness: the usual range of indentation, higher at small depths"},
  };
  return materials;
}

Material material_of(const std::string& text) { return material_of_parts(parts_of(text), text); }

ParticleText particle_of(const std::string& text) {
  std::vector<std::string> parts = parts_of(text);
  if (parts.size() < 2)
    throw InputError("--particle needs a material and a radius, such as \"borosilicate, 8.5 um\"; it is '" +
                     text + "'");
  std::string radius = parts.back();
  if (radius.rfind("R=", 0) == 0) radius = radius.substr(2);
  parts.pop_back();
  ParticleText particle;
  particle.radius = parse_quantity(radius, Dimension::length);
  if (!(particle.radius > 0))
    throw InputError("the radius of --particle must be above 0; it is '" + radius + "'");
  particle.material = material_of_parts(parts, joined(parts, ", "));
  return particle;
}

std::string materials_page() {
  std::string page =
      "# Materials by name\n\nGenerated by `asperity materials`, for `asperity characterise`. A body yields "
      "at a third of its hardness (Tabor 1951). Each number stands with the\nrange in which published values "
      "of such materials lie; the range of Young's modulus is part of the stated uncertainty of "
      "stiffnesses.\nA material of your own: `--substrate \"E=71 GPa, nu=0.17, hardness=9 GPa, density=2230 "
      "kg/m^3\"`;\n"
      "density is of no account for the contact, but for the particle simulation that its parameters go "
      "into.\n\n| material | Young's modulus E | Poisson's ratio | hardness | density | source |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const auto& material : named_materials())
    page += "| " + material.name + " | " + range_text(material.youngs_modulus) + " | " +
            format_quantity(material.poisson_ratio, Dimension::none) + " | " + range_text(material.hardness) +
            " | " + format_quantity(material.density, Dimension::none) + " kg/m^3 | " + material.source +
            " |\n";
  return page;
}

}  // namespace asperity
