// The case that a user would write for a recording's bodies.
#pragma once

#include <string>

#include "diagnosis/recording/recording.h"

namespace asperity {

/// Text of a case file: smooth and elastic bodies as the recording names them, under a load of 100 uN, with
/// the friction that its simulation takes (none under normal load); of torsion as a local coefficient.
std::string nominal_case(const Recording& recording);

}  // namespace asperity
