// Units of length as instruments spell them: "~m" and Latin-1 for micrometres, "Angstrom", "nanometer".
#pragma once

#include <optional>
#include <string>

namespace asperity {

/// Factor from `unit` to metres; empty if it is no unit of length.
std::optional<double> length_unit_factor(const std::string& unit);

/// The unit spelt in plain ASCII ("um" for any micrometre), unchanged if it is unknown.
std::string plain_unit(const std::string& unit);

}  // namespace asperity
