// The text of a case's topography, without what makes one realisation of the same surface differ from another.
#pragma once

#include <string>

namespace asperity {

/// Without the seed, blanks as single ones and each length as format_quantity() writes it: further realisations of a study are written
/// anew, "0.7 nm" as "700 pm".
std::string surface_without_seed(const std::string& text);

}  // namespace asperity
