// Stiffness of a contact after a reversal, before it moves the other way: of sliding and torsion that without
// slip, of rolling k_ro of spring models (Luding 2008, Granular Matter 10, 235: a spring that holds until its
// moment is that of friction). SI units.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "core/motion.h"

namespace asperity {

/// Value and error bound.
struct ReversalStiffness {
  double value = std::numeric_limits<double>::quiet_NaN(), error = std::numeric_limits<double>::quiet_NaN();
};

/// Ratio of the compliance of a contact with partial slip, at a share of full slip below one, to that without
/// slip.
using PartialSlip = std::function<double(double share)>;
/// Sliding (Mindlin & Deresiewicz 1953): delta/(Q/k) = 3/(2 q) (1 - (1 - q)^(2/3)), q the share.
double sliding_partial_slip(double share);
/// Torsion (Lubkin 1951).
double torsion_partial_slip(double share);
/// Of a motion; of rolling nothing is known: 1, the secant.
PartialSlip partial_slip_of(Motion motion);

/// From the first two steps after each reversal, corrected for partial slip at half the size (Masing) and
/// extrapolated to the turning point; the error is what the extrapolation adds. NaN without a reversal after
/// full slip.
ReversalStiffness reversal_stiffness(const std::vector<double>& position,
                                     const std::vector<double>& resistance, double full_slip,
                                     const PartialSlip& partial_slip);

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
