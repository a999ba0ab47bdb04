// The moving cases of a study, sorted: contacts (same bodies, surfaces but for their seeds, and laws of the
// interface), and of each contact its motions and loads with the realisations of the surfaces. SI units.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/cases/compared_contact.h"
#include "dem_compare/cases/moving_case.h"
#include "dem_compare/resistance/rails.h"
#include "results/contact_key.h"

namespace asperity {

/// One contact in one motion under one load, over the realisations of its surfaces.
struct MovingState {
  const MotionMode* mode = nullptr;
  double load = 0;  ///< [N]
  double spacing =
      0;  ///< the finest that all states of the study have; if there is none, the finest of its own [m]
  std::vector<MovingCase> cases;            ///< those on that spacing that reached a steady path
  std::vector<MovingCase> on_other_meshes;  ///< they judge the mesh, and do not count as realisations
  ResistanceParts parts;                    ///< means over realisations [N] or [N m]
  Uncertain resistance;                     ///< mean; its sd holds the open balance too
  Uncertain force;                          ///< mean force or moment
  double fluctuation =
      0;  ///< of force or moment along the path, standard deviation, root mean square over realisations
  Uncertain back_over_first;  ///< resistance on the return path, a second pass, over that of the first path
  double unbalanced = 0;      ///< energy per path length that the balances leave open, largest of the cases
  double hertz_radius = 0;    ///< of the smooth elastic bodies [m]
  double contact_area = 0;    ///< real, mean [m^2]
  /// What makes a resistance of this motion dimensionless: P (sliding), P a (rolling, torsion), a of Hertz.
  double scale() const;
  /// What smooth Coulomb bodies resist with: mu P, 3 pi/16 mu P a; NaN for rolling and without Coulomb
  /// friction.
  double coulomb = 0;
};

/// One contact with its states of motion.
struct MovingContact {
  std::string label;
  ContactInputs inputs;
  ComparedContact bodies;  ///< radius, RMS of the substrate, local friction
  bool can_yield = false, relaxes = false, adheres = false;
  std::vector<MovingState> states;  ///< by motion, then load
  std::vector<RailState> rails;     ///< rolled and spun at once; by inclination, then load

  /// The state of a motion at a load [N]; null without one.
  const MovingState* find(const MotionMode& mode, double load) const;
  /// All states of a motion, by load.
  std::vector<const MovingState*> of(const MotionMode& mode) const;
};

struct MovingStudy {
  std::vector<MovingContact> contacts;
  std::vector<std::string> remarks;  ///< sentences on cases that are left out, or to be taken with care

  bool empty() const { return contacts.empty(); }
};

/// Cases that were only pressed are passed over.
MovingStudy collect_moving(const CaseCollection& collection);

/// Names of the inputs in which two contacts differ.
std::vector<std::string> differing_inputs(const MovingContact& one, const MovingContact& other);

/// Seeds that name the same realisation; a surface without a seed goes with any.
bool same_realisation(const std::string& seeds, const std::string& others);

/// Sliding, rolling and torsion.
const std::vector<const MotionMode*>& all_motions();

}  // namespace asperity
