// Igor binary waves (.ibw) of WaveMetrics, version 5, as Asylum Research's instruments write them: a header
// of 64 bytes, the wave's header of 320, the numbers (first dimension fastest), then the wave's note and the
// labels of its dimensions, 32 bytes each, the first of them the dimension's own (WaveMetrics, Technical Note
// 003). Layers of the third dimension are channels, named by their labels. Asylum writes one unit for all of
// them, so a labelled channel is a length by its name. The first row stored is the bottom of the image.
// Checked against a real file in the tests.
#include <array>
#include <cmath>

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/height_unit.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/stored_numbers.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

constexpr std::size_t binary_header = 64, wave_header = 320;
constexpr std::size_t most_dimensions = 4, label_size = 32;

struct Wave {
  ByteOrder order = ByteOrder::little;
  std::uint64_t stored = 0;  ///< bytes of the numbers
  std::uint64_t before_labels = 0;
  std::array<std::uint64_t, most_dimensions> label_bytes{};
  int type = 0;
  std::array<std::int64_t, most_dimensions> points{};
  std::array<double, most_dimensions> spacing{};
  std::string data_unit, lateral_unit;
};

/// The version is a small number: its byte order is that in which it is one.
ByteOrder order_of(const SourceFile& file) { return file.bytes[0] ? ByteOrder::little : ByteOrder::big; }

int version_of(const SourceFile& file) { return stored_number<std::uint16_t>(file.bytes, 0, order_of(file)); }

Wave wave_of(const SourceFile& file) {
  Wave wave;
  wave.order = order_of(file);
  HeaderReader header(file, "Igor", wave.order, 4);
  const std::uint64_t size = header.next<std::uint32_t>();
  wave.stored = size > wave_header ? size - wave_header : 0;
  wave.before_labels = header.next<std::uint32_t>();   // formula
  wave.before_labels += header.next<std::uint32_t>();  // note
  wave.before_labels += header.next<std::uint32_t>();  // long unit of the data
  for (std::size_t i = 0; i < most_dimensions; ++i) wave.before_labels += header.next<std::uint32_t>();
  for (auto& bytes : wave.label_bytes) bytes = header.next<std::uint32_t>();
  header.go_to(binary_header + 16);
  wave.type = header.next<std::uint16_t>();
  header.go_to(binary_header + 68);
  for (auto& points : wave.points) points = header.next<std::int32_t>();
  for (auto& spacing : wave.spacing) spacing = header.next<double>();
  header.skip(most_dimensions * sizeof(double));  // where the dimensions begin
  wave.data_unit = header.text(4);
  wave.lateral_unit = header.text(4);
  return wave;
}

NumberType number_type(const SourceFile& file, int type) {
  switch (type) {
    case 0x02:
      return NumberType::float32;
    case 0x04:
      return NumberType::float64;
    case 0x08:
      return NumberType::int8;
    case 0x10:
      return NumberType::int16;
    case 0x20:
      return NumberType::int32;
    case 0x48:
      return NumberType::uint8;
    case 0x50:
      return NumberType::uint16;
    case 0x60:
      return NumberType::uint32;
    default:
      throw InputError(file.name() +
                       " is an Igor wave of text or complex numbers and no map; pass the image");
  }
}

/// Igor writes symbols of the SI: "A" is the ampere and no length.
std::optional<double> igor_length(const std::string& unit) {
  return unit == "A" ? std::nullopt : length_unit_factor(unit);
}

bool is_length_by_name(const std::string& label) {
  const std::string name = lower_case(label);
  for (const char* quantity : {"height", "zsensor", "deflection", "amplitude"})
    for (const char* way : {"", "nap", "dac"})
      if (name.rfind(std::string(way) + quantity, 0) == 0) return true;
  return false;
}

/// Names of the layers; without labels they have none.
std::vector<ChannelEntry> layers_of(const SourceFile& file, const Wave& wave, std::uint64_t end_of_data,
                                    std::int64_t layers) {
  constexpr std::size_t layer_dimension = 2;
  const bool unit_is_length = wave.data_unit.empty() || igor_length(wave.data_unit).has_value();
  std::uint64_t at = end_of_data + wave.before_labels;
  for (std::size_t i = 0; i < layer_dimension; ++i) at += wave.label_bytes[i];
  std::vector<ChannelEntry> channels;
  const std::uint64_t labels = wave.label_bytes[layer_dimension] / label_size;
  for (std::int64_t layer = 0; layer < layers; ++layer) {
    const auto number = static_cast<std::uint64_t>(layer) + 1;  // the first label is the dimension's
    std::string label;
    if (number < labels) {
      HeaderReader reader(file, "Igor", wave.order, at + number * label_size);
      label = reader.text(label_size);
    }
    if (label.empty())
      channels.push_back({"layer " + std::to_string(layer), wave.data_unit, unit_is_length});
    else
      channels.push_back({label, is_length_by_name(label) ? "m" : "", is_length_by_name(label)});
  }
  return channels;
}

void read_size(const Wave& wave, StoredMap& map) {
  const auto unit = wave.lateral_unit.empty() ? std::optional<double>(1.0) : igor_length(wave.lateral_unit);
  const double dx = std::abs(wave.spacing[0]), dy = std::abs(wave.spacing[1]);
  if (!unit || !(dx > 0 && dy > 0)) return;
  map.lateral_unit_assumed = wave.lateral_unit.empty();
  if (map.lateral_unit_assumed)
    map.note += std::string(map.note.empty() ? "" : "; ") + "no unit of size given, metres taken";
  map.lx = dx * *unit * map.nx;
  map.ly = dy * *unit * map.ny;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  if (version_of(file) != 5)
    throw InputError(file.name() + " is an Igor wave of version " + std::to_string(version_of(file)) +
                     ", which has one dimension: a profile and not a map; pass the image");
  const Wave wave = wave_of(file);
  if (wave.points[1] < 1 || wave.points[3] > 0)
    throw InputError(file.name() +
                     " is an Igor wave of one or four dimensions and not a map; pass the image");
  StoredGrid grid;
  grid.columns = wave.points[0];
  grid.rows = wave.points[1];
  grid.begin = binary_header + wave_header;
  grid.order = wave.order;
  grid.type = number_type(file, wave.type);
  const std::int64_t layers = wave.points[2] > 0 ? wave.points[2] : 1;
  constexpr std::int64_t most_layers = 1000;
  if (layers > most_layers)
    throw InputError(file.name() + " is an Igor wave of " + std::to_string(layers) +
                     " layers, too many for channels of a scan; pass the image");
  const std::uint64_t layer_bytes = checked_grid_bytes(file, grid);
  const std::uint64_t there = file.bytes.size() - grid.begin;
  if (static_cast<std::uint64_t>(layers) > there / layer_bytes)
    throw InputError(file.name() + " has fewer than its " + std::to_string(layers) +
                     " layers: it is cut off; copy or export it again");
  const auto channels =
      layers_of(file, wave, grid.begin + static_cast<std::uint64_t>(layers) * layer_bytes, layers);
  const std::size_t chosen = choose_channel(file, channels, options);
  grid.begin += chosen * layer_bytes;
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  const bool unit_known = igor_length(wave.data_unit).has_value();
  const double unit = height_unit(file, unit_known ? wave.data_unit : channels[chosen].unit, options, map);
  map.heights = grid_numbers(file, grid);
  for (double& height : map.heights) height *= unit;
  read_size(wave, map);
  map.channel = channels[chosen].name;
  map.first_row = FirstRow::bottom;
  map.note += std::string(map.note.empty() ? "" : "; ") + "channel " + std::to_string(chosen) + " of " +
              std::to_string(channels.size());
  return map;
}

/// The 16-bit words of both headers add up to zero.
bool recognises(const SourceFile& file) {
  if (file.bytes.size() < 16) return false;
  const int version = version_of(file);
  const std::size_t headers = version == 2   ? 16 + 110
                              : version == 3 ? 20 + 110
                              : version == 5 ? binary_header + wave_header
                                             : 0;
  if (headers == 0 || file.bytes.size() < headers) return false;
  std::uint16_t sum = 0;
  for (std::size_t at = 0; at + 1 < headers; at += 2)
    sum = static_cast<std::uint16_t>(sum + stored_number<std::uint16_t>(file.bytes, at, order_of(file)));
  return sum == 0;
}

}  // namespace

namespace formats {
TopographyFormat make_igor() {
  return {"Igor binary wave (.ibw)", {".ibw"}, "the header of an Igor wave", recognises, read};
}
}  // namespace formats

}  // namespace asperity
