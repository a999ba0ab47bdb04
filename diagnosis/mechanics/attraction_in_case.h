// Attraction of a recording as Dugdale's in a case of finite elements: which range a mesh can resolve, and
// the mesh that resolves it. SI units.
#pragma once

#include <memory>
#include <vector>

#include "core/attraction_zone.h"
#include "dem_compare/laws/maugis_branch.h"
#include "diagnosis/forward/forward_model.h"
#include "diagnosis/recording/experiment.h"

namespace asperity {

/// Maugis' lambda of a transition alpha [-] from DMT (0) to JKR (1, which lambda = 10 is):
/// lambda = -0.924 ln(1 - alpha) (after Carpick, Ogletree & Salmeron 1999, eq. (9), who have 1.02 alpha),
/// alpha scaled so that 1 is 10 and every alpha has its own lambda.
double lambda_of_transition(double alpha);

/// Its inverse, no more than 1.
double transition_of_lambda(double lambda);

/// Maugis' solution of that lambda [-]; the last few asked for in this thread are kept, for a fit changes it
/// seldom, and to see what a small change makes.
std::shared_ptr<const MaugisBranch> maugis_branch(double lambda);

/// Range h0 of a work of adhesion w [J/m^2] with Maugis' lambda [-] (Maugis 1992): sigma0 = w/h0,
/// lambda = 2 sigma0 (R/(pi w K^2))^(1/3) [m].
double range_of_attraction(const Experiment& experiment, double work, double lambda);

/// Its inverse [-].
double lambda_of_range(const Experiment& experiment, double work, double range);

/// Largest lambda up to `lambda` whose zone takes no more than thirty cells over the radius of the pressed
/// contact: from there to the limit of Johnson, Kendall & Roberts the pull-off force changes by a twelfth,
/// and a recording says little of the range. pull_off: [N].
double resolvable_lambda(const Experiment& experiment, double pull_off, double lambda);

/// Entry of the case's mesh where attraction asks for one.
constexpr const char* spacing_entry = "Mesh/Interface spacing";

/// Dugdale's work [J/m^2] and range [m] as entries, and a finer mesh where the case's own does not resolve
/// the zone with so many cells.
std::vector<CaseChange> dugdale_in_case(const Experiment& experiment, double work, double range,
                                        double cells = cells_over_attraction_zone);

}  // namespace asperity
