// The channels a table may hold, and the modes of motion, by name.

#include "core/error.h"
#include "core/joined.h"
#include "core/nearest_name.h"
#include "diagnosis/recording/recording.h"

namespace asperity {
namespace {

const std::string sd = "_sd";

const std::vector<std::pair<std::string, Dimension>>& channels() {
  static const std::vector<std::pair<std::string, Dimension>> list{
      {"run", Dimension::none},
      {"cycle", Dimension::none},
      {"time", Dimension::time},
      {"normal_displacement", Dimension::length},
      {"normal_force", Dimension::force},
      {"lateral_displacement", Dimension::length},
      {"lateral_force", Dimension::force},
      {"speed", Dimension::speed},
      {"radius", Dimension::length},
      {"rms_roughness", Dimension::length},
      {"rail_angle", Dimension::angle},
      {"humidity", Dimension::none}};
  return list;
}

std::string remedy(const std::string& written, const std::vector<std::string>& names) {
  return did_you_mean(written, names, "use one of " + joined(names, ", "));
}

}  // namespace

Motion mode_of(const std::string& written) {
  std::vector<std::string> names;
  for (const Motion mode : all_modes()) {
    if (name_of(mode) == written) return mode;
    names.push_back(name_of(mode));
  }
  throw InputError("there is no mode '" + written + "'; " + remedy(written, names));
}

std::vector<Motion> all_modes() {
  return {Motion::normal, Motion::sliding, Motion::rolling, Motion::rail, Motion::torsion};
}

std::vector<std::string> known_channels() {
  std::vector<std::string> names;
  for (const auto& entry : channels()) names.push_back(entry.first);
  return names;
}

bool is_deviation(const std::string& channel) {
  return channel.size() > sd.size() && channel.compare(channel.size() - sd.size(), sd.size(), sd) == 0;
}

Dimension dimension_of_channel(const std::string& channel) {
  const std::string base = is_deviation(channel) ? channel.substr(0, channel.size() - sd.size()) : channel;
  for (const auto& [name, dimension] : channels())
    if (name == base) return dimension;
  throw InputError("there is no channel '" + channel + "'; " + remedy(base, known_channels()));
}

std::string unit_of_channel(const std::string& channel) { return si_symbol(dimension_of_channel(channel)); }

}  // namespace asperity
