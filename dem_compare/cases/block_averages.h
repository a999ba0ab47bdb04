// Block averages along a path: means whose uncertainty comes from how blocks, or realisations of a surface,
// differ.
#pragma once

#include <vector>

#include "dem_compare/numbers/uncertain.h"

namespace asperity {

/// A standard error from few values is itself uncertain: factor that makes twice the error hold 95.4 % of
/// cases (Student 1908), as two standard deviations of a normal distribution do.
double student_factor(double degrees_of_freedom);

/// Mean over blocks of equal length in their order, which may be correlated (correlated_mean); the sd is
/// that of the mean, widened by Student's factor. Unknown for fewer than two.
Uncertain mean_of_blocks(const std::vector<double>& values);

/// Mean over realisations; the sd is that of the mean, from what each leaves open or from their scatter,
/// whichever is larger. Those that are not numbers are left out.
Uncertain mean_of_realisations(const std::vector<Uncertain>& values);

/// Divides a monotonic path between two rows into `count` blocks of equal length: how much a
/// quantity that is summed up along the path grows over each, per length.
std::vector<double> block_rates(const std::vector<double>& position, const std::vector<double>& sum,
                                std::size_t first, std::size_t last, std::size_t count);

/// In quadrature; an unknown sd stays unknown.
Uncertain operator+(const Uncertain& a, const Uncertain& b);
Uncertain operator-(const Uncertain& a, const Uncertain& b);
Uncertain operator*(const Uncertain& a, double factor);
Uncertain ratio(const Uncertain& a, const Uncertain& b);

}  // namespace asperity
