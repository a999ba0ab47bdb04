#include "results/contact_key.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <set>

#include "core/error.h"
#include "core/quantity.h"
#include "core/topography_spec.h"
#include "results/known_entries.h"

namespace asperity {
namespace {

std::string key_without_blanks(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }),
             text.end());
  return text;
}

/// A text with blanks as single ones and each length as format_quantity() writes it: "slide 0.2 um" as "slide
/// 200 nm".
std::string lengths_in_one_writing(const std::string& text) {
  static const std::regex blanks(R"(\s+)"), length(R"(([0-9.]+(?:e[+-]?[0-9]+)?) ?(pm|nm|um|mm|m)\b)");
  constexpr int digits = 6;
  std::string rest = std::regex_replace(text, blanks, " "), result;
  for (std::smatch found; std::regex_search(rest, found, length); rest = found.suffix().str())
    result += found.prefix().str() +
              format_quantity(parse_quantity(found.str(), Dimension::length), Dimension::length, digits);
  return result + rest;
}

constexpr int digits_of_key = 9;  // more than any two inputs that are meant to be the same differ by

/// In one way of writing, whatever the entry measures.
std::string canonical(const std::string& path, const std::string& text) {
  for (const auto& known : known_quantities())
    if (path == known.path)
      return format_quantity(parse_quantity(text, known.dimension), known.dimension, digits_of_key);
  const bool is_number = !text.empty() && (std::isdigit(static_cast<unsigned char>(text[0])) ||
                                           text[0] == '-' || text[0] == '.');
  if (is_number)
    for (const Dimension dimension :
         {Dimension::none, Dimension::length, Dimension::force, Dimension::pressure, Dimension::time,
          Dimension::angle, Dimension::speed, Dimension::surface_energy, Dimension::area,
          Dimension::stiffness, Dimension::temperature, Dimension::voltage, Dimension::molar_volume}) {
      try {
        return format_quantity(parse_quantity(text, dimension), dimension, digits_of_key);
      } catch (const InputError&) {  // of another dimension
      }
    }
  const std::string topography = "/Topography";
  const bool is_surface = path.size() > topography.size() &&
                          path.compare(path.size() - topography.size(), topography.size(), topography) == 0;
  return is_surface ? key_without_blanks(TopographySpec(text).family()) : lengths_in_one_writing(text);
}

void add_canonical(const SolvedCase& solved, const std::string& path, const std::string& text,
                   ContactInputs& inputs) {
  try {
    inputs[path] = canonical(path, text);
  } catch (const InputError& error) {
    throw InputError(solved.folder.string() + ": " + path + ": " + error.what());
  }
}

bool is_of_section(const std::string& path, const std::string& section) {
  return path.rfind(section + "/", 0) == 0;
}

/// Of a result that does not list them.
ContactInputs inputs_of_earlier_version(const SolvedCase& solved) {
  ContactInputs inputs;
  for (const auto& known : known_words()) inputs[known.path] = known.otherwise;
  for (const auto& known : known_quantities())
    if (*known.otherwise) add_canonical(solved, known.path, known.otherwise, inputs);
  for (const auto& [path, text] : solved.entries.all())
    if (is_of_section(path, "Particle") || is_of_section(path, "Substrate") ||
        is_of_section(path, "Interface"))
      add_canonical(solved, path, text, inputs);
  return inputs;
}

}  // namespace

ContactInputs contact_inputs(const SolvedCase& solved) {
  if (!solved.lists_physical_entries()) return inputs_of_earlier_version(solved);
  ContactInputs inputs;
  for (const auto& [path, text] : solved.result->physical_entries)
    if (!is_of_section(path, "Experiment")) add_canonical(solved, path, text, inputs);
  return inputs;
}

ContactInputs case_inputs(const SolvedCase& solved) {
  ContactInputs inputs = contact_inputs(solved);
  for (const auto& [path, text] : solved.entries.all())
    if (is_of_section(path, "Experiment")) add_canonical(solved, path, text, inputs);
  return inputs;
}

bool yields(const ContactInputs& inputs, const std::string& body) {
  const auto found = inputs.find(body + "/Yield stress");
  return found != inputs.end() && std::isfinite(parse_quantity(found->second, Dimension::pressure));
}

bool relaxes(const ContactInputs& inputs, const std::string& body) {
  const auto found = inputs.find(body + "/Relaxing share");
  return found != inputs.end() && parse_quantity(found->second, Dimension::none) > 0;
}

bool adheres(const ContactInputs& inputs) {
  const auto is_given = [&](const char* entry, Dimension dimension) {
    const auto found = inputs.find(entry);
    return found != inputs.end() && parse_quantity(found->second, dimension) > 0;
  };
  return is_given("Interface/Work of adhesion", Dimension::surface_energy) ||
         is_given("Interface/Work of adhesion on separation", Dimension::surface_energy) ||
         is_given("Interface/Attraction force", Dimension::force) ||
         is_given("Interface/Relative humidity", Dimension::none) ||
         is_given("Interface/Patch potential", Dimension::voltage);
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

std::string realisation_of(const SolvedCase& solved) {
  return key_without_blanks(solved.entries.topography("Particle").canonical() + " on " +
                            solved.entries.topography("Substrate").canonical());
}

}  // namespace asperity
