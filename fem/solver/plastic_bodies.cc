#include "fem/solver/plastic_bodies.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "fem/solver/batch_materials.h"

namespace asperity::fem {
namespace {

using V = Simd<double>;

double von_mises(const SymmetricTensor<double>& s) {
  const double mean = (s[0] + s[1] + s[2]) / 3;
  const double a = s[0] - mean, b = s[1] - mean, c = s[2] - mean;
  return std::sqrt(1.5 * (a * a + b * b + c * c + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])));
}

}  // namespace

PlasticBodies::PlasticBodies(const MeshLevel& level, const Vector<double>& positions,
                             const CellMaterials& materials)
    : level_(level),
      positions_(positions.begin()),
      materials_(materials),
      history_(level.batches().size()),
      tried_(level.batches().size()) {}

void PlasticBodies::begin_step(const StepTime& time, const Vector<double>& accepted) {
  time_ = time;
  if (!materials_.relaxes()) return;
  accepted_ = accepted;
  accepted_.update_ghost_values();
  relaxation_.clear();
  for (const J2Material& material : materials_.all())
    relaxation_.emplace_back(material.relaxation, time.step);
}

V PlasticBodies::relax(const CellBatch& batch, const SymmetricTensor<V>& before,
                       const SymmetricTensor<V>& now, PlasticState<V>& state) const {
  V tangent = V{} + 1.0;
  for (int l = 0; l < lanes; ++l) {
    const RelaxationStep& step = relaxation_[batch.material[l]];
    if (!(step.share > 0)) continue;
    fem::relax(step, before, now, l, state.strain);
    tangent[l] = step.tangent();
  }
  return tangent;
}

void PlasticBodies::evaluate(int index, const double* u, HexStrain<V>& strain) const {
  const CellBatch& batch = level_.batches()[index];
  V nodes[3][8];
  load_nodes(batch, positions_, nodes);
  evaluate_geometry<double>(nodes, strain);
  load_nodes(batch, u, nodes);
  evaluate_strain<double>(nodes, strain);
}

void PlasticBodies::internal_force(const Vector<double>& u, Vector<double>& f, TangentField* tangent) const {
  if (tangent) tangent->batch.resize(level_.batches().size());
  const double* x = u.begin();
  double* y = f.begin();
  StepFailures failures;
  level_.for_each_batch([&](int index) {
    const CellBatch& batch = level_.batches()[index];
    const BatchMaterials material(batch, materials_);
    HexStrain<V> strain, before;
    evaluate(index, x, strain);
    const bool relaxes = material.relaxes && !relaxation_.empty();
    if (relaxes) evaluate(index, accepted_.begin(), before);
    std::array<SymmetricTensor<V>, points_per_hex> stress;
    TangentField::Batch tangents;
    bool changes = relaxes;
    for (int q = 0; q < points_per_hex; ++q) {
      if (!material.is_inelastic) {
        for (int c = 0; c < 6; ++c) stress[q][c] = 2.0 * material.shear * strain.deviator[q][c];
        continue;
      }
      PlasticState<V> state = history_[index] ? (*history_[index])[q] : PlasticState<V>{};
      J2Tangent<V> point;
      const V left = relaxes ? relax(batch, before.deviator[q], strain.deviator[q], state) : V{} + 1.0;
      failures.guard([&] {
        changes =
            return_map(material.lane, material.shear, strain.deviator[q], state, stress[q], point, time_) ||
            changes;
      });
      point.theta *= left;
      for (int l = 0; l < lanes; ++l) {
        tangents[q].theta[l] = static_cast<float>(point.theta[l]);
        tangents[q].theta_bar[l] = static_cast<float>(point.theta_bar[l]);
        for (int c = 0; c < 6; ++c) tangents[q].normal[c][l] = static_cast<float>(point.normal[c][l]);
      }
    }
    if (tangent) {
      auto& stored = tangent->batch[index];
      if (!changes)
        stored.reset();
      else if (stored)
        *stored = tangents;
      else
        stored = std::make_unique<TangentField::Batch>(tangents);
    }
    V forces[3][8];
    integrate_stress<double>(strain, stress, material.bulk * strain.dilatation, forces);
    add_nodes(batch, forces, y);
  });
  if (are_inelastic()) failures.throw_on_all(level_.communicator());
}

std::vector<CellState> PlasticBodies::cell_states(const Vector<double>& u) const {
  std::vector<CellState> states;
  for (int index = 0; index < static_cast<int>(level_.batches().size()); ++index) {
    const CellBatch& batch = level_.batches()[index];
    const BatchMaterials material(batch, materials_);
    HexStrain<V> strain;
    evaluate(index, u.begin(), strain);
    for (int l = 0; l < batch.count; ++l) {
      CellState cell{};
      for (int q = 0; q < points_per_hex; ++q) {
        for (int c = 0; c < 6; ++c) {
          const double plastic = history_[index] ? (*history_[index])[q].strain[c][l] : 0.0;
          cell.stress[c] += 2 * material.shear[l] * (strain.deviator[q][c][l] - plastic) / points_per_hex;
        }
        if (history_[index]) cell.plastic_strain += (*history_[index])[q].alpha[l] / points_per_hex;
      }
      for (int c = 0; c < 3; ++c) cell.stress[c] += material.bulk[l] * strain.dilatation[l];
      cell.von_mises = von_mises(cell.stress);
      states.push_back(cell);
    }
  }
  return states;
}

std::vector<double> PlasticBodies::save_history() const {
  std::vector<double> saved{static_cast<double>(history_.size()), approach_error_};
  for (std::size_t index = 0; index < history_.size(); ++index) {
    if (!history_[index]) continue;
    saved.push_back(static_cast<double>(index));
    for (const auto& point : *history_[index]) {
      for (const auto& component : point.strain)
        for (int l = 0; l < lanes; ++l) saved.push_back(component[l]);
      for (int l = 0; l < lanes; ++l) saved.push_back(point.alpha[l]);
      for (const auto& component : point.flow_error)
        for (int l = 0; l < lanes; ++l) saved.push_back(component[l]);
    }
  }
  return saved;
}

void PlasticBodies::restore_history(const std::vector<double>& saved) {
  constexpr std::size_t record = 1 + points_per_hex * numbers_of_point * lanes;
  if (saved.size() < 2 || saved[0] != static_cast<double>(history_.size()) ||
      (saved.size() - 2) % record != 0)
    throw WorkError(
        "the checkpoint belongs to another mesh or number of ranks; solve again with --overwrite");
  for (auto& history : history_) history.reset();
  for (auto& history : tried_) history.reset();
  approach_error_ = saved[1];
  for (std::size_t at = 2; at < saved.size(); at += record) {
    auto history = std::make_unique<History>();
    std::size_t k = at + 1;
    for (auto& point : *history) {
      for (auto& component : point.strain)
        for (int l = 0; l < lanes; ++l) component[l] = saved[k++];
      for (int l = 0; l < lanes; ++l) point.alpha[l] = saved[k++];
      for (auto& component : point.flow_error)
        for (int l = 0; l < lanes; ++l) component[l] = saved[k++];
    }
    history_[static_cast<std::size_t>(saved[at])] = std::move(history);
  }
}

std::optional<PlasticBodies::CellHistory> PlasticBodies::history_of_cell(int batch, int lane) const {
  if (!history_[batch]) return std::nullopt;
  CellHistory taken;
  bool yielded = false;
  for (int q = 0; q < points_per_hex; ++q) {
    const PointHistory& point = (*history_[batch])[q];
    yielded = yielded || point.alpha[lane] > 0;
    for (int c = 0; c < 6; ++c) {
      taken[q][c] = point.strain[c][lane];
      taken[q][7 + c] = point.flow_error[c][lane];
    }
    taken[q][6] = point.alpha[lane];
  }
  if (!yielded) return std::nullopt;
  return taken;
}

void PlasticBodies::take_history_of_cell(int batch, int lane, const CellHistory& taken) {
  if (!history_[batch]) history_[batch] = std::make_unique<History>();
  const auto put = [&](int l) {
    for (int q = 0; q < points_per_hex; ++q) {
      PointHistory& point = (*history_[batch])[q];
      for (int c = 0; c < 6; ++c) {
        point.strain[c][l] = taken[q][c];
        point.flow_error[c][l] = taken[q][7 + c];
      }
      point.alpha[l] = taken[q][6];
    }
  };
  put(lane);
  // The lanes beyond those that a batch has repeat the first.
  for (int l = level_.batches()[batch].count; lane == 0 && l < lanes; ++l) put(l);
}

}  // namespace asperity::fem
