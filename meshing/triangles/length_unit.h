// The unit of coordinates in files for other programs, which take plain numbers and lose digits with metres
// of 1e-6.
#pragma once

namespace asperity::meshing {

enum class LengthUnit { micrometre, nanometre, metre };

/// "um", "nm" or "m".
inline const char* symbol(LengthUnit unit) {
  return unit == LengthUnit::micrometre ? "um" : unit == LengthUnit::nanometre ? "nm" : "m";
}
/// Units per metre.
inline double per_metre(LengthUnit unit) {
  return unit == LengthUnit::micrometre ? 1e6 : unit == LengthUnit::nanometre ? 1e9 : 1;
}

}  // namespace asperity::meshing
