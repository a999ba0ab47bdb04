// x3p (ISO 25178-72:2017, before that ISO 5436-2): a zip archive with main.xml and the heights as a binary
// matrix, x fastest; metres. DataType I, L: signed integers of 16 and 32 bit, F, D: floats; z = Increment *
// stored + Offset. Missing: NaN, or a 0 in the bit field that ValidPointsLink names, lowest bit first. The
// first row is the top of the image, as Gwyddion and SurfaceTopography show it; the standard itself speaks of
// right-handed axes and of no image. No real file was at hand: checked only against files that the tests
// write from this description.
#include <zip.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <pugixml.hpp>

#include "core/error.h"
#include "core/read_limits.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

using read_limits::largest_file;
using read_limits::most_unpacked;

const std::string main_document = "main.xml";
constexpr std::uint64_t largest_document =
    1u << 20;  // of a few kB; its tree takes up to 20 times as much memory

[[noreturn]] void refuse_large(const SourceFile& file, const std::string& what) {
  throw InputError(file.name() + " holds " + what + " that is too large for a file of " +
                   std::to_string(file.bytes.size()) + " bytes; pass a smaller map, or the same as .gsf");
}

/// The archive, read from memory.
class ZipArchive {
 public:
  explicit ZipArchive(const SourceFile& file) : file_(file) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(file.bytes.data(), file.bytes.size(), 0, &error);
    archive_ = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr;
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    if (!archive_ && source) zip_source_free(source);
    if (!archive_)
      throw InputError(file.name() + " is a zip archive that cannot be opened (" + reason +
                       "): it is cut off or damaged; copy or export it again");
  }
  ~ZipArchive() { zip_discard(archive_); }
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (zip_int64_t i = 0; i < zip_get_num_entries(archive_, 0); ++i)
      if (const char* name = zip_get_name(archive_, i, 0)) names.push_back(name);
    return names;
  }
  bool has(const std::string& name) const { return zip_name_locate(archive_, name.c_str(), 0) >= 0; }
  /// Unpacks a part of at most `most` bytes.
  std::string content(const std::string& name, std::uint64_t most = largest_file) {
    zip_stat_t about;
    zip_stat_init(&about);
    constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_INDEX;
    if (zip_stat(archive_, name.c_str(), 0, &about) != 0 || (about.valid & needed) != needed)
      throw InputError(file_.name() + " lacks '" + name + "', which its main.xml names; export it again");
    if (about.comp_method != ZIP_CM_STORE && about.comp_method != ZIP_CM_DEFLATE)
      throw InputError(file_.name() + " has a part '" + name +
                       "' that is packed in a way that x3p does not know; export it again");
    most = std::min(most, most_unpacked(file_.bytes.size()) - unpacked_);
    if (about.size > most) refuse_large(file_, "a part '" + name + "'");
    // The size that the archive states is not trusted: as much is kept as really comes out.
    std::string bytes;
    std::vector<char> piece(1 << 16);
    zip_file_t* part = zip_fopen_index(archive_, about.index, 0);
    zip_int64_t got = part ? 0 : -1;
    while (part && bytes.size() <= about.size && (got = zip_fread(part, piece.data(), piece.size())) > 0)
      bytes.append(piece.data(), static_cast<std::size_t>(got));
    if (part) zip_fclose(part);
    if (got < 0 || bytes.size() != about.size)
      throw InputError(file_.name() + " has a part '" + name +
                       "' that cannot be unpacked: it is damaged; export it again");
    unpacked_ += bytes.size();
    return bytes;
  }

 private:
  const SourceFile& file_;
  zip_t* archive_ = nullptr;
  std::uint64_t unpacked_ = 0;
};

/// Child of that name, whatever its namespace prefix.
pugi::xml_node child(const pugi::xml_node& parent, const std::string& name) {
  for (const auto& node : parent.children()) {
    const std::string full = node.name();
    if (full.substr(full.find(':') == std::string::npos ? 0 : full.find(':') + 1) == name) return node;
  }
  return {};
}

pugi::xml_node descendant(pugi::xml_node node, const std::vector<std::string>& path) {
  for (const auto& name : path) node = child(node, name);
  return node;
}

std::string text_of(const pugi::xml_node& root, const std::vector<std::string>& path) {
  return trimmed_text(descendant(root, path).text().get());
}

std::optional<double> number_of(const pugi::xml_node& root, const std::vector<std::string>& path) {
  return whole_number_text(text_of(root, path));
}

int pixels(const SourceFile& file, const pugi::xml_node& root, const std::string& name) {
  const auto number = number_of(root, {"Record3", "MatrixDimension", name});
  constexpr double most = 1 << 20;
  if (!number || !(*number >= 1) || *number > most || *number != std::floor(*number))
    throw InputError(file.name() + " gives no valid number of points '" + name +
                     "', so it is no map on a grid; export a height map");
  return static_cast<int>(*number);
}

std::size_t bytes_of(const SourceFile& file, const std::string& type) {
  if (type == "I") return 2;
  if (type == "L" || type == "F") return 4;
  if (type == "D") return 8;
  throw InputError(file.name() + " stores heights as '" + type +
                   "', which x3p does not know; export it again");
}

double stored_value(const std::string& data, const std::string& type, std::size_t i) {
  if (type == "I") return little_endian<std::int16_t>(data, 2 * i);
  if (type == "L") return little_endian<std::int32_t>(data, 4 * i);
  if (type == "F") return little_endian<float>(data, 4 * i);
  return little_endian<double>(data, 8 * i);
}

void apply_validity(const SourceFile& file, const std::string& valid, StoredMap& map) {
  if (valid.size() < (map.heights.size() + 7) / 8)
    throw InputError(file.name() + " has fewer validity bits than points: it is damaged; export it again");
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    if (!(static_cast<unsigned char>(valid[i / 8]) >> (i % 8) & 1))
      map.heights[i] = std::numeric_limits<double>::quiet_NaN();
}

std::string list_for_person(const std::vector<std::string>& names) {
  constexpr std::size_t most = 5;
  std::vector<std::string> some(names.begin(), names.begin() + std::min(most, names.size()));
  return quoted_list(some) + (names.size() > most ? ", ..." : "");
}

StoredMap read(const SourceFile& file, const ReadOptions&) {
  ZipArchive archive(file);
  if (!archive.has(main_document))
    throw InputError(file.name() +
                     " is a zip archive and no x3p, for it lacks main.xml; unpack it and pass one of its "
                     "height maps (it holds " +
                     list_for_person(archive.names()) + ")");
  const std::string xml = archive.content(main_document, largest_document);
  pugi::xml_document document;
  if (const auto result = document.load_buffer(xml.data(), xml.size()); !result)
    throw InputError(file.name() + " has a main.xml that cannot be read (" + result.description() +
                     "); export it again");
  const pugi::xml_node root = document.document_element();
  const pugi::xml_node axes = descendant(root, {"Record1", "Axes"});
  const std::string feature = text_of(root, {"Record1", "FeatureType"});
  if (feature != "SUR")
    throw InputError(file.name() + " holds a feature of type '" + feature +
                     "' and not a surface (SUR); pass a height map");
  if (text_of(axes, {"CX", "AxisType"}) != "I" || text_of(axes, {"CY", "AxisType"}) != "I")
    throw InputError(file.name() + " gives each point its own x and y; export it on a regular grid");
  if (const auto layers = number_of(root, {"Record3", "MatrixDimension", "SizeZ"}); layers && *layers != 1)
    throw InputError(file.name() + " holds several layers; export one of them");
  StoredMap map;
  map.nx = pixels(file, root, "SizeX");
  map.ny = pixels(file, root, "SizeY");
  const std::string link = text_of(root, {"Record3", "DataLink", "PointDataLink"});
  if (link.empty())
    throw InputError(file.name() + " keeps its points as text in main.xml; export it with binary data");
  const std::string type = text_of(axes, {"CZ", "DataType"});
  const std::size_t points = static_cast<std::size_t>(map.nx) * map.ny;
  if (points > most_unpacked(file.bytes.size()) / sizeof(double))
    refuse_large(file, std::to_string(map.nx) + " x " + std::to_string(map.ny) + " points");
  const std::string data = archive.content(link);
  if (data.size() < points * bytes_of(file, type))
    throw InputError(file.name() + " has " + std::to_string(data.size()) + " of the " +
                     std::to_string(points * bytes_of(file, type)) + " bytes of heights that " +
                     std::to_string(map.nx) + " x " + std::to_string(map.ny) +
                     " points take; export it again");
  const double increment = number_of(axes, {"CZ", "Increment"}).value_or(1.0);
  const double offset = number_of(axes, {"CZ", "Offset"}).value_or(0.0);
  map.heights.resize(points);
  for (std::size_t i = 0; i < points; ++i) map.heights[i] = increment * stored_value(data, type, i) + offset;
  if (const std::string valid = text_of(root, {"Record3", "DataLink", "ValidPointsLink"}); !valid.empty())
    apply_validity(file, archive.content(valid), map);
  const auto dx = number_of(axes, {"CX", "Increment"}), dy = number_of(axes, {"CY", "Increment"});
  if (dx && dy && *dx > 0 && *dy > 0) {
    map.lx = *dx * map.nx;
    map.ly = *dy * map.ny;
  }
  map.channel = "heights";
  map.scale = "heights in m";
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) {
  const std::string zip = "PK\x03\x04";
  return file.bytes.compare(0, zip.size(), zip) == 0;
}

}  // namespace

namespace formats {
TopographyFormat make_x3p() {
  return {"x3p (.x3p)", {".x3p"}, "the mark of a zip archive", recognises, read};
}
}  // namespace formats

}  // namespace asperity
