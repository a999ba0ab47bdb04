// The text of a case's topography, without what makes one realisation of the same surface differ from another.
#pragma once

#include <string>

namespace asperity {

/// Blanks as single ones and each length as format_quantity() writes it, "0.7 nm" as "700 pm".
std::string surface_in_one_writing(const std::string& text);

/// The same without the seed: further realisations of a study are written anew.
std::string surface_without_seed(const std::string& text);

}  // namespace asperity
