#include "surfaces/spectrum_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "core/quantity.h"

namespace asperity {
namespace {

constexpr int fewest_rings = 16;       // to fit at all
constexpr int fewest_kept = 12;        // rings of the self-affine line with its roll-off
constexpr int fewest_falling = 4;      // of these beyond the roll-off
constexpr int coarse_candidates = 40;  // knees tried before the search is refined

struct Rings {
  std::vector<double> x, C, n;  ///< ln q, C, independent periodograms
  int size() const { return static_cast<int>(x.size()); }
};

struct Line {
  double level = 0, slope = 0, deviance = 0;
  int rings = 0;
  double misfit() const { return std::max(1.0, deviance / rings); }
  /// -2 ln of the extended quasi-likelihood
  double cost() const { return deviance / misfit() + rings * std::log(misfit()); }
};

/// Maximum-likelihood line ln M = level + slope max(x - knee, 0) through the rings [first, last).
Line fit_line(const Rings& rings, int first, int last, double knee) {
  double S0 = 0, S1 = 0, S2 = 0, y0 = 0, y1 = 0;
  for (int i = first; i < last; ++i) {
    const double n = rings.n[i], u = std::max(rings.x[i] - knee, 0.0), y = std::log(rings.C[i]);
    S0 += n, S1 += n * u, S2 += n * u * u, y0 += n * y, y1 += n * u * y;
  }
  const double determinant = S0 * S2 - S1 * S1;
  const bool sloped = determinant > 1e-12 * S0 * S2;
  Line line;
  const auto step = [&](double r0,
                        double r1) {  // solves the Fisher matrix, which is the same in each iteration
    const double d_slope = sloped ? (S0 * r1 - S1 * r0) / determinant : 0.0;
    line.slope += d_slope;
    const double d_level = (r0 - S1 * d_slope) / S0;
    line.level += d_level;
    return std::abs(d_level) + std::abs(d_slope);
  };
  step(y0, y1);  // least squares in ln C to begin with
  constexpr int most_iterations = 60;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    double r0 = 0, r1 = 0;
    for (int i = first; i < last; ++i) {
      const double u = std::max(rings.x[i] - knee, 0.0);
      const double excess =
          std::min(rings.C[i] * std::exp(-line.level - line.slope * u) - 1, 3.0);  // bounded step
      r0 += rings.n[i] * excess, r1 += rings.n[i] * excess * u;
    }
    if (step(r0, r1) < 1e-7) break;
  }
  for (int i = first; i < last; ++i) {
    const double log_M = line.level + line.slope * std::max(rings.x[i] - knee, 0.0);
    const double ratio = std::exp(std::log(rings.C[i]) - log_M);
    line.deviance += 2 * rings.n[i] * (ratio - 1 - std::log(ratio));
  }
  line.rings = last - first;
  return line;
}

/// The roll-off at x = knee; the rings from `end` on do not belong to the self-affine line.
struct Candidate {
  double knee = 0;
  int end = 0;
  bool rolloff = false;
  Line line;
  double cost = std::numeric_limits<double>::infinity();
};

double cost_beyond(const Rings& rings, int end) {
  constexpr int widest_edge = 3;                // rings that a window smears a sharp cut-off over
  const double price = std::log(rings.size());  // of one free parameter (Schwarz)
  double least = (rings.size() - end) * (1 + price);
  for (int edge = 0; edge <= widest_edge && rings.size() - end - edge >= fewest_kept; ++edge) {
    const Line line = fit_line(rings, end + edge, rings.size(), rings.x[end + edge]);
    least = std::min(least, edge * (1 + price) + line.cost() + 3 * price);
  }
  return least;
}

Candidate evaluate(const Rings& rings, double knee, int end, bool rolloff, double beyond) {
  Candidate candidate{knee, end, rolloff, fit_line(rings, 0, end, knee), 0};
  candidate.cost = candidate.line.cost() + (rolloff ? std::log(rings.size()) : 0.0) + beyond;
  return candidate;
}

/// Best knee for a given end, by a search that narrows around the best of the knees tried; no knee if none
/// pays.
Candidate best_knee(const Rings& rings, int end) {
  const double beyond = cost_beyond(rings, end);
  Candidate best = evaluate(rings, rings.x.front(), end, false, beyond);
  const double lowest = rings.x[2], highest = rings.x[end - fewest_falling];
  double lower = lowest, upper = highest;
  for (int refinement = 0; refinement < 4; ++refinement) {
    const int steps = refinement == 0 ? coarse_candidates : 8;
    const double width = (upper - lower) / steps;
    for (int i = 0; i <= steps; ++i) {
      const Candidate candidate = evaluate(rings, lower + i * width, end, true, beyond);
      if (candidate.cost < best.cost) best = candidate;
    }
    if (!best.rolloff) break;
    lower = std::max(lowest, best.knee - width);
    upper = std::min(highest, best.knee + width);
  }
  return best;
}

Candidate best_candidate(const Rings& rings) {
  Candidate best;
  int lower = fewest_kept, upper = rings.size();
  for (int stride = std::max(1, (upper - lower) / coarse_candidates);; stride = std::max(1, stride / 4)) {
    for (int end = upper; end >= lower; end -= stride) {
      const Candidate candidate = best_knee(rings, end);
      if (candidate.cost < best.cost) best = candidate;
    }
    if (stride == 1) return best;
    lower = std::max(fewest_kept, best.end - stride);
    upper = std::min(rings.size(), best.end + stride);
  }
}

/// Covariance of (level, slope, knee) from the Fisher information of the self-affine rings.
Eigen::Matrix3d covariance(const Rings& rings, const Candidate& fit) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (int i = 0; i < fit.end; ++i) {
    const double u = std::max(rings.x[i] - fit.knee, 0.0);
    const Eigen::Vector3d gradient(1, u, fit.rolloff && u > 0 ? -fit.line.slope : 0.0);
    information += rings.n[i] * gradient * gradient.transpose();
  }
  if (!fit.rolloff) information(2, 2) = 1;  // no knee to be determined
  return information.inverse();
}

/// Half width in x over which moving the end of the self-affine rings costs less than one standard error.
double end_error(const Rings& rings, const Candidate& fit) {
  const auto costs = [&](int end) {
    return evaluate(rings, fit.knee, end, fit.rolloff, cost_beyond(rings, end)).cost - fit.cost;
  };
  int lower = fit.end, upper = fit.end;
  while (lower > fewest_kept && costs(lower - 1) < 1) --lower;
  while (upper < rings.size() - 1 && costs(upper + 1) < 1) ++upper;
  const double ring = rings.x[fit.end] - rings.x[fit.end - 1];
  return std::max(0.5 * (rings.x[upper] - rings.x[lower]), ring / std::sqrt(12.0));
}

/// Mean of ln C/M of the rings left out: negative where the surface lacks short waves, positive where noise
/// adds some.
double mean_departure(const Rings& rings, const Candidate& fit) {
  double sum = 0, weight = 0;
  for (int i = fit.end; i < rings.size(); ++i) {
    sum += rings.n[i] * (std::log(rings.C[i]) - fit.line.level - fit.line.slope * (rings.x[i] - fit.knee));
    weight += rings.n[i];
  }
  return sum / weight;
}

Rings usable_rings(const RadialSpectrum& spectrum) {
  Rings rings;
  const double largest = spectrum.C.empty() ? 0 : *std::max_element(spectrum.C.begin(), spectrum.C.end());
  constexpr double rounding =
      1e-24;  // of the largest C: a generated map holds nothing but rounding beyond its cut-off
  for (std::size_t i = 1; i < spectrum.q.size(); ++i) {
    rings.x.push_back(std::log(spectrum.q[i]));
    rings.C.push_back(std::max(spectrum.C[i], rounding * largest));
    rings.n.push_back(spectrum.modes[i]);
  }
  if (rings.size() < fewest_rings || !(largest > 0))
    throw InputError("the map is too small or too flat for a fit of its spectrum; it needs at least " +
                     std::to_string(2 * (fewest_rings + 1)) + " x " + std::to_string(2 * (fewest_rings + 1)) +
                     " pixels");
  return rings;
}

}  // namespace

SpectrumFit fit_spectrum(const RadialSpectrum& spectrum) {
  const Rings rings = usable_rings(spectrum);
  SpectrumFit fit;
  const Candidate best = best_candidate(rings);
  fit.misfit = best.line.misfit();
  const Eigen::Matrix3d scatter = fit.misfit * covariance(rings, best);
  fit.hurst = {-best.line.slope / 2 - 1, std::sqrt(scatter(1, 1)) / 2};
  if (best.rolloff) {
    const double wavelength = 2 * M_PI / std::exp(best.knee);
    fit.has_rolloff = true;
    fit.rolloff = {wavelength, wavelength * std::sqrt(scatter(2, 2))};
  }
  if (best.end < rings.size()) {
    const double wavelength = 2 * M_PI / std::exp(0.5 * (rings.x[best.end - 1] + rings.x[best.end]));
    const bool lacking = mean_departure(rings, best) < 0;
    (lacking ? fit.has_cutoff : fit.has_noise) = true;
    (lacking ? fit.cutoff : fit.noise) = {wavelength, wavelength * end_error(rings, best)};
  }
  fit.rms = spectrum.rms;
  fit.longest = 2 * M_PI / std::exp(rings.x.front());
  fit.shortest = 2 * M_PI / std::exp(rings.x.back());
  return fit;
}

std::string SpectrumFit::sentence() const {
  const auto length = [](double value) { return format_quantity(value, Dimension::length); };
  const auto with_error = [&](const Number& number) {
    return length(number.value) + " ± " + length(number.error);
  };
  std::string text = "Hurst exponent " + format_quantity(hurst.value, Dimension::none) + " ± " +
                     format_quantity(hurst.error, Dimension::none, 1);
  if (hurst.value > 1) text += " (above 1: smoother than any self-affine surface)";
  if (hurst.value < 0) text += " (below 0: no self-affine surface)";
  text += has_rolloff ? ", roll-off at " + with_error(rolloff) : ", no roll-off up to " + length(longest);
  if (has_cutoff)
    text += ", cut-off at " + with_error(cutoff);
  else if (has_noise)
    text += ", noise below " + with_error(noise);
  else
    text += ", no cut-off down to " + length(shortest);
  return text + "; misfit " + format_quantity(misfit, Dimension::none, 2) +
         " (1: an isotropic self-affine surface)";
}

}  // namespace asperity
