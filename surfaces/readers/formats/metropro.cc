// Zygo's files of MetroPro (.dat), big-endian: a header of 834 or 4096 bytes whose size it states,
// intensities of 16 bit, then phases of 32 bit, top row first. Height = phase * S * W * O / R: scale factor,
// wavelength in metres, obliquity, and 4096, 32768 or 131072 by the phase resolution; 2147483640 and more
// were not measured (Zygo, MetroPro reference guide OMP-0347, appendix on the binary format). The sign of
// inverted data is kept as it is stored. No real file was at hand: checked against files that the tests write
// from this description, which Gwyddion reads likewise.
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/stored_numbers.h"

namespace asperity {
namespace {

struct MetroProHeader {
  StoredGrid phase;
  double scale = 0;  ///< metres of one step
  double pixel = 0;  ///< side of a pixel [m], 0 where it was not calibrated
};

MetroProHeader header_of(const SourceFile& file) {
  HeaderReader reader(file, "MetroPro", ByteOrder::big, 6);
  MetroProHeader header;
  const std::uint64_t size = reader.next<std::uint32_t>();
  reader.go_to(52);  // intensities
  const std::uint64_t columns = reader.next<std::uint16_t>(), rows = reader.next<std::uint16_t>();
  const std::uint64_t buckets = reader.next<std::uint16_t>();
  reader.go_to(68);
  header.phase.columns = reader.next<std::uint16_t>();
  header.phase.rows = reader.next<std::uint16_t>();
  header.phase.begin = size + 2 * buckets * columns * rows;
  header.phase.type = NumberType::int32;
  header.phase.order = ByteOrder::big;
  reader.go_to(164);
  const double factor = reader.next<float>(), wavelength = reader.next<float>();
  reader.skip(4);  // numerical aperture
  const double obliquity = reader.next<float>();
  reader.skip(4);  // magnification
  header.pixel = reader.next<float>();
  reader.go_to(218);
  const int resolution = reader.next<std::int16_t>();
  if (resolution < 0 || resolution > 2)
    throw InputError(file.name() + " has a phase resolution of " + std::to_string(resolution) +
                     ", which MetroPro does not know; export it again, for example as .gsf");
  const double steps = resolution == 0 ? 4096 : resolution == 1 ? 32768 : 131072;
  header.scale = factor * obliquity * wavelength / steps;
  return header;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const MetroProHeader header = header_of(file);
  choose_channel(file, {{"phase", "m", true}}, options);
  if (header.phase.columns == 0 || header.phase.rows == 0)
    throw InputError(file.name() + " holds intensities and no heights; export the surface from MetroPro");
  if (!(header.scale > 0 && std::isfinite(header.scale)))
    throw InputError(file.name() + " gives no valid scale of heights, so it is damaged; export it again");
  StoredMap map;
  map.nx = static_cast<int>(header.phase.columns);
  map.ny = static_cast<int>(header.phase.rows);
  map.heights = grid_numbers(file, header.phase);
  constexpr double first_invalid = 2147483640;
  for (double& height : map.heights)
    height = height < first_invalid ? height * header.scale : std::numeric_limits<double>::quiet_NaN();
  if (header.pixel > 0) {
    map.lx = header.pixel * map.nx;
    map.ly = header.pixel * map.ny;
  }
  map.channel = "phase";
  map.scale = "heights in steps of " + format_quantity(header.scale, Dimension::length, 6);
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) {
  for (const char* magic : {"\x88\x1b\x03\x6f", "\x88\x1b\x03\x70", "\x88\x1b\x03\x71"})
    if (file.bytes.compare(0, 4, magic) == 0) return true;
  return false;
}

}  // namespace

namespace formats {
TopographyFormat make_metropro() {
  return {"Zygo MetroPro (.dat)", {".dat"}, "the mark of MetroPro", recognises, read};
}
}  // namespace formats

}  // namespace asperity
