#include "surfaces/readers/height_unit.h"

#include "core/error.h"
#include "surfaces/readers/length_unit.h"

namespace asperity {

double height_unit(const SourceFile& file, const std::string& named, const ReadOptions& options,
                   StoredMap& map) {
  std::string unit = named;
  if (unit.empty() && options.height_unit) {
    unit = *options.height_unit;
    map.note = "unit of height as passed";
  }
  if (unit.empty()) {
    map.height_unit_assumed = true;
    map.note = "no unit of height given, metres taken";
    map.scale = "heights in m";
    return 1.0;
  }
  const auto factor = length_unit_factor(unit);
  if (!factor)
    throw InputError(file.name() + " has values in '" + unit +
                     "', which is no length; export the channel of the topography");
  map.scale = "heights in " + plain_unit(unit);
  return *factor;
}

}  // namespace asperity
