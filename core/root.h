// Root of a function between two places where it has different signs (Alefeld, Potra & Shi 1995, algorithm
// 748, as Boost has it).
// Pure numbers: in the unit of what is passed.
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <limits>

namespace asperity {

/// To `digits` binary digits. Throws Boost's evaluation_error where the signs are alike.
template <class Function>
double root_between(const Function& f, double low, double high,
                    int digits = std::numeric_limits<double>::digits) {
  std::uintmax_t iterations = 300;
  const auto bracket = boost::math::tools::toms748_solve(
      f, low, high, boost::math::tools::eps_tolerance<double>(digits), iterations);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace asperity
