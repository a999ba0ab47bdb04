// Internal forces of both bodies from displacement and history of plastic and viscous strain, and the history
// itself.
//
// History is kept only for batches of cells that have yielded or relax, and changes only in accept().
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "fem/cells/step_failure.h"
#include "fem/solver/hex_operator.h"

namespace asperity::fem {

/// Energies [J] and extremes of the bodies at an accepted state.
struct BodyEnergies {
  double elastic = 0;  ///< stored elastically
  /// Increment of the work of stress on plastic and viscous strain since the last accepted state.
  double plastic_work = 0;
  double hardening = 0;                    ///< stored by hardening and by delayed elasticity (not dissipated)
  double plastic_volume = 0;               ///< volume of points with plastic strain [m^3]
  std::array<double, 2> plastic_strain{};  ///< largest of particle and substrate
  std::array<double, 2> von_mises{};       ///< the same [Pa]
  /// Of both bodies [-], [Pa].
  double largest_plastic_strain() const { return std::max(plastic_strain[0], plastic_strain[1]); }
  /// Of both bodies [Pa].
  double largest_von_mises() const { return std::max(von_mises[0], von_mises[1]); }
  double largest_yield_ratio = 0;  ///< von Mises over initial yield stress
  /// Error from the rotation of the flow direction within the last step at its size, over the volume [J]; see
  /// load_step_error.h.
  double flow_turn = 0;
  double approach_error = 0;  ///< accumulated error of all steps in the approach [m]
};

/// Stress and history of a cell, averages over its points (for output).
struct CellState {
  SymmetricTensor<double> stress;    ///< xx yy zz xy yz xz [Pa]
  double von_mises, plastic_strain;  ///< [Pa], [-]
};

class PlasticBodies {
 public:
  /// What a point of integration keeps.
  struct PointHistory : PlasticState<Simd<double>> {
    SymmetricTensor<Simd<double>>
        flow_error{};  ///< error of the plastic strain from finite steps (load_step_error.h)
  };
  using History = std::array<PointHistory, points_per_hex>;

  /// positions: of the nodes, ghosts up to date; they must outlive the bodies.
  PlasticBodies(const MeshLevel& level, const Vector<double>& positions, const CellMaterials& materials);

  /// Of the step that the next calls are about, up to accept_step(); `accepted`: displacement at its
  /// beginning, ghosts up to date.
  void begin_step(const StepTime& time, const Vector<double>& accepted);

  /// f = internal nodal forces for displacement u (ghosts up to date), not condensed, ghosts not compressed.
  /// Fills the tangents of yielding batches where `tangent` is given. Throws StepFailure, on all ranks, where
  /// a return map fails.
  void internal_force(const Vector<double>& u, Vector<double>& f, TangentField* tangent) const;

  /// Energies and internal variables of the step from the accepted state `u_before` to `u`, in which the
  /// contact force grows by `force_change` [N] (0: too small for the tangent compliance); the accepted state
  /// stays. Throws as internal_force().
  BodyEnergies try_step(const Vector<double>& u_before, const Vector<double>& u, double force_change);

  /// Makes the state of the last try_step() the accepted one.
  void accept_step();

  /// Both at once.
  /// force_change [N].
  BodyEnergies accept(const Vector<double>& u_before, const Vector<double>& u, double force_change = 0) {
    const BodyEnergies energies = try_step(u_before, u, force_change);
    accept_step();
    return energies;
  }

  /// Averages per owned cell in the order of the batches.
  std::vector<CellState> cell_states(const Vector<double>& u) const;

  /// History as plain numbers, for checkpoints; restore throws WorkError if it does not fit this mesh.
  std::vector<double> save_history() const;
  void restore_history(const std::vector<double>& saved);

  /// What a cell has of it, if it has yielded: numbers for take_history_of_cell() of this or another mesh.
  static constexpr int numbers_of_point = 6 + 1 + 6;  ///< plastic strain, equivalent one, flow error
  using CellHistory = std::array<std::array<double, numbers_of_point>, points_per_hex>;
  std::optional<CellHistory> history_of_cell(int batch, int lane) const;
  void take_history_of_cell(int batch, int lane, const CellHistory& taken);
  /// Error of all steps in the approach so far [m].
  double approach_error() const { return approach_error_; }
  void take_approach_error(double error) { approach_error_ = error; }

  /// Whether their tangents are other than the elastic ones.
  bool are_inelastic() const { return materials_.can_yield() || materials_.relaxes(); }

 private:
  void evaluate(int batch, const double* u, HexStrain<Simd<double>>& strain) const;
  /// Of a point in this step, from deviators of strain at its beginning and now; the result: what a lane's
  /// tangent is multiplied by [-].
  Simd<double> relax(const CellBatch& batch, const SymmetricTensor<Simd<double>>& before,
                     const SymmetricTensor<Simd<double>>& now, PlasticState<Simd<double>>& state) const;
  /// Parts of try_step(): what a thread or a rank sums up, a point of the step, and their functions.
  struct StepSums;
  struct PointStep;
  void try_batch(int index, const double* u_before, const double* u, StepFailures& failures, StepSums& sums);
  /// Of lane l of a point with `volume` [m^3].
  static void add_lane(const PointStep& step, const J2Material& material, int body, double volume, int l,
                       const PointHistory& old, PointHistory& updated, StepSums& sums);
  /// Collective.
  BodyEnergies of_all_ranks(const StepSums& own, double force_change);

  const MeshLevel& level_;
  const double* positions_;  ///< of the local nodes [m]
  CellMaterials materials_;
  StepTime time_;
  Vector<double> accepted_;  ///< displacement at the beginning of the step; empty: none relaxes
  std::vector<RelaxationStep> relaxation_{};  ///< of each material in this step; empty: between steps
  double approach_error_ = 0, tried_approach_error_ = 0;  ///< [m], of all ranks
  std::vector<std::unique_ptr<History>> history_,
      tried_;  ///< accepted; of the step that is tried, where it yields
};

}  // namespace asperity::fem
