// The solved contact that operators, solvers and set-up are measured on.
#pragma once

#include <memory>
#include <vector>

#include "fem/contact/contact_solver.h"
#include "fem/solver/matrix_free_solver.h"

namespace asperity::hot_paths {

using namespace fem;

/// The rough contact of rough_contact.prm at its largest load, on a mesh of 3e5 unknowns.
struct Scene {
  std::unique_ptr<ContactSystem> system;
  ContactState state;
  TangentField tangent;
  std::vector<RowStiffness> stiffness;  ///< of the rows in contact
  HexOperator<double> exact;
  HexOperator<float> single;
  std::unique_ptr<meshing::Triangulation> coarse_forest;
  std::unique_ptr<MeshLevel> coarse;
  double yielding = 0;  ///< share of the cell batches with plastic tangents

  Scene();

  Multigrid& multigrid();
  double unknowns() const { return static_cast<double>(system->level().size()); }
  template <typename Number>
  Vector<Number> vector() const {
    Vector<Number> v;
    system->level().initialise(v);
    return v;
  }
  /// The solution as a vector to apply operators to, of unit size.
  template <typename Number>
  Vector<Number> sample() const {
    Vector<Number> v = vector<Number>();
    const double scale = 1 / state.displacement.linfty_norm();
    for (unsigned i = 0; i < v.locally_owned_size(); ++i)
      v.local_element(i) = static_cast<Number>(scale * state.displacement.local_element(i));
    return v;
  }
};

/// Made by main(); null before.
extern std::unique_ptr<Scene> scene;

}  // namespace asperity::hot_paths
