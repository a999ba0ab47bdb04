// Frictionless contact of two elastic half-spaces with rough surfaces, normal to their mean plane: pressures
// that do not pull, and, with a hardness, stay below it (a first model of plastic flow: Almqvist, Sahlin,
// Larsson & Glavatskih 2007, Tribol. Int. 40, 574), by conjugate gradients under these bounds and the given
// load (Polonsky & Keer 1999, Wear 231, 206), from coarse grids to the given one.
//
// Valid for small slopes and contacts that are small against the bodies. What flows under the hardness has no
// work hardening, moves no material aside, and unloads elastically.
#pragma once

#include <limits>
#include <vector>

#include "half_space/compliance.h"

namespace asperity::half_space {

/// Bounds and end of the iteration.
struct NormalContactOptions {
  double hardness = std::numeric_limits<double>::infinity();  ///< largest pressure [Pa]
  double tolerance = 1e-6;  ///< complementarity error of the solution, see NormalContactSolution [-]
  int most_iterations = 1000;
};

struct NormalLoad;

/// Pressures and gaps in equilibrium, and how well.
struct NormalContactSolution {
  Field pressure;        ///< [Pa], of each cell's mean
  Field gap;             ///< under load [m]; below 0 where material flows under the hardness
  double force = 0;      ///< [N]
  double approach = 0;   ///< of the planes that the undeformed gap is counted from [m]
  int iterations = 0;    ///< on the given grid
  int convolutions = 0;  ///< on the given grid
  /// What is left of "no gap under pressure, no overlap without": (sum of p |g| between the bounds + mean
  /// pressure times what overlaps where nothing presses) over the sum of p u [-].
  double error = 0;
};

class NormalContact {
 public:
  /// gap: of the undeformed surfaces in each cell [m], from planes of one's choice; modulus: E* of the bodies
  /// [Pa]. Throws InputError where the sizes do not fit or a gap is not finite.
  NormalContact(const Grid& grid, Boundary boundary, double modulus, Field gap,
                std::vector<FilmOnBody> films = {});

  /// At a normal force [N]. Throws InputError for a force that is not above 0 or that the hardness cannot
  /// carry on the whole grid, WorkError where the iteration does not end.
  NormalContactSolution at_force(double force, const NormalContactOptions& options = {}) const;
  /// At an approach [m] of the planes that the gap is counted from. Throws InputError where nothing touches.
  NormalContactSolution at_approach(double approach, const NormalContactOptions& options = {}) const;

  /// Force over approach at the beginning of unloading [N/m]: that of a flat punch with the shape of the
  /// contact, which no longer changes to first order, whatever has flowed (Oliver & Pharr 1992).
  double stiffness(const NormalContactSolution& solution) const;

  const Grid& grid() const { return compliance().grid(); }
  const Compliance& compliance() const { return levels_.front().compliance; }
  /// Of the undeformed surfaces [m].
  const Field& gap() const { return levels_.front().gap; }
  /// E* of the bodies [Pa].
  double modulus() const { return modulus_; }
  const std::vector<FilmOnBody>& films() const { return films_; }

 private:
  struct Level {
    Compliance compliance;
    Field gap;
  };
  NormalContactSolution solve(const NormalLoad& load, const NormalContactOptions& options) const;

  double modulus_;
  std::vector<FilmOnBody> films_;
  std::vector<Level> levels_;  ///< the given grid first
};

}  // namespace asperity::half_space
