// Equations that laws and effects state in plain text, for a page that typesets them.
#pragma once

#include <string>

namespace asperity {

/// In TeX, without dollars: "f = 4/3 E* R^(1/2) d^(3/2)" becomes "f = 4/3\, E^{*}\, R^{1/2}\, d^{3/2}". Greek
/// letters, functions, subscripts, exponents and signs are known; what else has two letters or more is prose.
std::string typeset(const std::string& equation);

/// How a manual page writes equations: as they are, for a terminal, or in TeX.
enum class Equations { plain, typeset };
/// On lines of its own, without the last line's end.
std::string displayed(const std::string& equation, Equations how);

}  // namespace asperity
