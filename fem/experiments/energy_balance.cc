#include "fem/experiments/energy_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/experiments/external_work.h"

namespace asperity::fem {
namespace {

/// Stored energy (bodies and attraction) plus dissipation up to a step [J].
double stored_energy(const HistoryRow& r) {
  return r.elastic_energy + r.plastic_work + r.friction_work + r.adhesion_energy + r.adhesion_loss;
}

/// Work of shift, roll and spin in one step [J]: a trapezium.
double sideways_work(const HistoryRow& a, const HistoryRow& b, double radius) {
  double work = 0.5 * (a.lateral_force + b.lateral_force) * (b.shift - a.shift) +
                0.5 * (a.torsion_moment + b.torsion_moment) * (b.torsion_angle - a.torsion_angle);
  work += 0.5 * (a.lateral_force_across + b.lateral_force_across) * (b.shift_across - a.shift_across);
  // The moment about the contact comes with a lateral force at the particle's centre; the axis of rolling
  // spins with the particle.
  const auto about_centre = [&](const HistoryRow& r) {
    return r.rolling_moment - radius * (std::cos(r.torsion_angle) * r.lateral_force +
                                        std::sin(r.torsion_angle) * r.lateral_force_across);
  };
  return work + 0.5 * (about_centre(a) + about_centre(b)) * (b.rolling_angle - a.rolling_angle);
}

}  // namespace

void balance_energy(std::vector<HistoryRow>& records, bool has_adhesion, double rolling_radius) {
  if (records.empty()) return;
  std::vector<double> delta, pressing;
  for (const auto& r : records)
    delta.push_back(r.driven_displacement), pressing.push_back(r.normal_force + r.attraction);
  std::vector<double> work = external_work(delta, pressing);
  // Attraction makes no power law of the approach, it varies little: trapezia, and for what came before the
  // first step what that stores.
  double attracted = has_adhesion ? work.front() - stored_energy(records.front()) : 0.0, sideways = 0;
  for (std::size_t k = 0; k < work.size(); ++k) {
    if (k > 0) {
      attracted += 0.5 * (records[k - 1].attraction + records[k].attraction) * (delta[k] - delta[k - 1]);
      sideways += sideways_work(records[k - 1], records[k], rolling_radius);
    }
    work[k] += sideways - attracted;
  }
  double largest = std::numeric_limits<double>::min();
  for (const double w : work) largest = std::max(largest, std::abs(w));
  for (std::size_t k = 0; k < records.size(); ++k) {
    records[k].work = work[k];
    records[k].energy_error = (work[k] - stored_energy(records[k])) / largest;
  }
}

}  // namespace asperity::fem
