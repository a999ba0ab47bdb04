// Means whose uncertainty comes from how stretches of a way, or realisations of a surface, differ.
#pragma once

#include <vector>

#include "dem_compare/numbers/uncertain.h"

namespace asperity {

/// A standard error from few values is itself uncertain: factor that makes twice the error hold 95.4 % of
/// cases (Student 1908), as two standard deviations of a normal distribution do.
double student_factor(double degrees_of_freedom);

/// Mean over stretches of equal length in their order, which may be correlated (correlated_mean); the sd is
/// that of the mean, widened by Student's factor. Unknown for fewer than two.
Uncertain mean_of_stretches(const std::vector<double>& values);

/// Mean over realisations; the sd is that of the mean, from what each leaves open or from their scatter,
/// whichever is larger. Those that are not numbers are left out.
Uncertain mean_of_realisations(const std::vector<Uncertain>& values);

/// Boundaries of `count` stretches of equal length between two rows of a monotonic way, and how much a
/// quantity that is summed up along the way grows over each, per length.
std::vector<double> rates_of_stretches(const std::vector<double>& position, const std::vector<double>& sum,
                                       std::size_t first, std::size_t last, std::size_t count);

/// In quadrature; an unknown sd stays unknown.
Uncertain operator+(const Uncertain& a, const Uncertain& b);
Uncertain operator-(const Uncertain& a, const Uncertain& b);
Uncertain operator*(const Uncertain& a, double factor);
Uncertain ratio(const Uncertain& a, const Uncertain& b);

}  // namespace asperity
