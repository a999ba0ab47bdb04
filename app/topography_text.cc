#include "app/topography_text.h"

#include <algorithm>
#include <cstdlib>

#include "app/nearest_name.h"
#include "core/error.h"
#include "core/quantity.h"

namespace asperity {
namespace {

const std::string generated = "generated";
constexpr int default_seed = 1;

std::string trim(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

int seed_number(const std::string& text) {
  char* end = nullptr;
  const long seed = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || seed < 0 || seed > 2147483647L)
    throw InputError("the seed of generated(...) is a whole number from 0 to 2147483647, not '" + text + "'");
  return static_cast<int>(seed);
}

void check_argument(const std::string& name, const std::string& value) {
  if (name == "seed") {
    seed_number(value);
  } else if (name == "hurst") {
    const double hurst = parse_quantity(value, Dimension::none);
    if (!(hurst > 0 && hurst <= 1))
      throw InputError("the Hurst exponent of generated(...) lies above 0 and up to 1, not at " + value);
  } else if (name == "rms" || name == "rolloff" || name == "cutoff") {
    if (!(parse_quantity(value, Dimension::length) > 0))
      throw InputError("'" + name + "' of generated(...) is a length above 0, not " + value);
  } else {
    const std::string meant = nearest_name(name, {"rms", "hurst", "rolloff", "cutoff", "seed"});
    throw InputError("generated(...) has no '" + name + "'; " +
                     (meant.empty() ? "it has rms, hurst, rolloff, cutoff and seed" : "did you mean '" + meant + "'?"));
  }
}

}  // namespace

bool is_smooth(const std::string& topography) { return topography == "smooth"; }

bool is_generated(const std::string& topography) {
  return topography.rfind(generated, 0) == 0 && trim(topography.substr(generated.size())).rfind("(", 0) == 0;
}

std::vector<std::string> split_outside_parentheses(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == separator && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (auto& part : parts) part = trim(part);
  return parts;
}

std::vector<std::pair<std::string, std::string>> generated_arguments(const std::string& topography) {
  const std::string call = trim(topography);
  const auto open = call.find('(');
  if (open == std::string::npos || call.back() != ')')
    throw InputError("'" + topography + "' lacks a parenthesis; write generated(rms=1.5 nm, rolloff=200 nm, seed=3)");
  std::vector<std::pair<std::string, std::string>> arguments;
  for (const auto& argument : split_outside_parentheses(call.substr(open + 1, call.size() - open - 2), ',')) {
    const auto equals = argument.find('=');
    if (equals == std::string::npos)
      throw InputError("'" + argument + "' in generated(...) lacks '='; write for example rms=1.5 nm");
    arguments.emplace_back(trim(argument.substr(0, equals)), trim(argument.substr(equals + 1)));
    check_argument(arguments.back().first, arguments.back().second);
  }
  const auto rms = std::find_if(arguments.begin(), arguments.end(), [](const auto& a) { return a.first == "rms"; });
  if (rms == arguments.end())
    throw InputError("generated(...) needs the roughness to generate; add for example rms=1.5 nm");
  return arguments;
}

int generated_seed(const std::string& topography) {
  for (const auto& [name, value] : generated_arguments(topography))
    if (name == "seed") return seed_number(value);
  return default_seed;
}

std::string with_seed(const std::string& topography, int seed) {
  std::string text;
  for (const auto& [name, value] : generated_arguments(topography))
    if (name != "seed") text += name + "=" + value + ", ";
  return generated + "(" + text + "seed=" + std::to_string(seed) + ")";
}

}  // namespace asperity
