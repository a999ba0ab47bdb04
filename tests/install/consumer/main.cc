// Ten lines of another project that uses asperity by find_package: a generated surface and Hertz' law.
#include <cstdio>

#include "core/hertz.h"
#include "surfaces/statistics.h"
#include "surfaces/surface_of_entry.h"

int main() {
  const asperity::Topography map = asperity::topography_for("generated(rms=1.5 nm, seed=3)");
  const asperity::Hertz hertz{asperity::reduced_modulus({71e9, 0.17}, {179e9, 0.25}), 8.5e-6};
  std::printf("%.3g nm %.3g nm\n", 1e9 * asperity::height_moments(map).Sq, 1e9 * hertz.approach(1e-3));
}
