// How far a recording of normal contact moves while there is a force.
#pragma once

#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// Which way the force acts.
enum class Pressed { alone, or_pulled };

/// Between the least and the largest displacement at which the contact is pressed, or also pulled, by more
/// than 2 % of the largest force [m]; 0 where it is at none.
double recorded_in_contact(const FitProblem& problem, Pressed pressed);

/// Half as far again as the contact was pressed, by the recording or, where that is more, by Hertz' law [m].
double far_beyond_recorded(const FitProblem& problem);

}  // namespace asperity
