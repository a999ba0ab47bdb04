// What `asperity preview` tells of a case: its normal contact by half-spaces, and the mesh that it needs. SI
// units.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/motion.h"
#include "half_space/case_contact.h"

namespace asperity {

/// The mesh that a solve would make.
struct MeshPreview {
  double spacing = 0, region = 0;   ///< of the interface's nodes; half width of the fine region [m]
  double unknowns = 0, memory = 0;  ///< [-], [byte], roughly (fem/case/solve_cost.h)
  double seconds = 0;               ///< on two cores, to a factor of two [s]
  double seconds_on_one_core = 0;   ///< likewise: of cases that are solved side by side [s]
  int steps = 0;
};

/// A body that yields.
struct YieldingBody {
  const char* name;
  double first_yield = 0;  ///< largest pressure of a smooth contact at which it begins to [Pa]
};

/// What the contact holds by friction where all of it slips, that has not slipped before.
struct FullSlip {
  double lateral_force = 0;   ///< [N]
  double torsion_moment = 0;  ///< about the axis of the sphere [N m]
};

/// What it holds when it is shifted from rest, as far as this.
struct SlipPoint {
  double shift = 0, force = 0;  ///< [m], [N]
  double slipping = 0;          ///< share of the touching cells [-]
};

/// What the case has and half-spaces pressed together have not.
struct LeftOutOfPreview {
  std::optional<Motion> motion;
  bool adhesion = false;        ///< acts in a zone too small for half-spaces in cells
  bool shear_of_films = false;  ///< half-spaces with films are solved under normal load alone
  bool relaxation = false;      ///< bodies relax with time, and this is right after loading
  bool yielding_films = false;  ///< a film is harder than its own yield stress says on a body that is not
  bool finite_bodies = false;   ///< the case is led by its approach, of which their compliance is a part
};

/// The contact by half-spaces, and that mesh.
struct PreviewedCase {
  half_space::CasePreview contact;
  double hardness = std::numeric_limits<double>::infinity();  ///< of `contact.capped` [Pa]; infinite: none
  std::optional<FullSlip> slip, coarse_slip;  ///< of contact.fine and .coarse; none: no friction
  std::vector<SlipPoint> partial_slip;        ///< of contact.coarse, in a case that slides
  double work_of_separation = 0;              ///< of surfaces that adhere [J/m^2]
  std::optional<MeshPreview> mesh;            ///< none: refused
  std::string refusal;                        ///< what `asperity solve` would say
  std::vector<YieldingBody> yielding;
  LeftOutOfPreview left_out;
};

}  // namespace asperity
