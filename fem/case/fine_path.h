// Which part of the path is finely meshed while the contact is where it is: the mesh travels with it.
//
// The whole path of a rolling or sliding contact is many times as many cells as the contact itself needs.
// Lattice and map of both bodies are those of the whole path all the time; of its fine cells those are there
// that the contact needs from where it is up to some way ahead, and those that have yielded.
#pragma once

#include <array>
#include <vector>

#include "fem/case/case_setup.h"
#include "fem/programs/program.h"

namespace asperity::fem {

/// Places that the contact's middle takes on fine cells, of particle and substrate, along x in each body's
/// own frame.
using FineParts = std::array<meshing::FinePart, 2>;

class FinePath {
 public:
  FinePath(const CaseInput& input, const CaseSetup& setup, const std::vector<Station>& program);

  /// Whether the mesh travels: where the case lets it, and where that saves enough.
  bool travels() const { return stride_ > 0; }
  /// For the start of the program.
  FineParts first() const;
  /// For going on from a motion to the next one, and some way further.
  FineParts onwards(const RigidMotion& from, const RigidMotion& to) const;
  /// Whether the contact is on fine cells at a motion.
  bool holds(const FineParts& parts, const RigidMotion& motion) const;
  /// What has to be finely meshed for them, cells beside the contact included.
  FineParts with_margin(FineParts parts) const;
  /// Unknowns of the fine mesh that is there at a time over those of the whole path [-].
  double share_at_a_time() const;

 private:
  /// Middle of the contact along x, from the middle of each body's lattice [m].
  std::array<double, 2> place(const RigidMotion& motion) const;

  meshing::BodySizes sizes_;
  double layers_;
  std::vector<RigidMotion> motions_;  ///< of the program
  double stride_ = 0;                 ///< how far ahead it is fine [m]; 0: all the way
  double margin_ = 0;                 ///< by which fine cells reach beyond the contact region [m]
};

}  // namespace asperity::fem
