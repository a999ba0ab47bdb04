#include "app/case_film.h"

#include <algorithm>
#include <cmath>

#include "app/case_entry_kinds.h"
#include "core/written_apart.h"

namespace asperity {

void add_film(std::vector<CaseEntry>& entries, const std::string& section, BodyInput CaseInput::*body) {
  const auto at = [body](double FilmInput::*member) {
    return [=](CaseInput& input) -> double& { return (input.*body).film.*member; };
  };
  CaseEntry thickness =
      quantity(section, "Film thickness", at(&FilmInput::thickness), Dimension::length, not_negative, "0 m",
               "", "Of a film that is bonded to the body, as an oxide or a coating; 0: there is none.");
  CaseEntry modulus =
      quantity(section, "Film Young modulus", at(&FilmInput::youngs_modulus), Dimension::pressure,
               not_negative, "0 Pa", "", "Of the film; a film needs it.");
  CaseEntry ratio = quantity(section, "Film Poisson ratio", at(&FilmInput::poisson_ratio), Dimension::none,
                             {0, 0.5, false, true}, "0", "", "Of the film; a film needs it.");
  CaseEntry yield =
      quantity(section, "Film yield stress", at(&FilmInput::yield_stress), Dimension::pressure,
               positive_or_infinite, "inf", "", "Of the film, perfectly plastic; inf: it stays elastic.");
  for (CaseEntry* entry : {&thickness, &modulus, &ratio, &yield}) {
    entry->counts_if_given = true;
    entries.push_back(*entry);
  }
}

FilmObjection objection_to_film(const std::string& section, const FilmInput& film, double radius,
                                const Settings& settings) {
  const auto is_given = [&](const std::string& entry) {
    return std::any_of(settings.begin(), settings.end(),
                       [&](const Setting& setting) { return setting.path() == section + "/" + entry; });
  };
  const std::string thickness = "Film thickness", modulus = "Film Young modulus",
                    ratio = "Film Poisson ratio", yield = "Film yield stress";
  if (film.is_there()) {
    for (const std::string& entry : {modulus, ratio})
      if (!is_given(entry))
        return {thickness, section + "/" + thickness + " is given and " + entry + " is not; give it"};
    if (film.thickness > radius / 2) {
      const auto [found, allowed] = quantities_apart(film.thickness, radius / 2, Dimension::length);
      return {thickness, section + "/" + thickness + " of " + found + " is more than half the Radius, " +
                             allowed + "; give the body the film's material instead"};
    }
    if (!(film.youngs_modulus > 0)) return {modulus, section + "/" + modulus + " must be above 0"};
    return {};
  }
  const std::string entry = film.youngs_modulus > 0            ? modulus
                            : film.poisson_ratio > 0           ? ratio
                            : std::isfinite(film.yield_stress) ? yield
                                                               : "";
  if (entry.empty()) return {};
  return {entry, section + "/" + entry + " is given and " + thickness + " is not; give it, or leave " +
                     entry + " out"};
}

}  // namespace asperity
