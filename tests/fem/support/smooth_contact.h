// A smooth sphere of 8.5 um on a smooth block, driven through loads, and what Hertz predicts for it: the
// driver of the verification tests. Plain numbers only, so that the tests need not know deal.II.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "fem/levels/cell_materials.h"

namespace asperity::test {

struct SmoothContactOptions {
  fem::J2Material particle, substrate;
  std::array<fem::Film, 2> films{};  ///< on them
  double radius = 8.5e-6;
  double block_half_width = 6e-6;
  double spacing = 0;         ///< of the particle's interface nodes [m]
  double largest_radius = 0;  ///< of contact that the mesh must hold [m]
  /// Spacing of the substrate over that of the particle. Pressures live on the particle's nodes: where the
  /// particle is much the stiffer, the substrate must be the finer mesh, or pressures oscillate that no
  /// displacement can see.
  double substrate_spacing = 1.1;
  double layers = 4;  ///< of cells per distance to the contact, see ContactMeshOptions
};

/// Hertz (1882), Johnson (1985) ch. 4.
struct LoadedHertz {
  double radius, modulus, force;
  double contact_radius() const;
  double approach() const { return contact_radius() * contact_radius() / radius; }
  double peak_pressure() const;
};

/// What one load step gives. Approach is corrected for the finite bodies.
struct ContactStep {
  double force = 0, approach = 0, raw_approach = 0;
  double contact_radius = 0;  ///< of the circle of equal area [m]
  double peak_pressure = 0;
  double reaction_driven = 0, reaction_fixed = 0;
  double elastic_energy = 0, plastic_work = 0;
  double von_mises = 0,
         von_mises_depth = 0;  ///< largest below the substrate's contact, on its axis, and its depth [m]
  double particle_von_mises = 0, particle_von_mises_depth = 0;
  double plastic_strain = 0;
  double load_step_error = 0;  ///< as stated, of the approach [m]
  double yield_ratio = 0;
  int newton = 0, linear = 0, updates = 0;
  bool converged = false, reaches_rim = false;
};

class SmoothContact {
 public:
  explicit SmoothContact(const SmoothContactOptions& options);
  ~SmoothContact();

  /// Equilibrium at a force [N], made the new accepted state. With `guess` the bodies are first pushed
  /// together by Hertz' approach of that force.
  ContactStep load(double force);

  LoadedHertz hertz(double force) const;
  double reduced_modulus() const;
  long unknowns() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> it_;
};

}  // namespace asperity::test
