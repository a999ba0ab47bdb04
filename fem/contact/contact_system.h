// Both bodies, their meshes, the coupling of their interfaces and the solver's levels: all that stays fixed
// while loads change.
#pragma once

#include <memory>

#include "fem/mortar/coupling.h"
#include "fem/mortar/interface_operator.h"
#include "fem/solver/linear_solver.h"
#include "fem/solver/plastic_bodies.h"
#include "meshing/contact_mesh.h"

namespace asperity::fem {

/// Meshes, materials and the solver of linear systems.
struct ContactSystemOptions {
  meshing::ContactMeshOptions mesh;
  std::array<J2Material, 2> materials;  ///< particle, substrate
  std::array<Film, 2> films{};          ///< on them
  Control control = Control::force;
  std::string backend = "matrix-free";  ///< see make_linear_solver
  /// Whether pressure acts along the normals of the substrate's deformed surface, as it must where bodies
  /// slide over asperities, or along z. Without sliding the difference is of second order in slopes.
  bool tilted_normals = false;
};

class ContactSystem {
 public:
  ContactSystem(MPI_Comm communicator, const ContactSystemOptions& options);

  const MeshLevel& level() const { return *level_; }
  const ContactSystemOptions& options() const { return options_; }
  const meshing::RoughGeometry& geometry() const { return geometry_; }
  const CellMaterials& materials() const { return materials_; }
  const meshing::Triangulation& forest() const { return *forest_; }
  const Vector<double>& positions() const { return positions_; }
  const std::vector<GapRow>& rows() const { return rows_; }
  const std::vector<double>& areas() const { return areas_; }  ///< of each row [m^2]
  const std::vector<double>& initial_gaps() const {
    return gaps_;
  }  ///< of each row, without displacements [m]
  const Coupling& coupling() const { return coupling_; }
  const InterfaceOperator& interface() const { return *interface_; }
  InterfaceOperator& interface() { return *interface_; }
  /// As it was before the last shift.
  const InterfaceOperator& interface_before() const {
    return interface_before_ ? *interface_before_ : *interface_;
  }
  /// Place of each interface node in its body's frame [m].
  const std::vector<std::array<double, 3>>& interface_points() const { return interface_points_; }
  LinearSolver& linear() { return *linear_; }
  const LinearSolver& linear() const { return *linear_; }
  /// Another one of the bodies without their films, `other`: of these in their place; null: it is linear().
  std::unique_ptr<LinearSolver> linear_without_films(const std::array<J2Material, 2>* other = nullptr) const;
  /// Place of each row's node in the substrate's frame, without shift, displacement and, without tilted
  /// normals, spin [m].
  const std::vector<std::array<double, 3>>& row_points() const { return row_points_; }
  PlasticBodies& bodies() { return *bodies_; }
  const PlasticBodies& bodies() const { return *bodies_; }

  /// Couples the interfaces anew: the same rows with other weights, gaps, and, with tilted normals, slopes,
  /// those of the substrate displaced by `accepted`. Spin is heeded with tilted normals only. Collective.
  void couple_at(Coupling coupling, const Vector<double>& accepted);
  /// With tilted normals: slopes of the substrate displaced by `displacement`. Collective.
  void follow_slopes(const Vector<double>& displacement);

  /// Rows at the corners of each face of the particle's contact region, lexicographic.
  const std::vector<std::array<int, 4>>& row_quads() const { return row_quads_; }

  /// Reduced modulus E* of the pair, or of others [Pa].
  double reduced_modulus() const { return reduced_modulus(options_.materials); }
  static double reduced_modulus(const std::array<J2Material, 2>& bodies);
  /// G* likewise [Pa], 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2 (Mindlin 1949).
  double reduced_shear_modulus() const { return reduced_shear_modulus(options_.materials); }
  static double reduced_shear_modulus(const std::array<J2Material, 2>& bodies);
  /// G of both bodies in series [Pa], 1/G = 1/G1 + 1/G2, which governs torsion.
  double torsion_modulus() const;
  /// Rows whose node lies on the rim of the meshed contact region: contact there means the region is too
  /// small.
  const std::vector<char>& on_rim() const { return on_rim_; }

 private:
  void find_faces();
  void couple();
  void tilt(const Vector<double>& displacement);
  void find_initial_gaps();
  void describe_rows();
  std::unique_ptr<LinearSolver> linear_solver(const CellMaterials& materials) const;

  ContactSystemOptions options_;
  meshing::RoughGeometry geometry_;
  std::unique_ptr<meshing::Triangulation> forest_;
  CellMaterials materials_;
  std::unique_ptr<MeshLevel> level_;
  Vector<double> positions_;
  std::unique_ptr<PlasticBodies> bodies_;
  std::unique_ptr<InterfaceOperator> interface_, interface_before_;
  std::unique_ptr<LinearSolver> linear_;
  std::array<std::vector<PlaneFace>, 2> faces_;  ///< that can touch, each body's in its own frame
  Coupling coupling_;
  std::vector<std::array<double, 2>>
      elastic_;  ///< displacement of each row that the coupling brings along [m]
  std::vector<GapRow> rows_;
  std::vector<double> areas_, gaps_, untilted_gaps_;
  std::vector<std::array<double, 3>> interface_points_, row_points_;
  std::vector<char> on_rim_;
  std::vector<std::array<int, 4>> row_quads_;
};

}  // namespace asperity::fem
