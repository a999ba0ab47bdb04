// Every format of height maps.
#include <cmath>

#include "core/error.h"
#include "surfaces/readers/format.h"
#include "tests/fuzz/targets.h"

namespace asperity::fuzz {
namespace {

/// What every map that is read must be.
void check(const Topography& map) {
  const std::size_t points = static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny);
  expect(map.nx >= 2 && map.ny >= 2, "a map has 2 x 2 points or more");
  expect(map.heights.size() == points, "there is a height for each point");
  expect(map.missing.empty() || map.missing.size() == points, "there is a mark for each point");
  expect(map.missing_count() < points, "some height is known");
  expect(map.lx > 0 && map.ly > 0 && std::isfinite(map.lx) && std::isfinite(map.ly),
         "sides are lengths above 0");
  for (std::size_t i = 0; i < points; ++i)
    expect(std::isfinite(map.heights[i]) != (!map.missing.empty() && map.missing[i]),
           "what is not missing is a number");
  expect_utf8(map.channel);
  expect_utf8(describe(map));
}

void read(const std::string& ending, const std::string& bytes) {
  const SourceFile file{"map" + ending, bytes};
  ReadOptions sized;
  sized.size_x_m = 1e-6;
  for (const auto& options : {ReadOptions{}, sized}) {
    try {
      check(topography_from(file, options));
      return;
    } catch (const InputError& error) {
      expect(*error.what() != '\0', "a refusal says why");
    }
  }
}

}  // namespace

std::vector<Target> topography_targets() {
  std::vector<Target> all;
  // HDF5 is left to libnetcdf and libhdf5, whose faults are not asperity's: only classic NetCDF is fuzzed.
  for (const char* ending : {".gsf", ".gwy",  ".001", ".tiff", ".nc",  ".x3p",  ".xyz", ".txt", ".npy",
                             ".mat", ".ibw",  ".nid", ".sur",  ".opd", ".al3d", ".mi",  ".sdf", ".os3d",
                             ".stp", ".zygo", ".vk4", ".bcr",  ".frt", ".jpk",  ".gz"})
    all.push_back({std::string("map_") + (ending + 1), [ending](const std::string& bytes) {
                     if (bytes.compare(0, 4, "\x89HDF") != 0) read(ending, bytes);
                   }});
  return all;
}

}  // namespace asperity::fuzz
