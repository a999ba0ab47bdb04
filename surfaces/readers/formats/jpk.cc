// Image scans of JPK Instruments, now Bruker (.jpk, .jpk-qi-image): TIFF files with tags of their own. Each
// picture but the first, a thumbnail, is a channel (32850 its name, 32849 whether it is the way back) whose
// numbers have several interpretations, "slots" of 48 tags each from 32912 on: name, encoder's unit, kind of
// scaling, factor and offset; 32897 names the one to be used. 32834 and 32835 of the first picture are the
// sides in metres. The first row stored is the bottom of the image unless 32837 says that the grid is
// reflected. Layout as in JPK's own reader for Gwyddion. No real file was at hand: checked
// only against files that the tests write from this description.
#include <algorithm>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/tiff_tags.h"

namespace asperity {
namespace {

constexpr int columns_tag = 256, rows_tag = 257, bits_tag = 258, packing_tag = 259, strips_tag = 273,
              strip_lengths_tag = 279, sample_format_tag = 339;
constexpr int width_tag = 0x8042, height_tag = 0x8043, reflected_tag = 0x8045, quantity_tag = 0x8050,
              retrace_tag = 0x8051, name_tag = 0x8052, slots_tag = 0x8080, default_slot_tag = 0x8081;
constexpr int first_slot = 0x8090, tags_of_a_slot = 0x30;

/// The interpretation of a channel's numbers that its file wants to be used.
struct Slot {
  std::string unit, scaling;
  double factor = 1, offset = 0;
};

Slot default_slot(const SourceFile& file, const TiffDirectory& picture) {
  constexpr int unit = 0x12, scaling = 0x13, factor = 0x14, offset = 0x15, most_slots = 100;
  const std::string wanted = tiff_text(file, picture, default_slot_tag);
  const double count = tiff_number(file, picture, slots_tag).value_or(0);
  for (int i = 0; i < std::min<double>(count, most_slots); ++i) {
    const int base = first_slot + i * tags_of_a_slot;
    if (wanted.empty() || tiff_text(file, picture, base) != wanted) continue;
    return {tiff_text(file, picture, base + unit), tiff_text(file, picture, base + scaling),
            tiff_number(file, picture, base + factor).value_or(1.0),
            tiff_number(file, picture, base + offset).value_or(0.0)};
  }
  return {};
}

struct JpkChannel {
  TiffDirectory picture;
  Slot slot;
};

/// Metres are SI units, so "A" is the ampere.
bool is_length(const Slot& slot) {
  return slot.scaling == "LinearScaling" && slot.unit != "A" && length_unit_factor(slot.unit).has_value();
}

std::string channel_name(const SourceFile& file, const TiffDirectory& picture) {
  std::string name = tiff_text(file, picture, name_tag);
  if (name.empty()) name = tiff_text(file, picture, quantity_tag);
  return name + (tiff_number(file, picture, retrace_tag).value_or(0) != 0 ? " (retrace)" : "");
}

std::vector<JpkChannel> channels_of(const SourceFile& file) {
  std::vector<JpkChannel> channels;
  constexpr double bits_of_a_thumbnail = 8;
  for (const auto& picture : tiff_directories(file)) {
    const bool is_thumbnail = tiff_number(file, picture, bits_tag).value_or(0) <= bits_of_a_thumbnail;
    if (!is_thumbnail && (picture.count(name_tag) || picture.count(quantity_tag)))
      channels.push_back({picture, default_slot(file, picture)});
  }
  return channels;
}

/// None where the tag is no number of pixels, which no map has.
std::int64_t pixels_along(const SourceFile& file, const TiffDirectory& picture, int tag) {
  constexpr double most = 1 << 20;
  const double number = tiff_number(file, picture, tag).value_or(0);
  return number >= 0 && number <= most ? static_cast<std::int64_t>(number) : 0;
}

NumberType number_type(const SourceFile& file, const TiffDirectory& picture) {
  constexpr int of_unsigned = 1, of_signed = 2, of_floats = 3;
  const double bits = tiff_number(file, picture, bits_tag).value_or(0);
  const double kind = tiff_number(file, picture, sample_format_tag).value_or(of_unsigned);
  if (tiff_number(file, picture, packing_tag).value_or(1) == 1) {
    if (bits == 16 && kind == of_unsigned) return NumberType::uint16;
    if (bits == 16 && kind == of_signed) return NumberType::int16;
    if (bits == 32 && kind == of_unsigned) return NumberType::uint32;
    if (bits == 32 && kind == of_signed) return NumberType::int32;
    if (bits == 32 && kind == of_floats) return NumberType::float32;
  }
  throw InputError(
      file.name() +
      " stores its heights packed or in numbers that JPK's format does not use; export them from "
      "JPK's data processing, for example as text");
}

/// The strips of the picture one after the other.
SourceFile joined_strips(const SourceFile& file, const TiffDirectory& picture) {
  const auto begins = tiff_numbers(file, picture, strips_tag);
  const auto lengths = tiff_numbers(file, picture, strip_lengths_tag);
  SourceFile joined{file.path, ""};
  for (std::size_t i = 0; i < std::min(begins.size(), lengths.size()); ++i) {
    if (!(begins[i] >= 0 && lengths[i] >= 0 &&
          begins[i] + lengths[i] <= static_cast<double>(file.bytes.size())) ||
        joined.bytes.size() + lengths[i] > static_cast<double>(file.bytes.size()))
      refuse_cut_off_tiff(file);
    joined.bytes.append(file.bytes, static_cast<std::size_t>(begins[i]),
                        static_cast<std::size_t>(lengths[i]));
  }
  return joined;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const auto channels = channels_of(file);
  std::vector<ChannelEntry> entries;
  for (const auto& channel : channels)
    entries.push_back({channel_name(file, channel.picture), channel.slot.unit, is_length(channel.slot)});
  const std::size_t chosen = choose_channel(file, entries, options);
  const auto& [picture, slot] = channels[chosen];
  StoredGrid grid;
  grid.columns = pixels_along(file, picture, columns_tag);
  grid.rows = pixels_along(file, picture, rows_tag);
  grid.type = number_type(file, picture);
  grid.order = tiff_order(file);
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(joined_strips(file, picture), grid);
  const double unit = *length_unit_factor(slot.unit);
  for (double& height : map.heights) height = unit * (slot.factor * height + slot.offset);
  const TiffDirectory first = tiff_directories(file).front();
  map.lx = tiff_number(file, first, width_tag);
  map.ly = tiff_number(file, first, height_tag);
  const bool reflected = tiff_number(file, picture, reflected_tag).value_or(0) != 0;
  map.first_row = reflected ? FirstRow::top : FirstRow::bottom;
  map.channel = entries[chosen].name;
  map.scale = "heights in steps of " + format_quantity(unit * slot.factor, Dimension::length, 6);
  map.note = "channel " + std::to_string(chosen) + " of " + std::to_string(channels.size());
  return map;
}

bool recognises(const SourceFile& file) {
  if (!is_tiff(file)) return false;
  try {
    return tiff_directories(file).front().count(width_tag) > 0;
  } catch (const InputError&) {  // the reader of other TIFF files says so
    return false;
  }
}

}  // namespace

namespace formats {
TopographyFormat make_jpk() {
  return {"JPK image scan (.jpk)", {".jpk", ".jpk-qi-image"}, "the mark of a TIFF file", recognises, read};
}
}  // namespace formats

}  // namespace asperity
