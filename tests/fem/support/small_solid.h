// A small assembled finite-element solid from the solver's own hexahedron and material law, on any list of
// cells: for problems whose shape the contact solver does not mesh (patch tests, thick-walled sphere).
#pragma once

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <array>
#include <map>
#include <vector>

#include "fem/materials/j2_plasticity.h"

namespace asperity::test {

using Point = std::array<double, 3>;

struct SmallSolid {
  using V = fem::Simd<double>;
  using Tangents = std::array<fem::J2Tangent<V>, fem::points_per_hex>;
  using History = std::array<fem::PlasticState<V>, fem::points_per_hex>;

  std::vector<Point> nodes;
  std::vector<std::array<int, 8>> cells;  ///< vertices lexicographic
  std::vector<fem::J2Material> material;  ///< of each cell
  std::vector<History> history;
  std::vector<char> fixed;  ///< of each unknown 3 node + component, value stays as given

  int size() const { return static_cast<int>(3 * nodes.size()); }

  /// Node at a position, made where there is none within `tolerance`.
  int node_at(const Point& p, double tolerance) {
    std::array<long, 3> key;
    for (int c = 0; c < 3; ++c) key[c] = std::lround(p[c] / tolerance);
    const auto [entry, added] = known_.try_emplace(key, static_cast<int>(nodes.size()));
    if (added) nodes.push_back(p);
    return entry->second;
  }
  void add_cell(const std::array<int, 8>& vertices, const fem::J2Material& m) {
    cells.push_back(vertices);
    material.push_back(m);
  }
  void finish() {
    history.assign(cells.size(), History{});
    fixed.assign(size(), 0);
  }

  fem::HexStrain<V> strain(int cell, const Eigen::VectorXd& u) const {
    V x[3][8], displacement[3][8];
    for (int v = 0; v < 8; ++v)
      for (int c = 0; c < 3; ++c)
        for (int l = 0; l < fem::lanes; ++l) {
          x[c][v][l] = nodes[cells[cell][v]][c];
          displacement[c][v][l] = u[3 * cells[cell][v] + c];
        }
    fem::HexStrain<V> s;
    fem::evaluate_geometry<double>(x, s);
    fem::evaluate_strain<double>(displacement, s);
    return s;
  }

  /// Deviatoric stresses, and with them history and tangents at displacement u from the accepted history.
  std::array<fem::SymmetricTensor<V>, 8> stress(int cell, const fem::HexStrain<V>& s, History& updated,
                                                Tangents& tangents) const {
    const fem::J2Material* lane[fem::lanes];
    V shear;
    for (int l = 0; l < fem::lanes; ++l) {
      lane[l] = &material[cell];
      shear[l] = material[cell].shear_modulus;
    }
    updated = history[cell];
    std::array<fem::SymmetricTensor<V>, 8> result;
    for (int q = 0; q < 8; ++q)
      fem::return_map(lane, shear, s.deviator[q], updated[q], result[q], tangents[q]);
    return result;
  }

  /// Full stress at the points of a cell, xx yy zz xy yz xz [Pa].
  std::array<fem::SymmetricTensor<double>, 8> stresses(int cell, const Eigen::VectorXd& u) const {
    History updated;
    Tangents tangents;
    const auto s = strain(cell, u);
    const auto deviator = stress(cell, s, updated, tangents);
    std::array<fem::SymmetricTensor<double>, 8> result;
    for (int q = 0; q < 8; ++q)
      for (int c = 0; c < 6; ++c)
        result[q][c] = deviator[q][c][0] + (c < 3 ? material[cell].bulk_modulus * s.dilatation[0] : 0.0);
    return result;
  }

  /// Internal forces of all nodes; appends the tangent stiffness to `entries` where given.
  Eigen::VectorXd internal_force(const Eigen::VectorXd& u,
                                 std::vector<Eigen::Triplet<double>>* entries) const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(size());
    for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell) {
      History updated;
      Tangents tangents;
      const auto s = strain(cell, u);
      const auto deviator = stress(cell, s, updated, tangents);
      V forces[3][8];
      fem::integrate_stress<double>(s, deviator, material[cell].bulk_modulus * s.dilatation, forces);
      for (int v = 0; v < 8; ++v)
        for (int c = 0; c < 3; ++c) f[3 * cells[cell][v] + c] += forces[c][v][0];
      if (entries) add_tangent(cell, s, tangents, *entries);
    }
    return f;
  }

  /// Newton iterations to equilibrium with `load`; returns their number, or -1 where they do not converge.
  int solve(Eigen::VectorXd& u, const Eigen::VectorXd& load) const {
    for (int iteration = 0; iteration < 40; ++iteration) {
      std::vector<Eigen::Triplet<double>> entries;
      Eigen::VectorXd residual = load - internal_force(u, &entries);
      for (int i = 0; i < size(); ++i)
        if (fixed[i]) residual[i] = 0;
      if (residual.norm() <= 1e-8 * load.norm()) return iteration;
      u += solve_linear(entries, residual);
    }
    return -1;
  }

  Eigen::VectorXd solve_linear(const std::vector<Eigen::Triplet<double>>& entries,
                               const Eigen::VectorXd& rhs) const {
    std::vector<Eigen::Triplet<double>> free;
    for (const auto& e : entries)
      if (!fixed[e.row()] && !fixed[e.col()]) free.push_back(e);
    for (int i = 0; i < size(); ++i)
      if (fixed[i]) free.emplace_back(i, i, 1.0);
    Eigen::SparseMatrix<double> matrix(size(), size());
    matrix.setFromTriplets(free.begin(), free.end());
    if (size() < 3000) return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(rhs);
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                             Eigen::IncompleteCholesky<double>>
        iteration;
    iteration.setTolerance(1e-6);
    iteration.compute(matrix);
    return iteration.solve(rhs);
  }

  void accept(const Eigen::VectorXd& u) {
    for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell) {
      History updated;
      Tangents tangents;
      stress(cell, strain(cell, u), updated, tangents);
      history[cell] = updated;
    }
  }

 private:
  /// Columns of the cell's stiffness, eight unit displacements at a time.
  void add_tangent(int cell, const fem::HexStrain<V>& geometry, const Tangents& tangents,
                   std::vector<Eigen::Triplet<double>>& entries) const {
    const V two_shear = V{} + 2 * material[cell].shear_modulus;
    for (int component = 0; component < 3; ++component) {
      V u[3][8] = {}, forces[3][8];
      for (int v = 0; v < 8; ++v) u[component][v][v] = 1;
      fem::HexStrain<V> s = geometry;
      fem::evaluate_strain<double>(u, s);
      std::array<fem::SymmetricTensor<V>, 8> stress;
      for (int q = 0; q < 8; ++q) {
        const auto& t = tangents[q];
        const V along = t.theta_bar * fem::double_contraction(t.normal, s.deviator[q]);
        for (int c = 0; c < 6; ++c)
          stress[q][c] = two_shear * (t.theta * s.deviator[q][c] - along * t.normal[c]);
      }
      fem::integrate_stress<double>(s, stress, material[cell].bulk_modulus * s.dilatation, forces);
      for (int v = 0; v < 8; ++v)
        for (int c = 0; c < 3; ++c)
          for (int l = 0; l < fem::lanes; ++l)
            entries.emplace_back(3 * cells[cell][v] + c, 3 * cells[cell][l] + component, forces[c][v][l]);
    }
  }
  std::map<std::array<long, 3>, int> known_;
};

}  // namespace asperity::test
