// Where the two surfaces are coupled: at the motion of the frames, further moved by what both surfaces
// displace elastically.
#pragma once

#include <array>
#include <vector>

#include "fem/mortar/rigid_motion.h"

namespace asperity::fem {

/// Mean displacement of the particle's surface in its frame relative to the substrate's, along the interface:
/// a shift and a turn about the particle's axis.
struct SurfaceDisplacement {
  double x = 0, y = 0;  ///< [m]
  double turn = 0;      ///< [rad]
};

inline bool operator==(const SurfaceDisplacement& a, const SurfaceDisplacement& b) {
  return a.x == b.x && a.y == b.y && a.turn == b.turn;
}

struct Coupling {
  RigidMotion frames;           ///< turns displacements and forces
  SurfaceDisplacement elastic;  ///< the displacements bring it along once more; gaps leave it out

  /// Motion of the particle's surface over the substrate's.
  RigidMotion surface() const {
    RigidMotion moved = frames;
    moved.x += elastic.x, moved.y += elastic.y, moved.spin += elastic.turn;
    return moved;
  }
};

/// The shift and turn that come closest to the displacements `along` x and y of points at `place` [m], each
/// with its weight: least squares for small turns. Nothing without weight; no turn where all weight lies in
/// one point.
SurfaceDisplacement mean_surface_displacement(const std::vector<std::array<double, 3>>& place,
                                              const std::vector<double>& weight,
                                              const std::array<std::vector<double>, 2>& along);

inline bool operator==(const Coupling& a, const Coupling& b) {
  return a.frames == b.frames && a.elastic == b.elastic;
}

}  // namespace asperity::fem
