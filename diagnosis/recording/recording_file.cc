// recording.json: reading with refusals that name file and entry; writing.
#include <algorithm>
#include <cmath>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_entries.h"
#include "core/output_folder.h"
#include "core/text_file.h"
#include "diagnosis/recording/force_sign.h"
#include "diagnosis/recording/recording.h"
#include "diagnosis/recording/recording_table_file.h"
#include "diagnosis/recording/segment_names.h"
#include "diagnosis/recording/simulation_json.h"
#include "diagnosis/recording/time_from_path.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr const char* recording_format = "asperity-recording/1";

double positive(const Json& object, const char* key, Dimension dimension, const std::string& where,
                const std::string& file) {
  if (!object.contains(key)) return RecordedBody::unknown;
  const double value = quantity_of(object[key], dimension, where + "/" + key, file);
  if (value <= 0) refuse(file, "'" + where + "/" + key + "' must be above zero");
  return value;
}

RecordedBody body_of(const Json& json, const std::string& where, const std::string& file) {
  check_keys(json,
             {"material", "youngs_modulus", "poissons_ratio", "radius", "rms_roughness", "yield_stress"},
             where, file);
  RecordedBody body;
  body.material = text_of(json, "material", "", file);
  body.youngs_modulus = positive(json, "youngs_modulus", Dimension::pressure, where, file);
  if (json.contains("poissons_ratio"))
    body.poissons_ratio =
        quantity_of(json["poissons_ratio"], Dimension::none, where + "/poissons_ratio", file);
  body.radius = positive(json, "radius", Dimension::length, where, file);
  if (json.contains("rms_roughness"))
    body.rms_roughness =
        quantity_of(json["rms_roughness"], Dimension::length, where + "/rms_roughness", file);
  body.yield_stress = positive(json, "yield_stress", Dimension::pressure, where, file);
  return body;
}

RecordingTable table_of(const Json& json, Motion mode, const fs::path& folder, const std::string& file) {
  check_keys(json, {"file", "kind", "control", "response", "at"}, "tables", file);
  RecordingTable table;
  table.file = text_of(json, "file", "", file);
  if (table.file.empty()) refuse(file, "a table lacks its 'file'");
  const std::string kind = text_of(json, "kind", "trace", file);
  if (kind != "trace" && kind != "series")
    refuse(file, "'kind' of " + table.file + " is '" + kind + "'; use trace or series");
  table.kind = kind == "trace" ? TableKind::trace : TableKind::series;
  const std::string at = text_of(json, "at", "indenter", file);
  if (at != "indenter" && at != "substrate")
    refuse(file, "'at' of " + table.file + " is '" + at + "'; use indenter or substrate");
  table.at = at == "indenter" ? ForcePlace::indenter : ForcePlace::substrate;
  if (json.contains("control")) {
    if (json["control"].is_string()) {
      table.control = {json["control"].get<std::string>()};
    } else {
      if (!json["control"].is_array())
        refuse(file, "'control' of " + table.file + " is not a list of channels");
      for (const auto& channel : json["control"]) {
        if (!channel.is_string())
          refuse(file, "'control' of " + table.file + " holds something that is not a channel's name");
        table.control.push_back(channel.get<std::string>());
      }
    }
  }
  read_table_file(folder / table.file, table);
  if (table.control.empty()) {
    if (mode == Motion::normal)
      table.control = {"normal_displacement"};
    else if (table.kind == TableKind::trace)
      table.control = {"lateral_displacement", "normal_force"};
    else
      table.control = {"normal_force"};
  }
  table.response = text_of(json, "response", mode == Motion::normal ? "normal_force" : "lateral_force", file);
  return table;
}

Json body_json(const RecordedBody& body) {
  Json json = Json::object();
  if (!body.material.empty()) json["material"] = body.material;
  if (std::isfinite(body.youngs_modulus)) json["youngs_modulus"] = body.youngs_modulus;
  if (std::isfinite(body.poissons_ratio)) json["poissons_ratio"] = body.poissons_ratio;
  if (std::isfinite(body.radius)) json["radius"] = body.radius;
  json["rms_roughness"] = body.rms_roughness;
  if (std::isfinite(body.yield_stress)) json["yield_stress"] = body.yield_stress;
  return json;
}

}  // namespace

Recording read_recording(const fs::path& given) {
  const fs::path path = fs::is_directory(given) ? given / "recording.json" : given;
  const std::string file = path.string();
  Recording recording;
  recording.folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const Json json = parse_json(read_text_file(path), file);
  check_keys(json,
             {"format", "title", "mode", "particle", "substrate", "indenter", "rail_angle", "simulation",
              "noise", "tables"},
             "the recording", file);
  if (text_of(json, "format", "", file) != recording_format)
    refuse(file, "'format' is not '" + std::string(recording_format) + "'");
  recording.title = text_of(json, "title", "", file);
  try {
    recording.mode = mode_of(text_of(json, "mode", "", file));
  } catch (const InputError& error) {
    refuse(file, error.what());
  }
  if (!json.contains("particle") || !json.contains("substrate"))
    refuse(file, "it needs a 'particle' and a 'substrate'");
  recording.particle = body_of(json["particle"], "particle", file);
  recording.substrate = body_of(json["substrate"], "substrate", file);
  if (json.contains("indenter")) recording.indenter = body_of(json["indenter"], "indenter", file);
  if (json.contains("rail_angle"))
    recording.rail_angle = quantity_of(json["rail_angle"], Dimension::angle, "rail_angle", file);
  recording.simulation_is_given = json.contains("simulation");
  if (recording.simulation_is_given) recording.simulation = simulation_of(json["simulation"], file);
  if (json.contains("noise")) {
    if (!json["noise"].is_object()) refuse(file, "'noise' is not an object { }");
    for (const auto& item : json["noise"].items()) {
      try {
        recording.noise[item.key()] =
            quantity_of(item.value(), dimension_of_channel(item.key()), "noise/" + item.key(), file);
      } catch (const InputError& error) {
        const std::string what = error.what();
        if (what.rfind(file, 0) == 0) throw;
        refuse(file, "'noise': " + what);
      }
    }
  }
  if (!json.contains("tables") || !json["tables"].is_array() || json["tables"].empty())
    refuse(file, "it needs a list of 'tables'");
  for (const auto& table : json["tables"])
    recording.tables.push_back(table_of(table, recording.mode, recording.folder, file));
  check_recording(recording);
  for (const auto& remarks : {remarks_on_segments(recording), remarks_on_time(recording)})
    recording.remarks.insert(recording.remarks.end(), remarks.begin(), remarks.end());
  turn_signs_to_dissipate(recording);
  return recording;
}

void write_recording(const Recording& recording, const fs::path& folder) {
  make_folder(folder);
  Json json;
  json["format"] = recording_format;
  json["title"] = recording.title;
  json["mode"] = name_of(recording.mode);
  json["particle"] = body_json(recording.particle);
  json["substrate"] = body_json(recording.substrate);
  if (recording.indenter) json["indenter"] = body_json(*recording.indenter);
  if (std::isfinite(recording.rail_angle)) json["rail_angle"] = recording.rail_angle;
  if (recording.simulation_is_given) json["simulation"] = simulation_json(recording.simulation);
  if (!recording.noise.empty()) {
    json["noise"] = Json::object();
    for (const auto& [channel, sd] : recording.noise) json["noise"][channel] = sd;
  }
  json["tables"] = Json::array();
  for (const auto& table : recording.tables) {
    Json entry = {{"file", table.file},
                  {"kind", table.kind == TableKind::trace ? "trace" : "series"},
                  {"control", table.control},
                  {"response", table.response}};
    if (table.at == ForcePlace::substrate) entry["at"] = "substrate";
    json["tables"].push_back(entry);
    write_file_atomically(folder / table.file, format_table_file(table));
  }
  write_file_atomically(folder / "recording.json", json.dump(1) + "\n");
}

}  // namespace asperity
