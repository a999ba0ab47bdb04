// parameters.json: reading with errors that name file, key and remedy; writing.
#include <algorithm>
#include <cmath>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_entries.h"
#include "core/printable.h"
#include "core/quantity.h"
#include "core/text_file.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {
namespace {

constexpr const char* format_name = "asperity-parameters/1";

/// A text of the file as a message shows it: on one line.
std::string quoted(const std::string& text) { return "'" + printable(text) + "'"; }

/// A plain SI number or a text with its unit ("8.5 um"), above zero.
double body_number(const Json& object, const char* key, Dimension dimension, const std::string& where,
                   const std::string& file) {
  if (!object.contains(key)) return std::numeric_limits<double>::quiet_NaN();
  const std::string path = where + "/" + key;
  const double value = quantity_of(object[key], dimension, path, file);
  const bool may_be_zero = dimension == Dimension::none || std::string(key) == "rms";  // a smooth surface
  if (!(value > 0) && !(may_be_zero && value == 0)) refuse(file, "'" + path + "' must be above zero");
  return value;
}

ContactBody parse_body(const Json& json, const char* name, bool is_target, const std::string& file) {
  if (!json.contains(name)) refuse(file, std::string("'") + name + "' is missing");
  const Json& object = json[name];
  std::vector<std::string> known{"material", "radius", "youngs_modulus", "poissons_ratio", "density", "rms"};
  if (is_target) known.insert(known.begin(), "geometry");
  check_keys(object, known, name, file);
  ContactBody body;
  body.material = text_of(object, "material", "", file, std::string(name) + "/");
  body.youngs_modulus = body_number(object, "youngs_modulus", Dimension::pressure, name, file);
  body.poissons_ratio = body_number(object, "poissons_ratio", Dimension::none, name, file);
  body.density = body_number(object, "density", Dimension::none, name, file);
  body.rms = body_number(object, "rms", Dimension::length, name, file);
  body.radius = body_number(object, "radius", Dimension::length, name, file);
  const std::string geometry =
      is_target ? text_of(object, "geometry", "", file, std::string(name) + "/") : "sphere";
  if (geometry == "plane")
    body.radius = std::numeric_limits<double>::infinity();
  else if (geometry != "sphere")
    refuse(file,
           std::string("'") + name + "/geometry' is " + quoted(geometry) + "; it must be plane or sphere");
  else if (std::isnan(body.radius))
    refuse(file, std::string("'") + name + "/radius' is missing");
  return body;
}

EffectiveQuantity parse_quantity_entry(const Json& object, const QuantityEntry& entry,
                                       const std::string& file) {
  const std::string where = std::string("quantities/") + entry.key;
  check_keys(object, {"value", "unit", "sd", "load_range", "length_scale", "at_load", "provenance"}, where,
             file);
  if (!object.contains("value")) refuse(file, "'" + where + "' has no value");
  EffectiveQuantity quantity;
  quantity.value = finite_number(object["value"], where + "/value", file);
  const std::string unit = text_of(object, "unit", "", file, where + "/");
  if (unit != entry.unit)
    refuse(file, "'" + where + "' has the unit " + quoted(unit) + "; it must be in SI: '" + entry.unit + "'");
  if (object.contains("sd") && !object["sd"].is_null()) {
    quantity.sd = finite_number(object["sd"], where + "/sd", file);
    if (quantity.sd < 0) refuse(file, "'" + where + "/sd' is below zero");
  }
  if (object.contains("load_range") && !object["load_range"].is_null()) {
    const Json& range = object["load_range"];
    if (!range.is_array() || range.size() != 2)
      refuse(file, "'" + where + "/load_range' must be [lowest, highest] in N");
    quantity.load_range = LoadRange{finite_number(range[0], where + "/load_range", file),
                                    finite_number(range[1], where + "/load_range", file)};
    if (!(quantity.load_range->low > 0 && quantity.load_range->high >= quantity.load_range->low))
      refuse(file, "'" + where + "/load_range' must be two loads above zero, the lowest first");
  }
  const std::string scale = text_of(object, "length_scale", "", file, where + "/");
  if (scale == "r")
    quantity.length_scale = LengthScale::particle_radius;
  else if (scale == "a")
    quantity.length_scale = LengthScale::contact_radius;
  else if (!scale.empty())
    refuse(file,
           "'" + where + "/length_scale' is " + quoted(scale) + "; it must be r (particle) or a (contact)");
  if (object.contains("at_load"))
    quantity.at_load = finite_number(object["at_load"], where + "/at_load", file);
  quantity.provenance = text_of(object, "provenance", "", file, where + "/");
  return quantity;
}

bool is_stiffness(const QuantityEntry& entry) {
  return std::string(entry.key).find("_stiffness") != std::string::npos;
}

/// What a value must have to mean anything.
void check(const EffectiveQuantity& quantity, const QuantityEntry& entry, const std::string& file) {
  const std::string key = entry.key, where = "quantities/" + key;
  const bool is_offset = key.find("_offset") != std::string::npos || key == "pull_off_force";
  const bool is_torque_coefficient = key == "rolling_friction" || key == "torsion_friction";
  if (!is_offset && quantity.value < 0) refuse(file, "'" + where + "/value' is below zero");
  if ((key == "reduced_modulus" || key == "reduced_shear_modulus") && quantity.value == 0)
    refuse(file, "'" + where + "/value' is zero");
  if (is_torque_coefficient && quantity.length_scale == LengthScale::none)
    refuse(file, "'" + where + "' has no length_scale; it must be r (particle) or a (contact)");
  if (is_stiffness(entry) && quantity.length_scale == LengthScale::none)
    refuse(file, "'" + where +
                     "' has no length_scale; it must be r (constant) or a (grows with the contact radius)");
  if (is_stiffness(entry) && quantity.length_scale == LengthScale::contact_radius && !(quantity.at_load > 0))
    refuse(file, "'" + where + "' has no at_load, the normal load [N] at which it was found");
}

Json body_json(const ContactBody& body, bool is_target) {
  Json json;
  if (is_target) json["geometry"] = body.is_plane() ? "plane" : "sphere";
  if (!body.material.empty()) json["material"] = body.material;
  const auto put = [&](const char* key, double value) {
    if (std::isfinite(value)) json[key] = value;
  };
  put("radius", body.radius);
  put("youngs_modulus", body.youngs_modulus);
  put("poissons_ratio", body.poissons_ratio);
  put("density", body.density);
  put("rms", body.rms);
  return json;
}

}  // namespace

ContactParameters parse_contact_parameters(const Json& json, const std::string& file) {
  if (!json.is_object()) refuse(file, "it is not a JSON object { }");
  const std::string format = text_of(json, "format", "", file);
  if (format != format_name)
    refuse(file, "its format is " + quoted(format) + "; this program reads '" + format_name + "'");
  check_keys(json, {"format", "title", "particle", "target", "quantities", "derivation"}, "the record", file);
  ContactParameters parameters;
  parameters.file = file;
  parameters.title = text_of(json, "title", "", file);
  parameters.particle = parse_body(json, "particle", false, file);
  parameters.target = parse_body(json, "target", true, file);
  if (json.contains("derivation")) parameters.derivation = json["derivation"];
  if (!json.contains("quantities")) refuse(file, "'quantities' is missing");
  std::vector<std::string> known;
  for (const auto& entry : quantity_entries()) known.push_back(entry.key);
  check_keys(json["quantities"], known, "quantities", file);
  for (const auto& entry : quantity_entries()) {
    if (!json["quantities"].contains(entry.key)) continue;
    const EffectiveQuantity quantity = parse_quantity_entry(json["quantities"][entry.key], entry, file);
    check(quantity, entry, file);
    parameters.*entry.member = quantity;
  }
  for (const auto member : {&ContactParameters::reduced_modulus, &ContactParameters::reduced_shear_modulus})
    if (!(parameters.*member))
      refuse(file, std::string("'quantities' has no '") +
                       (member == &ContactParameters::reduced_modulus ? "reduced_modulus"
                                                                      : "reduced_shear_modulus") +
                       "'");
  parameters.load_range(&ContactParameters::sliding_friction, &ContactParameters::sliding_offset);
  parameters.load_range(&ContactParameters::rolling_friction, &ContactParameters::rolling_offset);
  parameters.load_range(&ContactParameters::torsion_friction, &ContactParameters::torsion_offset);
  return parameters;
}

ContactParameters read_contact_parameters(const std::filesystem::path& file) {
  return parse_contact_parameters(parse_json(read_text_file(file), file.string()), file.string());
}

Json to_json(const ContactParameters& parameters) {
  Json json;
  json["format"] = format_name;
  if (!parameters.title.empty()) json["title"] = parameters.title;
  json["particle"] = body_json(parameters.particle, false);
  json["target"] = body_json(parameters.target, true);
  json["quantities"] = Json::object();
  for (const auto& entry : quantity_entries()) {
    const auto& quantity = parameters.*entry.member;
    if (!quantity) continue;
    Json& object = json["quantities"][entry.key];
    object["value"] = quantity->value;
    object["unit"] = entry.unit;
    if (std::isfinite(quantity->sd)) object["sd"] = quantity->sd;
    if (quantity->load_range) object["load_range"] = {quantity->load_range->low, quantity->load_range->high};
    if (quantity->length_scale != LengthScale::none)
      object["length_scale"] = quantity->length_scale == LengthScale::particle_radius ? "r" : "a";
    if (std::isfinite(quantity->at_load)) object["at_load"] = quantity->at_load;
    if (!quantity->provenance.empty()) object["provenance"] = quantity->provenance;
  }
  if (!parameters.derivation.is_null()) json["derivation"] = parameters.derivation;
  return json;
}

void write_contact_parameters(const ContactParameters& parameters, const std::filesystem::path& file) {
  write_file_atomically(file, to_json(parameters).dump(1) + "\n");
}

}  // namespace asperity
