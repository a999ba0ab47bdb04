// The text of a case file that tests change in one place.
#pragma once

#include <string>

namespace asperity::test {

/// A small case that is accepted.
inline std::string smooth_case() {
  return "subsection Particle\n"
         "  set Radius = 8.5 um\n"
         "  set Young modulus = 71 GPa   # borosilicate\n"
         "  set Poisson ratio = 0.17\n"
         "end\n"
         "subsection Substrate\n"
         "  set Young modulus = 179 GPa\n"
         "  set Poisson ratio = 0.25\n"
         "end\n"
         "subsection Experiment\n"
         "  set Normal load = 1 mN\n"
         "end\n";
}

}  // namespace asperity::test
