// The script of one experiment for LAMMPS.
#pragma once

#include <string>

#include "engines/lammps.h"

namespace asperity {

/// In the order LAMMPS wants it; writes trace.csv (trace.h).
std::string lammps_script(const EngineExperiment& experiment, const MotionPlan& plan, const Lammps& lammps);

}  // namespace asperity
