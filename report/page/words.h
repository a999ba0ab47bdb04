// What a case asked for, in sentences.
#pragma once

#include <string>

#include "dem_compare/compare/comparison.h"
#include "results/solved_case.h"

namespace asperity::report {

/// "A sphere of radius 8.5 um (E = 71 GPa, ...) was pressed on a plane ... to 1 mN and released." (HTML-safe)
std::string what_was_asked(const SolvedCase& solved);
/// "smooth", "generated roughness, RMS 1.5 nm", "measured: scan.gsf"
std::string topography_in_words(const TopographySpec& spec);
/// "1.5 nm" with the micro sign; "–" if it is not known.
/// value in SI.
std::string in_units(double value, Dimension dimension, int digits = 3);
/// "24.3 ± 0.5 kN/m" of a scatter, in `unit` (SI) with its name.
std::string in_units(const Scatter& scatter, double unit, const std::string& name, int digits = 3);
/// "0.93" or "0.93 ± 0.02": a ratio.
std::string ratio_text(const Scatter& scatter);
/// "0.85 nm", to a hundredth of a nanometre: less is not known of an imprint.
/// In [m].
std::string imprint_text(double imprint);
/// "-7 %", or "4.6 times" from twice on
/// A ratio, and a share of 1.
std::string departure_text(double ratio);
std::string percent_text(double share, int digits = 2);
/// "0.42 %" for "within ..." and "at most ...": what is smaller counts as 0.001 %.
/// A share of 1.
std::string percent_bound(double share);
/// Escaped for HTML, with the micro sign in place of the u of "uN" and "um".
std::string readable(const std::string& text);
/// "0.484 µm²"
/// In [m^2].
std::string area_text(double area);
/// "23 min 4 s"
/// In [s].
std::string duration_text(double seconds);

}  // namespace asperity::report
