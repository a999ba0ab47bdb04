// A step of both bodies on trial: what it stores, dissipates and makes of the history.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/threads.h"
#include "fem/solver/batch_materials.h"
#include "fem/solver/load_step_error.h"
#include "fem/solver/plastic_bodies.h"

namespace asperity::fem {
namespace {

using V = Simd<double>;

}  // namespace

struct PlasticBodies::StepSums {
  double elastic = 0, plastic_work = 0, hardening = 0, turned = 0, left_over = 0;  ///< [J]
  double plastic_volume = 0;                                                       ///< [m^3]
  double largest_strain[2] = {}, largest_stress[2] = {};  ///< of particle and substrate [-], [Pa]
  double largest_ratio = 0;

  void add(const StepSums& other) {
    elastic += other.elastic, plastic_work += other.plastic_work, hardening += other.hardening;
    turned += other.turned, left_over += other.left_over, plastic_volume += other.plastic_volume;
    for (int body = 0; body < 2; ++body) {
      largest_strain[body] = std::max(largest_strain[body], other.largest_strain[body]);
      largest_stress[body] = std::max(largest_stress[body], other.largest_stress[body]);
    }
    largest_ratio = std::max(largest_ratio, other.largest_ratio);
  }
};

/// A point of integration of a batch in the step, after the return map.
struct PlasticBodies::PointStep {
  SymmetricTensor<V> stress, increment, change_of_stress;  ///< deviators [Pa], of plastic strain
  SymmetricTensor<V> relative_before, trial;               ///< relative to the back stress [Pa]
  V work, stored, mises;                                   ///< [J], [J], [Pa]

  PointStep(const BatchMaterials& material, const SymmetricTensor<V>& stress_before,
            const SymmetricTensor<V>& stress_after, const HexStrain<V>& strain, const HexStrain<V>& before,
            int q, const PointHistory& old, const PointHistory& updated)
      : stress(stress_after) {
    SymmetricTensor<V> mean_stress, elastic_strain;
    for (int c = 0; c < 6; ++c) {
      increment[c] = updated.strain[c] - old.strain[c];
      mean_stress[c] = 0.5 * (stress[c] + stress_before[c]);
      elastic_strain[c] = strain.deviator[q][c] - updated.strain[c];
      change_of_stress[c] = stress[c] - stress_before[c];
      for (int l = 0; l < lanes; ++l)
        relative_before[c][l] =
            stress_before[c][l] - material.lane[l]->kinematic_modulus * (2.0 / 3.0) * old.strain[c][l];
      trial[c] = relative_before[c] + 2.0 * material.shear * (strain.deviator[q][c] - before.deviator[q][c]);
    }
    work = double_contraction(mean_stress, increment) * strain.volume[q];
    stored =
        0.5 *
        (double_contraction(stress, elastic_strain) + material.bulk * strain.dilatation * strain.dilatation) *
        strain.volume[q];
    mises = square_root(V(1.5 * double_contraction(stress, stress)));
  }
};

inline void PlasticBodies::add_lane(const PointStep& step, const J2Material& material, int body,
                                    double volume, int l, const PointHistory& old, PointHistory& updated,
                                    StepSums& sums) {
  const double alpha = updated.alpha[l];
  sums.elastic += step.stored[l];
  sums.plastic_work += step.work[l];
  FlowTurn turn;
  if (alpha > old.alpha[l]) {
    const double limit = std::sqrt(2.0 / 3.0) * material.flow_stress(old.alpha[l]);
    turn = flow_turn(step.relative_before, step.trial, limit, step.increment, step.change_of_stress, l);
    sums.turned += turn.energy * volume;
  }
  for (int c = 0; c < 6; ++c) {
    updated.flow_error[c][l] += turn.strain[c];
    sums.left_over += (c < 3 ? 1 : 2) * updated.flow_error[c][l] * step.change_of_stress[c][l] * volume;
  }
  if (alpha > 0 || material.relaxation.is_there()) {
    double square = 0;
    for (int c = 0; c < 6; ++c) square += (c < 3 ? 1 : 2) * updated.strain[c][l] * updated.strain[c][l];
    sums.hardening += (material.isotropic_energy(alpha) + material.kinematic_modulus * square / 3) * volume;
    if (material.relaxation.is_there())
      sums.hardening += material.relaxation.delayed_modulus(material.shear_modulus) * square * volume;
    if (alpha > 0) sums.plastic_volume += volume;
  }
  sums.largest_strain[body] = std::max(sums.largest_strain[body], alpha);
  sums.largest_stress[body] = std::max(sums.largest_stress[body], step.mises[l]);
  sums.largest_ratio = std::max(sums.largest_ratio, step.mises[l] / material.yield_stress);
}

inline void PlasticBodies::try_batch(int index, const double* u_before, const double* u,
                                     StepFailures& failures, StepSums& sums) {
  const CellBatch& batch = level_.batches()[index];
  const BatchMaterials material(batch, materials_);
  HexStrain<V> strain, before;
  evaluate(index, u, strain);
  evaluate(index, u_before, before);
  const bool relaxes = material.relaxes && !relaxation_.empty();
  bool changes = relaxes;
  History updated = history_[index] ? *history_[index] : History{};
  for (int q = 0; q < points_per_hex; ++q) {
    SymmetricTensor<V> stress, stress_before;
    J2Tangent<V> tangent;
    const PointHistory old = updated[q];
    for (int c = 0; c < 6; ++c)
      stress_before[c] = 2.0 * material.shear * (before.deviator[q][c] - old.strain[c]);
    if (relaxes) relax(batch, before.deviator[q], strain.deviator[q], updated[q]);
    failures.guard([&] {
      changes =
          return_map(material.lane, material.shear, strain.deviator[q], updated[q], stress, tangent, time_) ||
          changes;
    });
    const PointStep step(material, stress_before, stress, strain, before, q, old, updated[q]);
    for (int l = 0; l < batch.count; ++l)
      add_lane(step, *material.lane[l], batch.body[l], strain.volume[q][l], l, old, updated[q], sums);
  }
  if (changes)
    tried_[index] = std::make_unique<History>(updated);
  else
    tried_[index].reset();
}

BodyEnergies PlasticBodies::try_step(const Vector<double>& u_before, const Vector<double>& u,
                                     double force_change) {
  constexpr int block = 64;
  const int count = static_cast<int>(level_.batches().size()), blocks = (count + block - 1) / block;
  std::vector<StepSums> sums_of_block(blocks);  // so that they are the same on any number of threads
  StepFailures failures;
  for_parts(blocks, 1, [&](int b, int end) {
    for (; b < end; ++b)
      for (int index = b * block; index < std::min(count, (b + 1) * block); ++index)
        try_batch(index, u_before.begin(), u.begin(), failures, sums_of_block[b]);
  });
  failures.throw_on_all(level_.communicator());
  StepSums sums;
  for (const StepSums& part : sums_of_block) sums.add(part);
  return of_all_ranks(sums, force_change);
}

BodyEnergies PlasticBodies::of_all_ranks(const StepSums& own, double force_change) {
  const MPI_Comm comm = level_.communicator();
  BodyEnergies sum;
  sum.elastic = dealii::Utilities::MPI::sum(own.elastic, comm);
  sum.plastic_work = dealii::Utilities::MPI::sum(own.plastic_work, comm);
  sum.hardening = dealii::Utilities::MPI::sum(own.hardening, comm);
  sum.flow_turn = dealii::Utilities::MPI::sum(own.turned, comm);
  // At constant load the tangent compliance, and so the error of the approach, stays as it was.
  const double left_over = dealii::Utilities::MPI::sum(own.left_over, comm);
  sum.approach_error = tried_approach_error_ = force_change != 0 ? left_over / force_change : approach_error_;
  sum.plastic_volume = dealii::Utilities::MPI::sum(own.plastic_volume, comm);
  for (int body = 0; body < 2; ++body) {
    sum.plastic_strain[body] = dealii::Utilities::MPI::max(own.largest_strain[body], comm);
    sum.von_mises[body] = dealii::Utilities::MPI::max(own.largest_stress[body], comm);
  }
  sum.largest_yield_ratio = dealii::Utilities::MPI::max(own.largest_ratio, comm);
  return sum;
}

void PlasticBodies::accept_step() {
  approach_error_ = tried_approach_error_;
  relaxation_.clear();
  for (std::size_t index = 0; index < history_.size(); ++index)
    if (tried_[index]) history_[index] = std::move(tried_[index]);
}

}  // namespace asperity::fem
