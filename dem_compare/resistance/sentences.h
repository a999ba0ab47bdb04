// Words that the answers are made of.
#pragma once

#include <string>

#include "core/quantity.h"
#include "dem_compare/cases/motion_mode.h"
#include "dem_compare/resistance/trend.h"

namespace asperity {

/// "Sliding", "rolling"
std::string motion_name(const MotionMode& mode, bool capital = false);
/// "31.2 +- 4.1", "(3.79 +- 0.54) 10^-4": two digits of the sd; one that is not known, or zero, is left out.
std::string number_text(const Uncertain& number);
/// "+3.1 +- 0.5 %"
std::string change_percent(const Uncertain& share);
/// "0.234 +- 0.021 pN m"
std::string moment_text(const Uncertain& moment);
/// "100 uN"
std::string force_text(double force);
/// "rises by 3.1 +- 0.5 % per nm of RMS", "has no trend within 0.8 % per nm of RMS", "... cannot be told";
/// `relative` is per metre.
std::string trend_words(const Uncertain& relative);
Trend::Sign sign_of(const Uncertain& number);

}  // namespace asperity
