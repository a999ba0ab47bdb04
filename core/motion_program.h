// Programs that combine motions, as people write them:
//   "slide 200 nm and spin 20 mrad; press 50 uN; roll 30 mrad in 12 steps; slide -100 nm and slide across 100
//   nm"
//
// Parts follow each other, separated by ';'. The motions of a part, joined by 'and', happen together and in
// proportion. Words:
//   press Q         to the normal load, or approach, Q
//   slide L         by a length along x; across: along y
//   roll A          about its own y axis, which spins with it, by an angle, or by the length of the arc;
//   without sliding in the
//                   same part free of lateral force along its path
//   spin A          about the normal by an angle
//   indenter L      rolls freely between the substrate and a plane on top, an indenter, that moves by L: an
//                   arc of half of L
//   hold T          for a time, which the part's other motions take as well
//   at V            at the end of a part, before its steps: the speed of its longest motion
//   in N steps      equal ones, at the end of a part; else fine where slip begins, then
//                   those of a single motion. At rest each lasts twice as long as the one before
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/case.h"

namespace asperity {

/// Motions that happen together, in SI units, relative to where the part begins.
struct ProgramPart {
  std::optional<double> load;          ///< normal force [N] at the end
  std::optional<double> approach;      ///< approach [m] at the end
  double slide = 0, slide_across = 0;  ///< along x and y [m]
  double roll = 0;                     ///< about y [rad]
  double rolled_arc = 0;               ///< the same as a length along the particle's surface [m]
  double spin = 0;                     ///< about the normal [rad]
  double duration = 0;                 ///< [s]; 0: follows from the speed
  double speed = 0;                    ///< of its longest motion [m/s]; 0: that of the experiment
  int steps = 0;                       ///< 0: derived

  bool rolls() const { return roll != 0 || rolled_arc != 0; }
  /// Rolling whose shift follows so that no lateral force builds up.
  bool rolls_freely() const { return rolls() && slide == 0 && slide_across == 0; }
};

/// Throws InputError naming the part and what fits.
std::vector<ProgramPart> parse_motion_program(const std::string& text);

/// Why an experiment's program cannot be moved through, as a sentence; empty if it can, or if there is none.
std::string objection_to_program(const ExperimentInput& experiment);

}  // namespace asperity
