// Plain numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace asperity {

/// Refuses what is no number, or not in bounds, in one sentence; CLI11's own names the largest double.
inline CLI::Validator number_check(const std::string& name, bool zero_too) {
  return CLI::Validator(
      [zero_too](std::string& text) -> std::string {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && (value > 0 || (zero_too && value == 0))) return "";
        return "'" + text + "' is no number " + (zero_too ? "of 0 or more" : "above 0") +
               "; give one without a unit, in that which --help names";
      },
      name);
}
inline CLI::Validator positive_number() { return number_check("POSITIVE", false); }
inline CLI::Validator number_not_below_zero() { return number_check("NONNEGATIVE", true); }

}  // namespace asperity
