#include "fem/case/derived_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/attraction_zone.h"
#include "core/error.h"
#include "core/quantity.h"
#include "fem/case/contact_path.h"
#include "fem/case/solve_cost.h"

namespace asperity::fem {
namespace {

constexpr double cells_per_radius = 12, cells_per_wave = 4, cells_per_film = 4;

std::string length_text(double value, int digits = 3) {
  return format_quantity(value, Dimension::length, digits);
}
std::string number_text(double value, int digits = 2) {
  return format_quantity(value, Dimension::none, digits);
}

double shortest_wave(const CaseSetup& setup) {
  return std::min(setup.roughness[0].scales.shortest_wave, setup.roughness[1].scales.shortest_wave);
}

/// Thickness [m]; infinite: there is none.
double thinnest_film(const CaseSetup& setup) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const Film& film : setup.system.films)
    if (film.thickness > 0) thinnest = std::min(thinnest, film.thickness);
  return thinnest;
}

/// Which waves of a rough body.
std::string roughness_text(const MeshedRoughness& roughness, const std::string& body) {
  constexpr double little = 0.01;
  std::string text = body + ": " + number_text(roughness.cells_per_wave()) +
                     " cells over its shortest wave of " + length_text(roughness.scales.shortest_wave);
  if (roughness.scales.unresolved > little)
    text += "; still shorter waves hold " + number_text(100 * roughness.scales.unresolved) +
            " % of the scan's slope variance: they are not resolved";
  if (roughness.scales.period < roughness.region)
    text += "; the surface repeats every " + length_text(roughness.scales.period) + " within the region of " +
            length_text(roughness.region) +
            " (a larger size= in Topography makes another surface that does not)";
  return text;
}

/// Empty where it is resolved.
std::string film_text(const CaseSetup& setup) {
  const double spacing = setup.system.mesh.sizes.spacing_particle, thickness = thinnest_film(setup);
  constexpr double rounding = 1.01;
  if (spacing * cells_per_film <= rounding * thickness) return "";
  return "film: " + number_text(thickness / spacing) + " cells over the thickness of " +
         length_text(thickness) +
         ": cells that lie in it with a part of their depth are taken as laminates of film and body; " +
         "Mesh/Interface spacing = " + at_most(thickness / cells_per_film) + " resolves it";
}

/// Empty where it is resolved, or nothing attracts.
std::string attraction_text(const CaseSetup& setup) {
  const double spacing = setup.system.mesh.sizes.spacing_particle;
  const double enough = setup.attraction.zone / cells_over_attraction_zone;
  constexpr double rounding = 1.01;
  if (!setup.attraction.acts() || spacing <= rounding * enough) return "";
  return "attraction: " + number_text(setup.attraction.zone / spacing) + " cells over the zone of " +
         length_text(setup.attraction.zone) +
         " at the edge of a contact in which it acts: the pull-off force will be too large; Mesh/Interface "
         "spacing = " +
         at_most(enough) + " resolves it";
}

}  // namespace

double derived_spacing(const CaseSetup& setup) {
  const double radius = setup.least_radius;
  // A thinner film is resolved as a laminate: what one of half a cell adds is 1.4 % off.
  constexpr double cells_for_film = 24;
  const double for_film = std::max(thinnest_film(setup) / cells_per_film, radius / cells_for_film);
  return std::min({radius / cells_per_radius, shortest_wave(setup) / cells_per_wave, for_film,
                   setup.attraction.zone / cells_over_attraction_zone});
}

void require_affordable(const CaseInput& input, const CaseSetup& setup) {
  constexpr double most_unknowns = 4e6;
  const double unknowns = estimated_unknowns(setup.system.mesh.sizes, input.mesh.layers);
  const double spacing = setup.system.mesh.sizes.spacing_particle, wave = shortest_wave(setup);
  const bool by_waves = std::isfinite(wave) && spacing >= wave / cells_per_wave;
  const bool by_zone = !by_waves && spacing >= setup.attraction.zone / cells_over_attraction_zone;
  if (unknowns <= most_unknowns) return;
  // Fine cells may travel with a contact on a long way.
  if (!by_waves && !by_zone && estimated_cost(input, setup, true).unknowns <= most_unknowns) return;
  const double affordable = spacing * std::sqrt(unknowns / most_unknowns);
  const std::string cells = ", which take cells of " + length_text(spacing) + " and some " +
                            number_text(unknowns / 1e6) + " million unknowns; ";
  if (by_waves)
    throw InputError(
        input.file + ": the slopes of the roughness lie in waves down to " + length_text(wave) + cells +
        "leave out the shorter waves with cutoff=" + length_text(cells_per_wave * affordable, 2) +
        " in Topography, lower the load, or accept what a mesh of your own "
        "Mesh/Interface spacing leaves out");
  const auto& sizes = setup.system.mesh.sizes;
  const std::string path =
      sizes.reach_particle > 0 || sizes.reach_substrate > 0 ? "shorten the path of the contact, " : "";
  if (!by_zone)
    throw InputError(input.file + ": under this load smooth bodies touch over a radius of " +
                     length_text(setup.least_radius) + ", and these may touch anywhere within ±" +
                     length_text(setup.system.mesh.sizes.region_particle) + cells + "raise the load, " +
                     path +
                     "set a smaller Mesh/Contact region, or accept what a mesh of your own "
                     "Mesh/Interface spacing (" +
                     length_text(affordable, 2) + ") leaves out");
  // The zone goes with the square of the length over which attraction falls.
  const double longer = std::sqrt(affordable / spacing);
  throw InputError(input.file + ": the attraction acts in a zone of " + length_text(setup.attraction.zone) +
                   " at the edges of contacts" + cells + "let it fall over " + number_text(longer) +
                   " times the length with the same work of adhesion, lower the load, or accept the "
                   "pull-off force of a mesh of your own Mesh/Interface spacing, which is too large");
}

std::vector<std::string> resolution_texts(const CaseSetup& setup) {
  std::vector<std::string> texts;
  for (int body = 0; body < 2; ++body)
    if (setup.roughness[body].rough())
      texts.push_back(roughness_text(setup.roughness[body], body == 0 ? "particle" : "substrate"));
  for (const std::string& text : {film_text(setup), attraction_text(setup)})
    if (!text.empty()) texts.push_back(text);
  return texts;
}

}  // namespace asperity::fem
