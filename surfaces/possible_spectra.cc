#include "surfaces/possible_spectra.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/error.h"
#include "core/quantity.h"

namespace asperity {
namespace {

constexpr double confidence = 2;  // standard deviations: 95 % of the sets of windows

RatioPoint measure_ratio(const SelfAffineSpectrum& spectrum, const AfmSettings& afm, int fewest_windows,
                         std::uint64_t seed) {
  std::vector<double> Sq, Sz, profile;
  for (; static_cast<int>(Sq.size()) < fewest_windows; ++seed)
    for (const Topography& window : all_afm_windows(afm_surface(spectrum, afm, seed), afm)) {
      const AfmMeasurement one = measure({window});
      Sq.push_back(one.Sq.mean), Sz.push_back(one.Sz.mean), profile.push_back(one.profile_Sz.mean);
    }
  const auto sum = [](const std::vector<double>& values) {
    double total = 0;
    for (const double value : values) total += value;
    return total;
  };
  RatioPoint point;
  point.rolloff = spectrum.rolloff;
  point.correlation_length = correlation_length(spectrum);
  point.ratio = sum(Sz) / sum(Sq);
  point.profile_ratio = sum(profile) / sum(Sq);
  double squares = 0;  // scatter of the ratio of means, to first order
  for (std::size_t i = 0; i < Sq.size(); ++i) squares += std::pow(Sz[i] - point.ratio * Sq[i], 2);
  const double n = static_cast<double>(Sq.size());
  point.ratio_sd = std::sqrt(squares / (n - 1) / afm.windows) / (sum(Sq) / n);
  return point;
}

using Condition = std::function<bool(const RatioPoint&)>;

/// Roll-offs and correlation lengths at which `fits` holds on any of the curves.
struct Ranges {
  LengthRange rolloff, correlation;
};
Ranges ranges_where(const std::vector<RatioCurve>& curves, const Condition& fits) {
  constexpr int steps = 400;
  Ranges ranges;
  const double infinity = std::numeric_limits<double>::infinity();
  ranges.rolloff = ranges.correlation = {infinity, 0, false, false};
  for (const RatioCurve& curve : curves) {
    const double first = curve.points.front().rolloff, last = curve.points.back().rolloff;
    for (int i = 0; i <= steps; ++i) {
      const RatioPoint point =
          curve.at(i == steps ? last : first * std::pow(last / first, i / static_cast<double>(steps)));
      if (!fits(point)) continue;
      const auto include = [&](LengthRange& range, double length) {
        range.lower = std::min(range.lower, length);
        range.upper = std::max(range.upper, length);
        if (i == 0) range.open_below = true;
        if (i == steps) range.open_above = true;
      };
      include(ranges.rolloff, point.rolloff);
      include(ranges.correlation, point.correlation_length);
    }
  }
  return ranges;
}

std::string in_words(const LengthRange& range) {
  const auto length = [](double value) {  // two digits are more than such a bound is worth
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    return format_quantity(std::round(value / unit) * unit, Dimension::length, 3);
  };
  if (range.open_below && range.open_above)
    return "anything from " + length(range.lower) + " to " + length(range.upper) + " (all that was tried)";
  if (range.open_below) return length(range.upper) + " or less";
  return range.open_above ? length(range.lower) + " or more"
                          : length(range.lower) + " to " + length(range.upper);
}

std::string describe(const PossibleSpectra& result) {
  const auto number = [](double value) { return format_quantity(value, Dimension::none, 3); };
  const auto length = [](double value) { return format_quantity(value, Dimension::length, 3); };
  std::string text = "Peak to valley " + length(result.published.peak_to_valley) + " over RMS " +
                     length(result.published.rms) + " is " + number(result.ratio) + " (" +
                     number(result.lowest_ratio) + " to " + number(result.highest_ratio) +
                     " within the uncertainties). ";
  if (!result.rolloff_of_means.empty()) {
    text += "A Gaussian surface can have both numbers if its correlation length is " +
            in_words(result.correlation_of_means) + " (roll-off " + in_words(result.rolloff_of_means) +
            "); within their uncertainties, " + in_words(result.correlation_within_errors) + ".";
    return text;
  }
  text += "The two numbers cannot both hold for a Gaussian surface: such scans give a ratio of " +
          number(result.least_possible) + " to " + number(result.most_possible) + ".";
  if (!result.rolloff_within_errors.empty())
    text += " Only at the edge of their uncertainties (" +
            std::string(result.ratio < result.least_possible ? "smaller RMS, larger peak to valley"
                                                             : "larger RMS, smaller peak to valley") +
            ") can they, with a correlation length of " + in_words(result.correlation_within_errors) +
            " (roll-off " + in_words(result.rolloff_within_errors) + ").";
  if (!result.correlation_of_profiles.empty())
    text += " If the peak to valley was read from a single profile, a correlation length of " +
            in_words(result.correlation_of_profiles) + " is possible.";
  return text;
}

}  // namespace

RatioPoint RatioCurve::at(double rolloff) const {
  if (points.size() < 2) return points.at(0);
  const auto above = std::find_if(points.begin() + 1, points.end() - 1,
                                  [&](const RatioPoint& p) { return p.rolloff >= rolloff; });
  const RatioPoint &a = *(above - 1), &b = *above;
  const double t = std::log(rolloff / a.rolloff) / std::log(b.rolloff / a.rolloff);
  const auto between = [t](double left, double right) { return left + t * (right - left); };
  return {rolloff, a.correlation_length * std::pow(b.correlation_length / a.correlation_length, t),
          between(a.ratio, b.ratio), between(a.ratio_sd, b.ratio_sd),
          between(a.profile_ratio, b.profile_ratio)};
}

std::vector<RatioCurve> ratio_curves(const AfmSettings& afm, const RatioOptions& options) {
  constexpr double cutoffs = 2.5, scans = 2;
  const double first = options.shortest_rolloff > 0 ? options.shortest_rolloff : cutoffs * options.cutoff;
  const double last = options.longest_rolloff > 0 ? options.longest_rolloff : scans * afm.size;
  if (options.points < 2 || options.windows < 2 || !(last > first))
    throw InputError(
        "the longest roll-off must exceed the shortest, and two points and two windows are the least");
  AfmSettings sharp = afm;
  sharp.tip.radius = 0;  // with a tip the ratio would depend on the amplitude
  std::vector<RatioCurve> curves;
  for (const double hurst : options.hursts) {
    RatioCurve curve{hurst, options.cutoff, {}};
    for (int i = 0; i < options.points; ++i) {
      const SelfAffineSpectrum spectrum{
          1e-9, hurst, first * std::pow(last / first, i / (options.points - 1.0)), options.cutoff};
      curve.points.push_back(measure_ratio(spectrum, sharp, options.windows, options.seed));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

PossibleSpectra possible_spectra(const PublishedRoughness& published, const AfmSettings& afm,
                                 const std::vector<RatioCurve>& curves) {
  const auto& [rms, rms_error, peak_to_valley, peak_to_valley_error] = published;
  if (!(rms > 0) || !(peak_to_valley > 0) || rms_error < 0 || peak_to_valley_error < 0 || !(rms_error < rms))
    throw InputError(
        "RMS and peak to valley must be larger than zero, and the uncertainty of the RMS smaller than it");
  if (curves.empty()) throw InputError("no Hurst exponent to look for spectra with");
  PossibleSpectra result;
  result.published = published;
  result.ratio = peak_to_valley / rms;
  result.lowest_ratio = (peak_to_valley - peak_to_valley_error) / (rms + rms_error);
  result.highest_ratio = (peak_to_valley + peak_to_valley_error) / (rms - rms_error);

  result.least_possible = std::numeric_limits<double>::infinity();
  for (const RatioCurve& curve : curves)
    for (const RatioPoint& point : curve.points) {
      result.least_possible = std::min(result.least_possible, point.ratio - confidence * point.ratio_sd);
      result.most_possible = std::max(result.most_possible, point.ratio + confidence * point.ratio_sd);
    }
  const auto fits_means = [&](const RatioPoint& point) {
    return std::abs(point.ratio - result.ratio) <= confidence * point.ratio_sd;
  };
  const auto fits_within = [&](const RatioPoint& point) {
    return point.ratio - confidence * point.ratio_sd <= result.highest_ratio &&
           point.ratio + confidence * point.ratio_sd >= result.lowest_ratio;
  };
  const Ranges means = ranges_where(curves, fits_means), within = ranges_where(curves, fits_within);
  const Ranges profiles = ranges_where(curves, [&](const RatioPoint& point) {
    return point.profile_ratio >= result.lowest_ratio && point.profile_ratio <= result.highest_ratio;
  });
  result.rolloff_of_means = means.rolloff, result.correlation_of_means = means.correlation;
  result.rolloff_within_errors = within.rolloff, result.correlation_within_errors = within.correlation;
  result.correlation_of_profiles = profiles.correlation;

  const Condition fits = means.rolloff.empty() ? Condition(fits_within) : Condition(fits_means);
  for (const RatioCurve& curve : curves) {
    const LengthRange span = ranges_where({curve}, fits).rolloff;
    if (span.empty()) continue;
    for (const double rolloff : {span.lower, std::sqrt(span.lower * span.upper), span.upper}) {
      const RatioPoint point = curve.at(rolloff);
      // the published RMS, or the nearest at which the peak to valley lies within its uncertainty
      const double smallest =
          (peak_to_valley - peak_to_valley_error) / (point.ratio + confidence * point.ratio_sd);
      const double largest =
          (peak_to_valley + peak_to_valley_error) / (point.ratio - confidence * point.ratio_sd);
      const double measured = std::min(std::max(rms, smallest), largest);
      result.examples.push_back(
          {calibrated({0, curve.hurst, rolloff, curve.cutoff}, measured, afm), measured});
    }
  }
  result.sentence = describe(result);
  return result;
}

}  // namespace asperity
