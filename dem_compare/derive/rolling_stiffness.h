// Stiffness with which a contact that has rolled resists rolling back, before it rolls that way: k_ro of
// spring models of rolling (Luding 2008, Granular Matter 10, 235: a spring that holds until its moment is
// that of friction). SI units.
#pragma once

#include <vector>

#include "dem_compare/cases/steady_motion.h"

namespace asperity {

/// What the mesh leaves in doubt of it, relative, per spacing over the radius of the contact. An estimate
/// from one measurement: it changed by 38 % from 40 to 20 nm, where the error of the line was 11 to 15 %; at
/// a radius of 0.3 um this makes 20 % of spacings of 20 nm.
constexpr double rolling_stiffness_mesh_error = 3.0;

/// From a return path as a second pass. Hills give the same moment on both paths: what the moment lacks on
/// the return path is D = k delta at first, delta the angle since the turn, and twice the resistance once the
/// contact rolls back. The slope is that of the least squares line through the turn over the rows up to where
/// D has reached the resistance, half its width: a secant, for bonds let go one after the other. Between rows
/// of the path out the moment is interpolated (Akima's modified splines). The error is the line's. NaN
/// without a turn or with fewer than three rows after it.
ReversalStiffness rolling_stiffness(const std::vector<double>& angle, const std::vector<double>& moment,
                                    double resistance);

}  // namespace asperity
