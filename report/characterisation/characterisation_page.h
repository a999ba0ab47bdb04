// The answer of `asperity characterise`: one table, what it is from, what is not known; for the terminal and
// as a page.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/characterise/characterisation.h"

namespace asperity::report {

/// What stands around the tables.
struct CharacterisationText {
  std::string title;                   ///< "borosilicate, 8.5 um, on silicon"
  double accuracy = 0.15;              ///< asked for: half a 95 % interval over the value [-]
  std::vector<std::string> sentences;  ///< on the scans and the plan
  std::vector<std::string> files;      ///< written beside the page, relative to it
};

/// One line per number: meaning, value with half of its 95 % interval, what the interval lacks.
/// accuracy: asked for [-].
std::string characterisation_text(const Characterisation& table, double accuracy);

/// Self-contained HTML.
std::string characterisation_page(const std::vector<Characterisation>& tables,
                                  const CharacterisationText& text);

}  // namespace asperity::report
