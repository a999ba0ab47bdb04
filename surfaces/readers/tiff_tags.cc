#include "surfaces/readers/tiff_tags.h"

#include "core/error.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

const std::string little_mark("II*\0", 4), big_mark("MM\0*", 4);

std::size_t size_of_type(int type) {
  static const std::map<int, std::size_t> sizes{{1, 1}, {2, 1}, {3, 2}, {4, 4},  {5, 8},  {6, 1},
                                                {7, 1}, {8, 2}, {9, 4}, {10, 8}, {11, 4}, {12, 8}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

std::optional<NumberType> number_type(int type) {
  static const std::map<int, NumberType> types{
      {1, NumberType::uint8}, {3, NumberType::uint16}, {4, NumberType::uint32},   {6, NumberType::int8},
      {8, NumberType::int16}, {9, NumberType::int32},  {11, NumberType::float32}, {12, NumberType::float64}};
  const auto found = types.find(type);
  return found == types.end() ? std::nullopt : std::optional<NumberType>(found->second);
}

}  // namespace

bool is_tiff(const SourceFile& file) {
  return file.bytes.compare(0, 4, little_mark) == 0 || file.bytes.compare(0, 4, big_mark) == 0;
}

ByteOrder tiff_order(const SourceFile& file) {
  return file.bytes[0] == 'M' ? ByteOrder::big : ByteOrder::little;
}

void refuse_cut_off_tiff(const SourceFile& file) {
  throw InputError(file.name() +
                   " points beyond its end: it is a TIFF file that is cut off; copy or export it again");
}

std::vector<TiffDirectory> tiff_directories(const SourceFile& file) {
  constexpr std::size_t entry_size = 12, bytes_kept_inline = 4, most_directories = 1000;
  const std::string& bytes = file.bytes;
  const ByteOrder order = tiff_order(file);
  if (bytes.size() < 8) refuse_cut_off_tiff(file);
  std::vector<TiffDirectory> directories;
  std::size_t entries = 0;
  std::size_t at = stored_number<std::uint32_t>(bytes, 4, order);
  while (directories.empty() || (at != 0 && directories.size() < most_directories)) {
    if (at + 2 > bytes.size()) refuse_cut_off_tiff(file);
    const std::size_t count = stored_number<std::uint16_t>(bytes, at, order);
    const std::size_t end = at + 2 + count * entry_size;
    if (end > bytes.size()) refuse_cut_off_tiff(file);
    entries += count;
    if (entries > bytes.size() / entry_size)
      throw InputError(file.name() +
                       " is a TIFF file whose pictures share their tags without end: it is "
                       "damaged; export it again");
    TiffDirectory& tags = directories.emplace_back();
    for (std::size_t entry = at + 2; entry < end; entry += entry_size) {
      TiffTag tag;
      tag.type = stored_number<std::uint16_t>(bytes, entry + 2, order);
      const std::size_t size = size_of_type(tag.type);
      if (size == 0) continue;
      tag.length = size * stored_number<std::uint32_t>(bytes, entry + 4, order);
      tag.offset =
          tag.length <= bytes_kept_inline ? entry + 8 : stored_number<std::uint32_t>(bytes, entry + 8, order);
      tags[stored_number<std::uint16_t>(bytes, entry, order)] = tag;
    }
    at = end + 4 <= bytes.size() ? stored_number<std::uint32_t>(bytes, end, order) : 0;
  }
  return directories;
}

std::vector<double> tiff_numbers(const SourceFile& file, const TiffDirectory& directory, int tag) {
  const auto found = directory.find(tag);
  if (found == directory.end()) return {};
  const TiffTag& value = found->second;
  const auto type = number_type(value.type);
  if (!type) return {};
  if (value.offset + value.length > file.bytes.size()) refuse_cut_off_tiff(file);
  const auto count = static_cast<std::int64_t>(value.length / bytes_of(*type));
  constexpr std::int64_t most_numbers = 1 << 20;
  if (count < 1 || count > most_numbers) return {};
  return grid_numbers(file, {count, 1, value.offset, *type, tiff_order(file)});
}

std::optional<double> tiff_number(const SourceFile& file, const TiffDirectory& directory, int tag) {
  const auto numbers = tiff_numbers(file, directory, tag);
  return numbers.empty() ? std::nullopt : std::optional<double>(numbers.front());
}

std::string tiff_text(const SourceFile& file, const TiffDirectory& directory, int tag) {
  const auto found = directory.find(tag);
  if (found == directory.end()) return "";
  const TiffTag& value = found->second;
  if (value.offset + value.length > file.bytes.size()) refuse_cut_off_tiff(file);
  const std::string text = file.bytes.substr(value.offset, value.length);
  return trimmed_text(text.substr(0, text.find('\0')));
}

}  // namespace asperity
