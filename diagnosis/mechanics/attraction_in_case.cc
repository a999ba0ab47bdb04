#include "diagnosis/mechanics/attraction_in_case.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {
namespace {

/// Spacing of the case's mesh, or of one that is finer by a power of the root of two and resolves the zone
/// [m].
double resolving_spacing(const Experiment& e, double work, double range, double cells) {
  const double enough = attraction_zone(e.reduced_modulus(), work, work / range) / cells;
  double spacing = e.case_spacing;
  while (spacing > enough) spacing /= M_SQRT2;
  return spacing;
}

constexpr double lambda_of_jkr = 10, lambda_of_fit = 0.924;

}  // namespace

double lambda_of_transition(double alpha) {
  return -lambda_of_fit * std::log1p(-alpha * -std::expm1(-lambda_of_jkr / lambda_of_fit));
}

double transition_of_lambda(double lambda) {
  return std::min(1.0, std::expm1(-lambda / lambda_of_fit) / std::expm1(-lambda_of_jkr / lambda_of_fit));
}

std::shared_ptr<const MaugisBranch> maugis_branch(double lambda) {
  constexpr std::size_t most = 4;
  thread_local std::array<std::shared_ptr<const MaugisBranch>, most> kept;
  thread_local std::size_t oldest = 0;
  for (const auto& branch : kept)
    if (branch && branch->lambda() == lambda) return branch;
  std::shared_ptr<const MaugisBranch>& place = kept[oldest];
  oldest = (oldest + 1) % most;
  return place = std::make_shared<const MaugisBranch>(lambda);
}

double range_of_attraction(const Experiment& e, double work, double lambda) {
  const double stiffness = 4.0 / 3 * e.reduced_modulus();
  return 2 * work / lambda * std::cbrt(e.radius / (M_PI * work * stiffness * stiffness));
}

double lambda_of_range(const Experiment& e, double work, double range) {
  return range_of_attraction(e, work, 1) / range;
}

/// The zone is 3 A0/(4 lambda^2), A0: Maugis' unit of radius.
double resolvable_lambda(const Experiment& e, double pull_off, double lambda) {
  constexpr double cells_per_radius = 30, of_pi_w_R = 1.6;
  const double f = e.largest_force, h = pull_off;
  const double pressed = f + 2 * h + std::sqrt(4 * h * f + 4 * h * h);  // Johnson, Kendall & Roberts 1971
  const double radius = std::cbrt(0.75 * pressed * e.radius / e.reduced_modulus());
  const double unit = std::cbrt(0.75 * h * e.radius / (of_pi_w_R * e.reduced_modulus()));
  double finest = radius / cells_per_radius;
  if (e.case_spacing > 0) finest = std::min(finest, e.case_spacing);
  return std::min(lambda, std::sqrt(0.75 * unit / (cells_over_attraction_zone * finest)));
}

std::vector<CaseChange> dugdale_in_case(const Experiment& e, double work, double range, double cells) {
  std::vector<CaseChange> changes{{"Interface/Work of adhesion", work, "J/m^2"},
                                  {"Interface/Adhesion range", range, "m"}};
  const double spacing = resolving_spacing(e, work, range, cells);
  if (e.by_finite_elements && spacing < e.case_spacing) changes.push_back({spacing_entry, spacing, "m"});
  return changes;
}

}  // namespace asperity
