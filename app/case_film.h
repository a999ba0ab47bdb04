// Entries of a case for the film on a body, and what cannot be meant by them.
#pragma once

#include <string>
#include <vector>

#include "app/case_declaration.h"
#include "core/case.h"
#include "core/parameter_file.h"

namespace asperity {

/// Appends them for a body's section.
void add_film(std::vector<CaseEntry>& entries, const std::string& section, BodyInput CaseInput::*body);

/// What is wrong with a film, and the entry that says it; empty: nothing.
struct FilmObjection {
  std::string entry, sentence;
};
/// radius: of the particle [m].
FilmObjection objection_to_film(const std::string& section, const FilmInput& film, double radius,
                                const Settings& settings);

}  // namespace asperity
