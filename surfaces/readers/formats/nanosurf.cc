// Nanosurf's easyScan files (.nid, .ezd): lines "Key=Value" in sections "[Name]", then "#!" and the data of
// all channels one after the other. [DataSet] lists groups (scan directions) of channels, each with a section
// that says its points, lines, bits and the ranges of its axes: the stored integers, taken as unsigned, span
// the range of the third axis. The first row stored is the bottom of the image. Checked against a real file
// and its owners' RMS in the tests.
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/stored_numbers.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

const std::string first_section = "[DataSet]";
const std::string data_mark = "#!";
using Section = std::map<std::string, std::string>;

struct NidHeader {
  std::map<std::string, Section> sections;
  std::size_t data_begin = 0;
};

NidHeader header_of(const SourceFile& file) {
  NidHeader header;
  Section* section = &header.sections[""];
  for (std::size_t begin = 0; begin < file.bytes.size();) {
    if (file.bytes.compare(begin, data_mark.size(), data_mark) == 0) {
      header.data_begin = begin + data_mark.size();
      return header;
    }
    const std::size_t end = std::min(file.bytes.find('\n', begin), file.bytes.size());
    const std::string line = trimmed_text(file.bytes.substr(begin, end - begin));
    begin = end + 1;
    const auto equals = line.find('=');
    if (line.size() > 2 && line.front() == '[' && line.back() == ']')
      section = &header.sections[line.substr(1, line.size() - 2)];
    else if (equals != std::string::npos)
      (*section)[trimmed_text(line.substr(0, equals))] = trimmed_text(line.substr(equals + 1));
  }
  throw InputError(file.name() + " ends inside its Nanosurf header: it is cut off; copy or export it again");
}

[[noreturn]] void refuse_entry(const SourceFile& file, const std::string& key) {
  throw InputError(file.name() + " has no valid '" + key +
                   "' in its Nanosurf header, so it is damaged; export it again, for example as .gsf");
}

std::string text_entry(const Section& section, const std::string& key) {
  const auto found = section.find(key);
  return found == section.end() ? "" : found->second;
}

double number_entry(const SourceFile& file, const Section& section, const std::string& key) {
  const auto number = whole_number_text(text_entry(section, key));
  if (!number || !std::isfinite(*number)) refuse_entry(file, key);
  return *number;
}

std::int64_t count_entry(const SourceFile& file, const Section& section, const std::string& key) {
  const double number = number_entry(file, section, key);
  constexpr double most = 1 << 20;
  if (!(number >= 0 && number <= most && number == std::floor(number))) refuse_entry(file, key);
  return static_cast<std::int64_t>(number);
}

NumberType number_type(const SourceFile& file, const Section& section) {
  const bool is_signed = text_entry(section, "SaveSign") == "Signed";
  switch (count_entry(file, section, "SaveBits")) {
    case 8:
      return is_signed ? NumberType::int8 : NumberType::uint8;
    case 16:
      return is_signed ? NumberType::int16 : NumberType::uint16;
    case 32:
      return is_signed ? NumberType::int32 : NumberType::uint32;
    default:
      refuse_entry(file, "SaveBits");
  }
}

struct NidChannel {
  const Section* section = nullptr;
  StoredGrid grid;
};

/// Channels of all groups with where their data lie.
std::vector<NidChannel> channels_of(const SourceFile& file, const NidHeader& header) {
  const auto found = header.sections.find("DataSet");
  if (found == header.sections.end()) refuse_entry(file, "DataSet");
  const Section& list = found->second;
  constexpr std::int64_t most_channels = 1000;
  std::vector<NidChannel> channels;
  std::uint64_t at = header.data_begin;
  const std::int64_t groups = count_entry(file, list, "GroupCount");
  for (std::int64_t group = 0; group < std::min(groups, most_channels); ++group) {
    const std::string prefix = "Gr" + std::to_string(group) + "-";
    const std::int64_t count = count_entry(file, list, prefix + "Count");
    for (std::int64_t i = 0; i < std::min(count, most_channels); ++i) {
      const auto section = header.sections.find(text_entry(list, prefix + "Ch" + std::to_string(i)));
      if (section == header.sections.end() || section->first.empty()) continue;  // not recorded
      NidChannel channel;
      channel.section = &section->second;
      if (text_entry(*channel.section, "SaveMode") != "Binary") refuse_entry(file, "SaveMode");
      channel.grid.columns = count_entry(file, *channel.section, "Points");
      channel.grid.rows = count_entry(file, *channel.section, "Lines");
      channel.grid.type = number_type(file, *channel.section);
      channel.grid.order =
          text_entry(*channel.section, "SaveOrder") == "Intel" ? ByteOrder::little : ByteOrder::big;
      channel.grid.begin = at;
      at += static_cast<std::uint64_t>(channel.grid.rows) * channel.grid.bytes_per_row();
      channels.push_back(channel);
    }
  }
  return channels;
}

std::string channel_name(const Section& section) {
  return text_entry(section, "Frame") + " (" + text_entry(section, "Dim2Name") + ")";
}

/// The axis in metres; empty if it is no length.
std::optional<double> axis_length(const SourceFile& file, const Section& section, const std::string& axis) {
  const auto unit = length_unit_factor(text_entry(section, axis + "Unit"));
  if (!unit) return std::nullopt;
  return std::abs(number_entry(file, section, axis + "Range")) * *unit;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const NidHeader header = header_of(file);
  const auto channels = channels_of(file, header);
  std::vector<ChannelEntry> entries;
  for (const auto& channel : channels) {
    const std::string unit = text_entry(*channel.section, "Dim2Unit");
    entries.push_back({channel_name(*channel.section), unit, length_unit_factor(unit).has_value()});
  }
  if (entries.empty())
    throw InputError(file.name() + " is a Nanosurf file without images; pass a file of an image scan");
  const std::size_t chosen = choose_channel(file, entries, options);
  const Section& section = *channels[chosen].section;
  const StoredGrid& grid = channels[chosen].grid;
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(file, grid);
  const double bits = 8.0 * static_cast<double>(bytes_of(grid.type)), steps = std::exp2(bits);
  const bool is_signed = text_entry(section, "SaveSign") == "Signed";
  const double range = *axis_length(file, section, "Dim2");
  const double lowest =
      number_entry(file, section, "Dim2Min") * *length_unit_factor(text_entry(section, "Dim2Unit"));
  for (double& height : map.heights)
    height = lowest + (height + (is_signed ? steps / 2 : 0)) * (range / steps);
  map.lx = axis_length(file, section, "Dim0");
  map.ly = axis_length(file, section, "Dim1");
  map.channel = entries[chosen].name;
  map.scale = "heights " + format_quantity(range, Dimension::length, 6) + " over 2^" +
              std::to_string(static_cast<int>(bits)) + " steps";
  map.first_row = FirstRow::bottom;
  map.note = "channel " + std::to_string(chosen) + " of " + std::to_string(channels.size());
  return map;
}

bool recognises(const SourceFile& file) {
  return file.bytes.compare(0, first_section.size(), first_section) == 0;
}

}  // namespace

namespace formats {
TopographyFormat make_nanosurf() {
  return {"Nanosurf easyScan (.nid, .ezd)", {".nid", ".ezd"}, "the line '[DataSet]'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
