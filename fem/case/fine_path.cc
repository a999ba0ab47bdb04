#include "fem/case/fine_path.h"

#include <algorithm>
#include <cmath>

#include "fem/case/solve_cost.h"
#include "fem/materials/material_law.h"

namespace asperity::fem {
namespace {

/// Of the fine region's half width: far enough that meshing anew costs little beside the steps on the way.
constexpr double stride_in_regions = 0.5;
/// Fine cells reach from the contact's middle to so many of its radii at least: where they ended at 1.7, the
/// bodies' compliance depended on where the contact stood between wide cells before and behind it, which
/// added 1.5 % of its largest to a rolling moment; 0.08 % with 2.2.
constexpr double reach_in_radii = 2.25;
/// Meshing anew, and steps off the whole path's mesh, are worth it below this share of its unknowns.
constexpr double worth_it = 0.7;

}  // namespace

FinePath::FinePath(const CaseInput& input, const CaseSetup& setup, const std::vector<Station>& program)
    : sizes_(setup.system.mesh.sizes), layers_(input.mesh.layers) {
  for (const auto& station : program) motions_.push_back(station.motion);
  if (input.mesh.along_path == "whole") return;
  // Strain that has not yet come back is everywhere, and is not carried to another mesh.
  if (relaxes(input)) return;
  stride_ = stride_in_regions * sizes_.region_particle;
  const double widest = std::max(setup.largest_radius, setup.least_radius);  // which attraction may draw
  margin_ = std::max(0.0, reach_in_radii * widest - sizes_.region_particle);
  if (share_at_a_time() > worth_it) stride_ = 0;
}

double FinePath::share_at_a_time() const {
  if (!travels()) return 1;
  meshing::BodySizes part = sizes_;
  for (double* reach : {&part.reach_particle, &part.reach_substrate})
    *reach = std::min(*reach, stride_ / 2 + margin_);
  return estimated_unknowns(part, layers_) / estimated_unknowns(sizes_, layers_);
}

std::array<double, 2> FinePath::place(const RigidMotion& motion) const {
  return {-sizes_.radius * rotation(motion)[2][0], motion.x - sizes_.offset_substrate_x};
}

FineParts FinePath::first() const {
  const RigidMotion& start = motions_.front();
  const auto next = std::find_if(motions_.begin(), motions_.end(),
                                 [&](const RigidMotion& motion) { return !(motion == start); });
  return onwards(start, next == motions_.end() ? start : *next);
}

FineParts FinePath::onwards(const RigidMotion& from, const RigidMotion& to) const {
  FineParts parts;
  if (!travels()) return parts;
  const auto here = place(from), there = place(to);
  for (int body = 0; body < 2; ++body) {
    parts[body] = {std::min(here[body], there[body]), std::max(here[body], there[body])};
    if (there[body] > here[body]) parts[body].high = std::max(parts[body].high, here[body] + stride_);
    if (there[body] < here[body]) parts[body].low = std::min(parts[body].low, here[body] - stride_);
  }
  return parts;
}

bool FinePath::holds(const FineParts& parts, const RigidMotion& motion) const {
  const double tolerance = 1e-6 * sizes_.spacing_particle;
  const auto at = place(motion);
  return parts[0].holds(at[0], tolerance) && parts[1].holds(at[1], tolerance);
}

FineParts FinePath::with_margin(FineParts parts) const {
  for (auto& part : parts) part.low -= margin_, part.high += margin_;
  return parts;
}

}  // namespace asperity::fem
