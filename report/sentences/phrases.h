// What sentences are made of: a number with its uncertainty, a change, a trend, whether it is significant;
// each is said here alone. Sentences are UTF-8 text that terminal, Markdown and files take as it is and a
// page escapes (readable in report/page/words.h). "±" is one standard deviation.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "core/quantity.h"
#include "dem_compare/cases/motion_mode.h"
#include "dem_compare/derive/resistance_law.h"
#include "dem_compare/numbers/statistics.h"
#include "dem_compare/resistance/moving_study.h"
#include "dem_compare/resistance/trend.h"

namespace asperity::report {

inline constexpr double per_cent = 100;

/// The template with its {} replaced by the texts, in their order.
std::string say(const std::string& pattern, std::initializer_list<std::string> texts);

/// "Sliding", "rolling"
std::string motion_name(const MotionMode& mode, bool capital = false);
/// "31.2 ± 4.1", "(3.79 ± 0.54) 10⁻⁴": two digits of the sd; one that is not known, or zero, is left out.
std::string number_text(const Uncertain& number);
/// "0.93 ± 0.02" in `digits` significant digits of the scatter's mean; "–" if it is not known.
/// unit: SI value of the unit that is written.
std::string plus_minus(const Scatter& scatter, double unit = 1, int digits = 3);

/// "+1.9 ± 0.7 %", with its standard error where that is known; "–" if the error is not known.
std::string mesh_error_text(const Estimate& estimate);
/// "1.31 to 1.34"; "1.31" where both are the same.
/// Pure numbers, in the unit that the sentence names.
std::string interval_text(double low, double high);
/// "+3.1 ± 0.5 %"
std::string change_percent(const Uncertain& share);
/// "0.234 ± 0.021 pN m"
std::string moment_text(const Uncertain& moment);
/// "100 uN"
/// In [N].
std::string force_text(double force);
/// "22 nm"
/// In [m].
std::string length_text(double length);
/// "1.2 %" of a share [-].
std::string share_text(double share);
/// "1.234 ± 0.046 mN", the sd in the unit of the value; four digits of a value whose sd is not known.
std::string quantity_text(const Uncertain& quantity, Dimension dimension);
/// The same for a unit that begins with N ("pN m"), or without prefix.
std::string quantity_text(const Uncertain& quantity, const std::string& unit);
/// "µ = 0.230 ± 0.002, h = 12.0 ± 1.0 uN"
std::string law_words(const ResistanceLaw& law, const std::string& symbol = "µ");
/// "2.3 σ"
/// A ratio to the standard deviation [-].
std::string sigma_text(double sigmas);

/// What bodies dissipate by: "yielding", "relaxation" or "yielding and relaxation"; of contacts that do
/// neither, "yielding".
std::string bodies_dissipate_by(bool yields, bool relaxes);
std::string bodies_dissipate_by(const std::vector<const MovingContact*>& contacts);
std::string bodies_dissipate_by(const MovingStudy& study);

/// Of a change per metre: over a nanometre.
Uncertain per_nanometre(const Uncertain& slope);
/// "rises with roughness", "shows no significant trend with roughness", ...
std::string with_roughness(Trend::Sign sign);
/// "rises by 3.1 ± 0.5 % per nm of RMS", "has no significant trend (0.1 ± 0.4 % per nm of RMS)", ...;
/// `relative` is per metre.
std::string trend_words(const Uncertain& relative);
/// What follows a number that should differ from zero: "", " (not significant)", " (of unknown
/// significance)".
std::string significance(const Uncertain& number);

}  // namespace asperity::report
