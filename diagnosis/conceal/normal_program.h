// Loading, holding and unloading of a concealed normal contact: what is done, and how large the effects are.
#pragma once

#include <vector>

#include "diagnosis/conceal/sphere.h"
#include "diagnosis/conceal/world.h"

namespace asperity::hidden {

struct NormalProgram {
  std::vector<double> loads;                  ///< of an elastic sphere at the end of each run's path [N]
  double off_contact = 0;                     ///< path before touch, over the largest approach [-]
  double load_time = 10, hold_time = 10;      ///< of the first run [s]
  double slower = 1;                          ///< each run takes so many times as long as the one before [-]
  int load_samples = 110, hold_samples = 40;  ///< of a ramp and of a hold
  bool unloads = true, controls_force = false;
};

/// The program that shows what a request asks for.
NormalProgram normal_program(const WorldRequest& request, Random& random);

/// Parameters, scaled so that the effect is as large as instruments show it; `nominal`: the sphere that users
/// take theirs for.
void choose_normal_parameters(World& world, const WorldRequest& request, const NormalProgram& program,
                              const Sphere& nominal, Random& random);

}  // namespace asperity::hidden
