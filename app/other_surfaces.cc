#include "app/other_surfaces.h"

#include <cmath>

#include "half_space/case_contact.h"

namespace asperity {
namespace {

constexpr int surfaces = 16, forces = 6;

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
  constexpr double cells_per_wave = 6, cells_per_radius = 6;
  half_space::CaseContactOptions options;
  options.with_stiffness = false;
  options.most_cells = 512;
  options.spacing = std::min(half_space::shortest_wave(input) / cells_per_wave,
                             hertz_of(input).contact_radius(under.front()) / cells_per_radius);
  std::vector<double> list;
  for (const auto& contact : half_space::contacts_under(input, under, options))
    list.push_back(contact.approach() - contact.first_touch);
  return list;
}

}  // namespace

std::vector<SurfaceChange> changes_on_other_surfaces(CaseInput input, double largest_force) {
  std::vector<SurfaceChange> changes;
  std::vector<double> under;
  for (int i = 0; i < forces; ++i) under.push_back(largest_force * std::pow(10, 0.4 * (i + 1 - forces)));
  input.interface.attraction_force = 0;
  std::vector<double> own;
  for (int k = 1; k <= surfaces; ++k) {
    CaseInput other = input;
    const bool particle = reseed(other.particle.topography, k),
               substrate = reseed(other.substrate.topography, k);
    if (!particle && !substrate) return {};
    if (own.empty()) own = approaches(input, under);
    SurfaceChange change{under, approaches(other, under)};
    for (int i = 0; i < forces; ++i)
      change.displacement[static_cast<std::size_t>(i)] -= own[static_cast<std::size_t>(i)];
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace asperity
