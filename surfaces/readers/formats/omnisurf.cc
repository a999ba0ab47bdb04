// Files of OmniSurf3D (.os3d), Digital Metrology: a mark, two version numbers, two texts each behind its
// length, columns and rows, spacings and origin as doubles in micrometres, then 32-bit floats in micrometres,
// little-endian; the lowest float marks a point without a height (Digital Metrology, "OmniSurf3D file
// format"). The first row is taken as the top of the image, as SurfaceTopography shows it. No real file was
// at hand: checked only against files that the tests write from this description.
#include <limits>

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/stored_numbers.h"

namespace asperity {
namespace {

const std::string magic = "OmniSurf3D";
constexpr double micrometre = 1e-6;

void skip_text(HeaderReader& reader) { reader.skip(reader.next<std::uint32_t>()); }

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  choose_channel(file, {{"heights", "um", true}}, options);
  HeaderReader reader(file, "OmniSurf3D", ByteOrder::little, magic.size());
  reader.skip(4 + 4);  // version
  skip_text(reader);   // identification
  skip_text(reader);   // date and time
  StoredGrid grid;
  grid.columns = reader.next<std::int32_t>();
  grid.rows = reader.next<std::int32_t>();
  const double dx = reader.next<double>(), dy = reader.next<double>();
  reader.skip(2 * sizeof(double));  // origin
  grid.begin = reader.at();
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(file, grid);
  constexpr double lowest_height = -3e38;
  for (double& height : map.heights)
    height = height > lowest_height ? height * micrometre : std::numeric_limits<double>::quiet_NaN();
  map.lx = dx * micrometre * map.nx;
  map.ly = dy * micrometre * map.ny;
  map.channel = "heights";
  map.scale = "heights in um";
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_omnisurf() {
  return {"OmniSurf3D (.os3d)", {".os3d"}, "the mark 'OmniSurf3D'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
