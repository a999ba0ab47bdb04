// Work of the driven plane along a path of few recorded steps.
#pragma once

#include <vector>

namespace asperity::fem {

/// Integral of F d(delta) from first touch (0, 0) up to each state [J]. delta [m], F [N], one value per
/// state.
///
/// Between two states F = c (delta - delta0)^m, which is Hertz' law for m = 3/2 and what few asperities (m >
/// 3/2) or a plastic imprint (delta0 > 0) make of it. m is such that the neighbouring states on the same
/// branch (loading or unloading) lie on the curve, the mean of the two where there is one on either side, 3/2
/// where there is none.
std::vector<double> external_work(const std::vector<double>& delta, const std::vector<double>& force);

}  // namespace asperity::fem
