// NanoScope files of Digital Instruments, Veeco and Bruker (.spm, .di, .001, ...), software version 4.3 and
// later.
//
// A header of lines "\Key: value" in sections "\*Name" is followed by the images as little-endian integers,
// bottom row first whatever the scan direction was. Height = stored / 2^(8 Bytes/pixel) * hard value of "@2:Z
// scale" * the sensitivity it names (Bruker, NanoScope 8.10 user guide, appendix on file formats). Since
// version 9.2 every image is stored in 32 bits, while Bytes/pixel remains that of the scaling. Checked
// against two real files of versions 7.2 and 10 (16 and 32 bit) in the tests.
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/nanoscope_header.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

/// One channel with its scale resolved.
struct Image {
  std::string name, direction, unit, scale_text;
  double metres_per_step = 0;  ///< 0 if its values are no lengths
};

std::string entry(const SourceFile& file, const NanoscopeSection& section, const std::string& key) {
  const auto found = section.find(key);
  if (found == section.end())
    throw InputError(file.name() + " lacks '" + key +
                     "' in its NanoScope header; open it in Gwyddion and pass a .gsf");
  return found->second;
}

constexpr double most_pixels_along = 1 << 20;
constexpr double most_bytes = 1e12;

std::size_t whole_entry(const SourceFile& file, const NanoscopeSection& section, const std::string& key,
                        double most) {
  const auto number = whole_number_text(entry(file, section, key));
  if (!number || !(*number >= 0) || *number > most || *number != std::floor(*number))
    throw InputError(file.name() + " has '" + entry(file, section, key) + "' for '" + key +
                     "' in its NanoScope header, so it is damaged; export it again");
  return static_cast<std::size_t>(*number);
}

/// Factor from "V", "mV", ... to V; empty for anything else.
std::optional<double> volt_factor(const std::string& unit) {
  static const std::map<std::string, double> volts{{"V", 1.0}, {"mV", 1e-3}, {"uV", 1e-6}, {"kV", 1e3}};
  const auto found = volts.find(unit);
  return found == volts.end() ? std::nullopt : std::optional<double>(found->second);
}

/// Scale of an entry such as "V [Sens. Zsens] (0.005035400 V/LSB) 329.9950 V" with "V 22.25786 nm/V" for
/// Sens. Zsens.
void resolve_scale(const NanoscopeHeader& header, const NanoscopeSection& section, std::size_t scaling_bytes,
                   Image& image) {
  auto found = section.find("@2:z scale");
  if (found == section.end()) found = section.find("@4:z scale");
  if (found == section.end()) return;
  static const std::regex scale_form(R"(V\s*(?:\[([^\]]*)\])?\s*\(.*\)\s*([-+0-9.eE]+)\s*(.*))");
  std::smatch parts;
  constexpr std::size_t longest = 1000;  // characters: std::regex recurses from one to the next
  if (found->second.size() > longest || !std::regex_match(found->second, parts, scale_form)) return;
  const double hard_value = std::atof(parts[2].str().c_str());
  const std::string hard_unit = trimmed_text(parts[3].str());
  const double steps = std::ldexp(1.0, static_cast<int>(8 * scaling_bytes));
  const std::string over_steps = " over 2^" + std::to_string(8 * scaling_bytes) + " steps";
  image.unit = hard_unit;
  if (!parts[1].matched) {
    if (const auto factor = length_unit_factor(hard_unit)) {
      image.metres_per_step = hard_value * *factor / steps;
      image.scale_text = parts[2].str() + " " + plain_unit(hard_unit) + over_steps;
    }
    return;
  }
  const auto sensitivity = header.instrument.find("@" + lower_case(parts[1].str()));
  if (sensitivity == header.instrument.end()) return;
  static const std::regex sensitivity_form(R"(V\s+([-+0-9.eE]+)\s+([^/\s]+)/(\S+))");
  std::smatch soft;
  if (!std::regex_match(sensitivity->second, soft, sensitivity_form)) return;
  image.unit = plain_unit(soft[2].str());
  const auto length = length_unit_factor(soft[2].str());
  const auto from_hard = volt_factor(hard_unit), from_soft = volt_factor(soft[3].str());
  if (!length || !from_hard || !from_soft) return;
  image.metres_per_step =
      hard_value * (*from_hard / *from_soft) * std::atof(soft[1].str().c_str()) * *length / steps;
  image.scale_text = soft[1].str() + " " + image.unit + "/" + soft[3].str() + " x " + parts[2].str() + " " +
                     hard_unit + over_steps;
}

std::size_t stored_bytes_per_pixel(const SourceFile& file, const NanoscopeHeader& header, std::size_t points,
                                   std::size_t length) {
  for (const std::size_t bytes : {2, 4})
    if (length == bytes * points) return bytes;
  constexpr long first_version_with_32_bit = 0x09200000;
  const auto version = header.file_list.find("version");
  const bool wide = version != header.file_list.end() &&
                    std::strtol(version->second.c_str(), nullptr, 16) >= first_version_with_32_bit;
  const std::size_t bytes = wide ? 4 : 2;
  if (length < bytes * points)
    throw InputError(file.name() + " keeps " + std::to_string(length) + " bytes for " +
                     std::to_string(points) +
                     " pixels, which is too few; open it in Gwyddion and pass a .gsf");
  return bytes;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const NanoscopeHeader header = nanoscope_header(file);
  if (header.images.empty())
    throw InputError(file.name() + " is a NanoScope file without images; pass a file of an image scan");
  std::vector<Image> images;
  std::vector<ChannelEntry> channels;
  for (const auto& section : header.images) {
    if (section.count("z scale height") || section.count("z scale"))
      throw InputError(file.name() +
                       " was written by NanoScope software before 4.3; open it in Gwyddion and pass a .gsf");
    Image image;
    image.name = nanoscope_image_name(section);
    if (const auto found = section.find("line direction"); found != section.end())
      image.direction = found->second;
    const std::size_t bytes = section.count("bytes/pixel") ? whole_entry(file, section, "bytes/pixel", 4) : 2;
    resolve_scale(header, section, bytes, image);
    channels.push_back({image.name, image.unit, image.metres_per_step != 0});
    images.push_back(image);
  }
  const std::size_t chosen = choose_channel(file, channels, options);
  const NanoscopeSection& section = header.images[chosen];
  const std::size_t columns = whole_entry(file, section, "samps/line", most_pixels_along);
  const std::size_t rows = whole_entry(file, section, "number of lines", most_pixels_along);
  const std::size_t offset = whole_entry(file, section, "data offset", most_bytes);
  const std::size_t length = whole_entry(file, section, "data length", most_bytes);
  if (offset + length > file.bytes.size())
    throw InputError(file.name() + " has " + std::to_string(file.bytes.size()) + " of at least " +
                     std::to_string(offset + length) + " bytes: it is cut off; copy or export it again");
  const std::size_t points = columns * rows;
  const std::size_t bytes = stored_bytes_per_pixel(file, header, points, length);
  StoredMap map;
  map.nx = static_cast<int>(columns);
  map.ny = static_cast<int>(rows);
  map.heights.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    const std::size_t at = offset + i * bytes;
    const double stored = bytes == 2 ? little_endian<std::int16_t>(file.bytes, at)
                                     : little_endian<std::int32_t>(file.bytes, at);
    map.heights[i] = stored * images[chosen].metres_per_step;
  }
  read_nanoscope_size(header, section, map);
  map.channel = images[chosen].name;
  map.scale = "heights " + images[chosen].scale_text;
  map.first_row = FirstRow::bottom;
  map.note = "channel " + std::to_string(chosen) + " of " + std::to_string(images.size());
  if (!images[chosen].direction.empty()) map.note += ", " + lower_case(images[chosen].direction);
  return map;
}

bool recognises(const SourceFile& file) {
  const std::string beginning = lower_case(file.bytes.substr(0, 32));
  return beginning.rfind("\\*file list", 0) == 0 && nanoscope_exports(file).empty();
}

}  // namespace

namespace formats {
TopographyFormat make_nanoscope() {
  return {"NanoScope (.spm, .di, .001)",
          {".spm", ".di", ".000", ".001", ".002", ".003", ".004", ".005"},
          "the line '\\*File list'",
          recognises,
          read};
}
}  // namespace formats

}  // namespace asperity
