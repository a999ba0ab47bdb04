#include "app/characterise_request.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/length_argument.h"
#include "core/error.h"
#include "core/joined.h"
#include "core/quantity.h"

namespace asperity {
namespace {

/// Local friction is an input that only an experiment can tell; between dry minerals it lies in this range.
constexpr double lowest_friction = 0.1, highest_friction = 0.5;
constexpr double quick_time = 120;

/// "30 uN to 300 uN" as its two parts; one where there is no "to".
std::vector<std::string> ends_of(const std::string& text) {
  const std::string between = " to ";
  const std::size_t at = text.find(between);
  if (at == std::string::npos) return {text};
  return {text.substr(0, at), text.substr(at + between.size())};
}

std::vector<double> range_of(const std::string& option, const std::string& text, Dimension dimension,
                             const std::string& example) {
  std::vector<double> values;
  for (const auto& end : ends_of(text)) values.push_back(parse_quantity(end, dimension));
  const bool positive = std::all_of(values.begin(), values.end(),
                                    [](double value) { return value > 0 && std::isfinite(value); });
  if (!positive || !std::is_sorted(values.begin(), values.end()))
    throw InputError(option + " must be above 0, one value or a rising range such as \"" + example +
                     "\"; it is '" + text + "'");
  if (values.size() == 2 && values[0] == values[1]) values.pop_back();
  return values;
}

double accuracy_of(const std::string& text) {
  const bool percent = !text.empty() && text.back() == '%';
  const double value = parse_quantity(percent ? text.substr(0, text.size() - 1) : text, Dimension::none) *
                       (percent ? 0.01 : 1);
  if (!(value > 0 && value < 1))
    throw InputError("--accuracy lies between 0 and 100 %, such as 15%; it is '" + text + "'");
  return value;
}

double time_of(const std::string& text) {
  const double value = parse_quantity(text, Dimension::time);
  if (!(value > 0)) throw InputError("--time must be above 0, such as \"20 min\"; it is '" + text + "'");
  return value;
}

AdhesionRequest adhesion_of(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw InputError(
        "--adhesion needs the work of adhesion and the range of the attraction, such as "
        "\"77 mJ/m^2, 1 nm\"; it is '" +
        text + "'");
  AdhesionRequest adhesion;
  adhesion.work = parse_quantity(text.substr(0, comma), Dimension::surface_energy);
  adhesion.range = parse_quantity(text.substr(comma + 1), Dimension::length);
  if (!(adhesion.work > 0 && adhesion.range > 0))
    throw InputError("work and range of --adhesion must be above 0; it is '" + text + "'");
  return adhesion;
}

SurfaceFrom surface_from(const std::string& text) {
  if (text == "auto") return SurfaceFrom::automatic;
  if (text == "scan") return SurfaceFrom::scan;
  if (text == "spectrum") return SurfaceFrom::spectrum;
  throw InputError("--surface is auto, scan or spectrum; it is '" + text + "'");
}

ScanParameters scan_of(const std::string& file, const CharacteriseArguments& arguments) {
  for (const unsigned char c : file)
    if (c < ' ')
      throw InputError(
          "a scan's file name has a control character, which a case file cannot hold; rename it");
  ScanParameters scan;
  scan.file = std::filesystem::absolute(file).string();
  scan.level = parse_level(arguments.level);
  if (!arguments.size.empty()) scan.options.size_x_m = length_argument("--size", arguments.size);
  if (!arguments.height_unit.empty()) scan.options.height_unit = arguments.height_unit;
  if (!arguments.channel.empty()) scan.options.channel = arguments.channel;
  return scan;
}

}  // namespace

Hertz smooth_contact(const CharacteriseRequest& request) {
  const auto body = [](const Material& material) {
    return ElasticBody{material.youngs_modulus.value, material.poisson_ratio};
  };
  return {reduced_modulus(body(request.particle.material), body(request.substrate)), request.particle.radius};
}

CharacteriseRequest request_of(const CharacteriseArguments& arguments) {
  if (arguments.scans.empty() || arguments.scans.size() > 2)
    throw InputError("characterise takes one scan, of the substrate, or two, the second of the particle");
  CharacteriseRequest request;
  request.substrate_scan = scan_of(arguments.scans[0], arguments);
  if (arguments.scans.size() == 2) {
    request.particle_scan = scan_of(arguments.scans[1], arguments);
    // A sphere's own curvature is its radius, not roughness.
    if (request.particle_scan->level == Level::plane) request.particle_scan->level = Level::quadratic;
  }
  request.surface = surface_from(arguments.surface);
  request.particle = particle_of(arguments.particle);
  request.substrate = material_of(arguments.substrate);
  request.loads = range_of("--loads", arguments.loads, Dimension::force, "30 uN to 300 uN");
  request.friction_is_known = !arguments.friction.empty();
  request.friction = request.friction_is_known
                         ? range_of("--friction", arguments.friction, Dimension::none, "0.2 to 0.4")
                         : std::vector<double>{lowest_friction, highest_friction};
  if (!arguments.adhesion.empty()) request.adhesion = adhesion_of(arguments.adhesion);
  request.accuracy = accuracy_of(arguments.accuracy);
  request.quick = arguments.quick;
  if (request.quick && request.friction.size() == 2)
    request.friction = {std::sqrt(request.friction[0] * request.friction[1])};
  request.time = arguments.quick ? quick_time : time_of(arguments.time);
  return request;
}

}  // namespace asperity
