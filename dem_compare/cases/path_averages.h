// Averages along a path and over realisations, with an uncertainty from how the values differ. SI units.
// Neighbouring places of a path feel the same asperities: N values count as N_eff = N/(1 + 2 sum (1 - k/N)
// rho_k) independent ones, rho_k the autocorrelation summed until it first vanishes (Bartlett 1946; Geyer
// 1992), and the mean is known to s/(N_eff - 1)^(1/2). Holds for a path of many correlation lengths. What is
// steady, and what resists, core/steady_motion.h defines.
#pragma once

#include <cstddef>
#include <vector>

#include "dem_compare/numbers/uncertain.h"

namespace asperity {

/// Mean of a correlated series, and what is known about it.
struct CorrelatedMean {
  double mean = 0, sd = 0;    ///< sd of the values
  double standard_error = 0;  ///< of the mean
  double independent = 0;     ///< N_eff
};
/// Of values at equal distances; needs two or more.
CorrelatedMean correlated_mean(const std::vector<double>& values);

/// Values between two rows of a monotonic path, at equal distances of a median step. Rows may rest.
std::vector<double> resampled_along(const std::vector<double>& position, const std::vector<double>& values,
                                    std::size_t first, std::size_t last);

/// A standard error from few values is itself uncertain: factor that makes twice the error hold 95.4 % of
/// cases (Student 1908), as two standard deviations of a normal distribution do.
double student_factor(double degrees_of_freedom);

/// Mean over blocks of equal length in their order, which may be correlated (correlated_mean); the sd is
/// that of the mean, widened by Student's factor. Unknown for fewer than two.
Uncertain mean_of_blocks(const std::vector<double>& values);

/// The mean with an error beside its scatter, a standard deviation in its unit that is stated and not
/// estimated: added in quadrature, and no widening of its own (Satterthwaite 1946).
Uncertain with_stated_error(const Uncertain& mean, double error);

/// The same means, each widened by the factor of the degrees of freedom that they have together (Welch 1947;
/// Satterthwaite 1946) and no longer by its own: three paths of four blocks tell their common mean by nine
/// and not by three. For what is made of all of them.
std::vector<Uncertain> with_shared_degrees_of_freedom(std::vector<Uncertain> means);

/// Mean over realisations; the sd is that of the mean, from what each leaves open (with the degrees of
/// freedom that they share) or from their scatter, whichever is larger. Those that are not numbers are left
/// out.
Uncertain mean_of_realisations(const std::vector<Uncertain>& values);

/// Divides a monotonic path between two rows into `count` blocks of equal length: how much a
/// quantity that is summed up along the path grows over each, per length.
std::vector<double> block_rates(const std::vector<double>& position, const std::vector<double>& sum,
                                std::size_t first, std::size_t last, std::size_t count);

}  // namespace asperity
