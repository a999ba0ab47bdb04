#include "fem/case/contact_path.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/quantity.h"
#include "fem/programs/combined_program.h"

namespace asperity::fem {
namespace {

/// Longest path from the middle of a roll [m] that a contact with this fine region has on the particle's
/// finely meshed cap: no further up the sphere than where its slope makes the cap's cells, a lattice in
/// projection, a fifteenth longer, and with the evenly spaced cells, half a region more on both sides
/// (BodyMap), still on the cap.
double longest_reach(double region, double radius) {
  constexpr double highest = 0.78, widest = 0.97;
  const double cap = meshing::BodyMap::cap_fraction * radius;
  return std::min(highest * cap - region, widest * cap - 1.5 * region);
}

}  // namespace

std::string at_most(double length) {
  if (length <= 0) return "0 m";
  const double unit = std::pow(10, std::floor(std::log10(length)) - 2);
  return format_quantity(unit * std::floor(length / unit), Dimension::length);
}

void fit_to_rolling(const CaseInput& input, meshing::BodySizes& sizes, double region) {
  const double R = input.radius;
  sizes.reach_particle = sizes.reach_substrate = input.experiment.distance / 2;
  const double reach = region + sizes.reach_particle, longest = longest_reach(region, R);
  if (sizes.reach_particle > longest)
    throw InputError(input.file + ": Experiment/Distance of " +
                     format_quantity(input.experiment.distance, Dimension::length) +
                     " rolls the contact out of the particle's finely meshed cap; set it to " +
                     at_most(2 * longest) + " or less");
  sizes.region_substrate +=
      R * std::asin(reach / R) - reach;  // rolled out, an arc is longer than its projection
}

void fit_to_sliding(const CaseInput& input, meshing::BodySizes& sizes) {
  // The particle slides from the origin along x.
  sizes.reach_substrate = sizes.offset_substrate_x = input.experiment.distance / 2;
  const double longest = sizes.block_half_width / 2;
  if (sizes.region_substrate + sizes.reach_substrate > longest)
    throw InputError(input.file + ": Experiment/Distance of " +
                     format_quantity(input.experiment.distance, Dimension::length) +
                     " leaves the middle half of the substrate's block; set it to " +
                     at_most(2 * (longest - sizes.region_substrate)) + " or less");
}

void fit_to_program(const CaseInput& input, CaseSetup& setup) {
  const double R = input.radius;
  const MotionExtent extent = extent_of(
      combined_program(parse_motion_program(input.experiment.program), input.experiment, setup.motion, {}));
  auto& sizes = setup.system.mesh.sizes;
  const auto refuse = [&](const std::string& motion, double longest) {
    throw InputError(input.file + ": Experiment/Program " + motion + "; let the contact move by " +
                     at_most(2 * longest) + " at most, to and fro counting once");
  };
  sizes.reach_particle = 0.5 * (extent.high_roll - extent.low_roll) * R;
  const double longest = longest_reach(sizes.region_particle, R),
               reach = sizes.region_particle + sizes.reach_particle;
  if (sizes.reach_particle > longest)
    refuse("rolls the contact out of the particle's finely meshed cap", longest);
  sizes.reach_substrate = 0.5 * (extent.high_x - extent.low_x);
  sizes.region_substrate += 0.5 * (extent.high_y - extent.low_y) + R * std::asin(reach / R) - reach;
  const double widest = sizes.block_half_width / 2;
  if (sizes.region_substrate + sizes.reach_substrate > widest)
    refuse("leaves the middle half of the substrate's block", widest - sizes.region_substrate);
}

}  // namespace asperity::fem
