// Gwyddion's native format (.gwy). Format: Gwyddion user guide, "Format of Gwyddion Files": after "GWYP" a
// tree of objects (name, size, components), each component a name, a type character and little-endian data.
// Channel N is the GwyDataField "/N/data" with its title "/N/data/title"; top row first; base SI units.
// Pixels marked by "/N/mask" are taken as missing, since importers mark invalid points so, and the echo says
// how many. No real file was at hand: checked only against files that the tests write from this description.
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

const std::string magic = "GWYP";

struct GwyObject;

/// A component; only the kinds that a height map needs are kept.
struct GwyValue {
  double number = 0;                  ///< b, i, q, d
  std::string text;                   ///< s
  std::shared_ptr<GwyObject> object;  ///< o
  std::vector<double> array;          ///< D
};

struct GwyObject {
  std::string type;
  std::map<std::string, GwyValue> components;

  const GwyValue* find(const std::string& name) const {
    const auto found = components.find(name);
    return found == components.end() ? nullptr : &found->second;
  }
};

/// Reads the tree; every step is checked against the end of the object that contains it.
class GwyParser {
 public:
  explicit GwyParser(const SourceFile& file) : file_(file), at_(magic.size()) {}

  GwyObject parse_object(std::size_t end, int depth = 0) {
    constexpr int deepest = 64;
    if (depth > deepest) damaged();
    GwyObject object;
    object.type = next_string(end);
    const std::size_t size = next<std::uint32_t>(end);
    if (size > end - at_ && depth == 0)
      throw InputError(file_.name() + " has " + std::to_string(file_.bytes.size()) + " of its " +
                       std::to_string(at_ + size) + " bytes: it is cut off; copy or save it again");
    if (size > end - at_) damaged();
    const std::size_t object_end = at_ + size;
    while (at_ < object_end) {
      const std::string name = next_string(object_end);
      object.components[name] = parse_value(next<char>(object_end), object_end, depth);
    }
    return object;
  }

 private:
  [[noreturn]] void damaged() const {
    throw InputError(file_.name() + " breaks off inside its data at byte " + std::to_string(at_) +
                     ": it is cut off or damaged; save it again in Gwyddion");
  }
  std::size_t advance(std::size_t count, std::size_t size, std::size_t end) {
    if (count > (end - at_) / size) damaged();
    const std::size_t begin = at_;
    at_ += count * size;
    return begin;
  }
  template <class T>
  T next(std::size_t end) {
    return little_endian<T>(file_.bytes, advance(1, sizeof(T), end));
  }
  std::string next_string(std::size_t end) {
    const auto nul = file_.bytes.find('\0', at_);
    if (nul == std::string::npos || nul >= end) damaged();
    const std::size_t begin = at_;
    at_ = nul + 1;
    return file_.bytes.substr(begin, nul - begin);
  }
  GwyValue parse_value(char type, std::size_t end, int depth) {
    GwyValue value;
    switch (type) {
      case 'b':
        value.number = next<std::uint8_t>(end);
        break;
      case 'c':
        next<char>(end);
        break;
      case 'i':
        value.number = next<std::int32_t>(end);
        break;
      case 'q':
        value.number = static_cast<double>(next<std::int64_t>(end));
        break;
      case 'd':
        value.number = next<double>(end);
        break;
      case 's':
        value.text = next_string(end);
        break;
      case 'o':
        value.object = std::make_shared<GwyObject>(parse_object(end, depth + 1));
        break;
      case 'C':
        advance(next<std::uint32_t>(end), 1, end);
        break;
      case 'I':
        advance(next<std::uint32_t>(end), 4, end);
        break;
      case 'Q':
        advance(next<std::uint32_t>(end), 8, end);
        break;
      case 'D':
        value.array = next_doubles(end);
        break;
      case 'S':
        skip_each(end, [&] { next_string(end); });
        break;
      case 'O':
        skip_each(end, [&] { parse_object(end, depth + 1); });
        break;
      default:
        damaged();
    }
    return value;
  }
  std::vector<double> next_doubles(std::size_t end) {
    const std::size_t count = next<std::uint32_t>(end);
    const std::size_t begin = advance(count, sizeof(double), end);
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
      values[i] = little_endian<double>(file_.bytes, begin + i * sizeof(double));
    return values;
  }
  template <class Step>
  void skip_each(std::size_t end, Step step) {
    for (std::uint32_t left = next<std::uint32_t>(end); left > 0; --left) step();
  }

  const SourceFile& file_;
  std::size_t at_;
};

struct Channel {
  int number = 0;
  const GwyObject* field = nullptr;
};

std::string unit_of(const GwyObject& field, const std::string& name) {
  const GwyValue* unit = field.find(name);
  if (!unit || !unit->object) return "";
  const GwyValue* text = unit->object->find("unitstr");
  return text ? text->text : "";
}

double number_of(const GwyObject& field, const std::string& name) {
  const GwyValue* value = field.find(name);
  return value ? value->number : 0.0;
}

/// "/3/data" gives 3; anything else -1.
int channel_number(const std::string& key) {
  const std::string end = "/data";
  if (key.size() < end.size() + 2 || key[0] != '/' ||
      key.compare(key.size() - end.size(), end.size(), end) != 0)
    return -1;
  const auto number = whole_number_text(key.substr(1, key.size() - end.size() - 1));
  return number && *number >= 0 && *number < 1e6 ? static_cast<int>(*number) : -1;
}

std::vector<Channel> channels_of(const GwyObject& container) {
  std::map<int, Channel> in_order;
  for (const auto& [key, value] : container.components) {
    const int number = channel_number(key);
    if (number >= 0 && value.object && value.object->type == "GwyDataField")
      in_order[number] = {number, value.object.get()};
  }
  std::vector<Channel> channels;
  for (const auto& [number, channel] : in_order) channels.push_back(channel);
  return channels;
}

std::string title_of(const GwyObject& container, int number) {
  const GwyValue* title = container.find("/" + std::to_string(number) + "/data/title");
  return title && !title->text.empty() ? title->text : "channel " + std::to_string(number);
}

void apply_mask(const GwyObject& container, int number, StoredMap& map) {
  const GwyValue* mask = container.find("/" + std::to_string(number) + "/mask");
  const GwyValue* marks = mask && mask->object ? mask->object->find("data") : nullptr;
  if (!marks || marks->array.size() != map.heights.size()) return;
  constexpr double marked = 0.5;  // masks hold 0 and 1, or values between after filtering
  std::size_t count = 0;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    if (marks->array[i] >= marked) {
      map.heights[i] = std::numeric_limits<double>::quiet_NaN();
      ++count;
    }
  if (count) map.note = std::to_string(count) + " points under the file's mask taken as missing";
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const GwyObject container = GwyParser(file).parse_object(file.bytes.size());
  const std::vector<Channel> channels = channels_of(container);
  if (channels.empty())
    throw InputError(file.name() + " holds no image channel; pass a file with a height map");
  std::vector<ChannelEntry> entries;
  for (const auto& channel : channels) {
    const std::string unit = unit_of(*channel.field, "si_unit_z");
    entries.push_back({title_of(container, channel.number), unit, length_unit_factor(unit).has_value()});
  }
  const std::size_t chosen = choose_channel(file, entries, options);
  const GwyObject& field = *channels[chosen].field;
  const GwyValue* data = field.find("data");
  StoredMap map;
  const double columns = number_of(field, "xres"), rows = number_of(field, "yres");
  if (!data || !(columns >= 1) || !(rows >= 1) || columns != std::floor(columns) ||
      rows != std::floor(rows) || columns * rows != static_cast<double>(data->array.size()))
    throw InputError(file.name() + " has a channel '" + entries[chosen].name +
                     "' whose data do not fit its pixels, so it is damaged; save it again in Gwyddion");
  map.nx = static_cast<int>(columns);
  map.ny = static_cast<int>(rows);
  map.heights = data->array;
  const double unit = *length_unit_factor(entries[chosen].unit);
  for (double& height : map.heights) height *= unit;
  const auto lateral_unit = length_unit_factor(unit_of(field, "si_unit_xy"));
  if (lateral_unit && number_of(field, "xreal") > 0 && number_of(field, "yreal") > 0) {
    map.lx = number_of(field, "xreal") * *lateral_unit;
    map.ly = number_of(field, "yreal") * *lateral_unit;
  }
  apply_mask(container, channels[chosen].number, map);
  map.channel = entries[chosen].name;
  map.scale = "heights in " + plain_unit(entries[chosen].unit);
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_gwy() { return {"Gwyddion (.gwy)", {".gwy"}, "the mark 'GWYP'", recognises, read}; }
}  // namespace formats

}  // namespace asperity
