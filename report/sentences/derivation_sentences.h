// What `asperity derive` found, in sentences: for people and for parameters.json.
#pragma once

#include <string>

#include "dem_compare/derive/derivation.h"

namespace asperity::report {

inline constexpr char hertz_fit[] = "Hertz fit of the first loading",
                      hertz_with_offset[] = "Hertz fit of the first loading with an offset of the approach";

/// A kind of number, a source, a fact, an open question in words.
std::string words_of(Derived what);
std::string words_of(StiffnessSource source);
std::string words_of(const Fact& fact);
std::string words_of(const OpenQuestion& question);

/// Title, provenance of each quantity, findings and open questions of each law, into the record.
void write_words(Derivation& derivation);

/// For people: bodies and cases, then each law with its numbers and what could not be told.
std::string derivation_text(const Derivation& derivation);
std::string law_text(const LawFindings& findings);

/// "4 cases, load 100 uN to 3 mN, 2 realisations, spacing 22 nm".
std::string extent_words(const std::vector<CaseNumber>& numbers);
/// Extent of those that count, and the mesh's error, which no standard deviation of the laws holds.
std::string source_words(const std::vector<CaseNumber>& all);

}  // namespace asperity::report
