// Units in which reports show quantities, in SI units.
#pragma once

namespace asperity::report {

inline constexpr double nm = 1e-9, um = 1e-6, um2 = 1e-12, um3 = 1e-18, mrad = 1e-3;
inline constexpr double uN = 1e-6, kN_per_m = 1e3, GPa = 1e9, pN_m = 1e-12, fJ = 1e-15;

}  // namespace asperity::report
