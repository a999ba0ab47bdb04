#include "app/other_surfaces.h"

#include <algorithm>
#include <cmath>

#include "half_space/case_contact.h"

namespace asperity {
namespace {

constexpr int surfaces = 32, forces = 12;

/// The same spectrum with another seed; true: it was generated.
bool reseed(TopographySpec& surface, int realisation) {
  constexpr std::uint64_t far_from_small_seeds = 982451653;
  if (!surface.generator()) return false;
  GeneratorParameters generator = *surface.generator();
  generator.seed += far_from_small_seeds * static_cast<std::uint64_t>(realisation);
  surface = generator;
  return true;
}

/// Approach from first touch on under each force [m].
std::vector<double> approaches(const CaseInput& input, const std::vector<double>& under) {
  constexpr double cells_per_wave = 6, cells_per_radius = 24;
  half_space::CaseContactOptions options;
  options.with_stiffness = false;
  options.most_cells = 512;
  options.spacing = std::min(half_space::shortest_wave(input) / cells_per_wave,
                             hertz_of(input).contact_radius(under.back()) / cells_per_radius);
  std::vector<double> list;
  for (const auto& contact : half_space::contacts_under(input, under, options))
    list.push_back(contact.approach() - contact.first_touch);
  return list;
}

}  // namespace

OtherSurfaces other_surfaces_of(const CaseInput& input, double largest_force) {
  constexpr double seen = 2e-3;  // of the largest force
  OtherSurfaces other_surfaces;
  std::vector<double> under, own;
  for (int i = 0; i < forces; ++i) under.push_back(largest_force * std::pow(seen, 1 - i / (forces - 1.0)));
  double apart = 0;
  for (int k = 1; k <= surfaces; ++k) {
    CaseInput other = input;
    const bool particle = reseed(other.particle.topography, k),
               substrate = reseed(other.substrate.topography, k);
    if (!particle && !substrate) return {};
    if (own.empty()) own = approaches(input, under);
    SurfaceChange change{under, approaches(other, under)};
    const double first = change.displacement.front() - own.front();
    for (std::size_t i = 0; i < own.size(); ++i) change.displacement[i] -= own[i] + first;
    apart += first * first / surfaces;
    other_surfaces.changes.push_back(std::move(change));
  }
  // Displacement is counted from first touch, as the case does, or from where an instrument sees it.
  other_surfaces.unseen = std::max(own.front(), std::sqrt(apart));
  return other_surfaces;
}

}  // namespace asperity
