// Pictures of a diagnosis: response and residuals, before and after.
#pragma once

#include <string>

#include "diagnosis/outcome/diagnosis.h"

namespace asperity::report {

/// A unit with a prefix that suits the largest of some SI values: "nm" and 1e-9.
struct DisplayUnit {
  std::string name;
  double factor = 1;
};
DisplayUnit display_unit(const std::string& si, double largest);
/// "normal displacement" of normal_displacement.
std::string channel_words(const std::string& channel);

/// What stands beside the simulation alone.
enum class Beside { nothing, what_was_left_out, nearest };
/// The measured response and the model's, with that beside it if there is one.
std::string response_figure(const ComparedTable& table, Beside beside);
/// Residual over noise; samples within `regions` are set off.
/// limit: ends of the axis, residual over noise [-].
std::string residual_figure(const ComparedTable& table, const std::vector<double>& simulated,
                            const std::vector<MismatchRegion>& regions, const std::string& title,
                            double limit);
/// Largest residual over noise before, for axes alike.
/// A pure number [-].
double residual_limit(const ComparedTable& table);

}  // namespace asperity::report
