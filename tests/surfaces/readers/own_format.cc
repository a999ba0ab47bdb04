// A format of topographies of somebody's own, all of it: "OWN nx ny dx", then heights in nanometres.
#include <sstream>

#include "core/error.h"
#include "surfaces/readers/format.h"

namespace asperity {
namespace {

const std::string mark = "OWN ";

bool recognises(const SourceFile& file) { return file.bytes.compare(0, mark.size(), mark) == 0; }

StoredMap read(const SourceFile& file, const ReadOptions&) {
  std::istringstream text(file.bytes.substr(mark.size()));
  StoredMap map;
  double spacing = 0, height = 0;
  text >> map.nx >> map.ny >> spacing;
  map.lx = map.nx * spacing;
  map.ly = map.ny * spacing;
  while (text >> height) map.heights.push_back(1e-9 * height);
  if (map.heights.size() != static_cast<std::size_t>(map.nx) * map.ny)
    throw InputError(file.name() + " holds other heights than it says; export it again");
  map.scale = "heights in nm";
  return map;
}

const RegisteredFormat own_format{{"own map (.own)", {".own"}, "the mark 'OWN'", recognises, read}};

}  // namespace
}  // namespace asperity
