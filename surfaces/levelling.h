// Removing tilt, bow or line offsets from a scan by least squares; missing points take no part.
#pragma once

#include <string>

#include "surfaces/topography.h"

namespace asperity {

/// mean, plane (1, x, y) and quadratic (1, x, y, x^2, xy, y^2) over the whole map; rows0, rows1, rows2: a
/// polynomial of that degree along x for each row on its own.
enum class Level { mean, plane, quadratic, rows0, rows1, rows2 };

/// "plane" and so on; throws InputError listing the names there are.
Level parse_level(const std::string& name);
std::string level_name(Level level);

/// The map with its least-squares fit subtracted. A row with fewer known points than its polynomial needs is
/// fitted with a lower degree. A levelled map is not periodic unless only its mean was removed.
Topography levelled(const Topography& map, Level level);

}  // namespace asperity
