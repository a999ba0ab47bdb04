// The reduced laws with the numbers of parameters.json, so that an engine that was given the same file and
// this program's own law can be set side by side. What the file means by its length scales and stiffnesses:
// contact_parameters.h.
#pragma once

#include <vector>

#include "dem_compare/laws/law_text.h"
#include "dem_compare/motion/contact_model.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

/// Which laws the numbers are put into.
struct ReducedLawOptions {
  bool partial_slip = false;  ///< Mindlin and Deresiewicz instead of Mindlin
  bool normal_adhesion =
      false;  ///< the pull-off force as a constant attraction; without it the load alone presses
  LeverArm lever = LeverArm::particle_radius;  ///< as the file's lambda = r and most engines' walls
  std::vector<WrittenLaw> laws{};              ///< each in place of that of its mode
};

/// Hertz, or the linear law where no reduced modulus is known. A mode without a friction coefficient does not
/// resist; one without stiffness of rolling or torsion gets the paper's, 8 G* a lambda r. A law that is
/// written takes from the record, by their names, the parameters that it is not given. Throws InputError
/// where the record lacks what a law needs, and for laws of steady slip, which lead no contact.
ContactModel contact_model(const ContactParameters& parameters, const ReducedLawOptions& options = {});

/// Any law that is written, with the record's numbers where it is not given its own. Throws InputError as
/// above.
ReducedLaw law_of_contact(const WrittenLaw& law, const ContactParameters& parameters,
                          const ReducedLawOptions& options = {});

}  // namespace asperity
