#include "fem/preview_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/quantity.h"
#include "core/wait_text.h"
#include "fem/case/case_setup.h"
#include "fem/case/solve_cost.h"
#include "fem/interface/friction_law.h"
#include "fem/materials/hardening.h"
#include "fem/solve_case.h"

namespace asperity {
namespace {

using half_space::CaseContact;
using half_space::CasePreview;
using nlohmann::json;

struct Yielding {
  const char* name;
  double yield_stress, factor;  ///< Y [Pa], largest pressure over Y at first yield
};

/// Of the bodies that yield.
std::vector<Yielding> yielding_bodies(const CaseInput& input) {
  std::vector<Yielding> bodies;
  const auto add = [&](const char* name, const BodyInput& body) {
    const double stress = fem::make_plasticity(body).yield_stress;
    if (std::isfinite(stress)) bodies.push_back({name, stress, hertz_yield_factor(body.poisson_ratio)});
  };
  add("particle", input.particle);
  add("substrate", input.substrate);
  return bodies;
}

/// Three times the lower yield stress (Tabor 1951); infinite where nothing yields.
double tabor_hardness(const CaseInput& input) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& body : yielding_bodies(input)) lowest = std::min(lowest, body.yield_stress);
  return 3 * lowest;
}

std::vector<std::string> what_is_left_out(const CaseInput& input, bool rubs) {
  std::vector<std::string> sentences;
  const auto& experiment = input.experiment;
  if (experiment.type != Motion::normal)
    sentences.push_back("of " + name_of(experiment.type) +
                        " the pressing down is previewed, on the axes of both meshes; the motion is not");
  if (input.interface.work_of_adhesion > 0)
    sentences.push_back("adhesion is left out: it presses as more load does");
  if (rubs) sentences.push_back("friction is left out");
  if (experiment.control == ExperimentInput::Control::displacement)
    sentences.push_back(
        "the approach is that of half-spaces from first touch: what the finite bodies give way in the case "
        "is left out");
  return sentences;
}

std::string quantity(double value, Dimension dimension, int digits = 3) {
  return format_quantity(value, dimension, digits);
}
std::string percent(double share) { return quantity(100 * share, Dimension::none, 2) + " %"; }
std::string area_text(double area) { return quantity(area * 1e12, Dimension::none) + " um^2"; }
std::string stiffness_text(double stiffness) { return quantity(stiffness, Dimension::stiffness, 4); }

std::string grid_text(const CaseInput& input, const CaseContact& contact) {
  const auto& grid = contact.grid;
  std::string text = "half-spaces: a square of " + quantity(grid.nx * grid.dx, Dimension::length) + " in " +
                     std::to_string(grid.nx) + " x " + std::to_string(grid.ny) + " cells of " +
                     quantity(grid.dx, Dimension::length);
  const double wave = half_space::shortest_wave(input);
  if (std::isfinite(wave))
    text += ", " + quantity(wave / grid.dx, Dimension::none, 2) + " over the shortest wave of " +
            quantity(wave, Dimension::length);
  if (contact.enlarged > 0)
    text += ", enlarged " + std::to_string(contact.enlarged) + " times until it held the contact";
  return text;
}

void say_yielding(const CaseInput& input, const PreviewedCase& preview,
                  const std::function<void(const std::string&)>& say) {
  const double largest = preview.contact.fine.shape.largest_pressure;
  bool yields = false;
  for (const auto& body : yielding_bodies(input)) {
    const double first = body.factor * body.yield_stress;
    yields = yields || largest > first;
    say(std::string(body.name) + ": a smooth one yields from " +
        quantity(hertz_of(input).force_at_peak_pressure(first), Dimension::force) +
        " on (Hertz); asperities do from about " + quantity(first, Dimension::pressure) + " on, and " +
        (largest > first ? "will here" : "will not here"));
  }
  if (yields) say("the numbers above are those of elastic bodies; where they yield the area is larger");
  if (!preview.contact.capped) {
    if (yields && std::isfinite(preview.hardness))
      say("no pressure reaches the hardness of " + quantity(preview.hardness, Dimension::pressure));
    else if (yields)
      say("a contact of three times the yield stress would go beyond half the Radius, which half-spaces do "
          "not tell");
    return;
  }
  const auto& capped = *preview.contact.capped;
  say("with pressures up to a hardness of " + quantity(preview.hardness, Dimension::pressure) + ": area " +
      area_text(capped.shape.area) + ", of which " +
      percent(capped.shape.area_at_bound / capped.shape.area_of_cells) + " carries the hardness, approach " +
      quantity(capped.approach(), Dimension::length) + ", stiffness of unloading " +
      stiffness_text(capped.stiffness) + " (on one grid, so without an error)");
}

void say_mesh(const PreviewedCase& preview, const std::function<void(const std::string&)>& say) {
  if (!preview.mesh) return say("asperity solve would refuse it: " + preview.refusal);
  const MeshPreview& mesh = *preview.mesh;
  say("to solve it by finite elements: nodes every " + quantity(mesh.spacing, Dimension::length) +
      " within ±" + quantity(mesh.region, Dimension::length) + ", some " +
      quantity(mesh.unknowns / 1e6, Dimension::none, 2) + " million unknowns, " +
      quantity(mesh.memory / (1 << 30), Dimension::none, 2) + " GiB, " + std::to_string(mesh.steps) +
      " steps in about " + wait_text(mesh.seconds) + " on two cores");
  const double reach = preview.contact.fine.shape.reach;
  if (reach > mesh.region)
    say("the contact reaches to " + quantity(reach, Dimension::length) +
        " from the axis, beyond that region; set Mesh/Contact region");
}

json with_sd(double value, const char* unit, double sd) {
  return {{"value", value}, {"unit", unit}, {"sd", std::isfinite(sd) ? json(sd) : json(nullptr)}};
}

json numbers_of(const CaseContact& contact, const CasePreview& preview) {
  const auto& shape = contact.shape;
  const double area = preview.error_of_area() * shape.area;
  return {
      {"contact_area", with_sd(shape.area, "m^2", area)},
      {"mean_pressure", with_sd(shape.mean_pressure, "Pa", preview.error_of_area() * shape.mean_pressure)},
      {"max_pressure",
       with_sd(shape.largest_pressure, "Pa", preview.error_of_largest_pressure() * shape.largest_pressure)},
      {"normal_stiffness",
       with_sd(contact.stiffness, "N/m", preview.error_of_stiffness() * contact.stiffness)},
      {"approach", with_sd(contact.approach(), "m", preview.error_of_approach())},
      {"first_touch",
       with_sd(contact.first_touch, "m", std::abs(preview.fine.first_touch - preview.coarse.first_touch))},
      {"spots", with_sd(shape.spots, "", std::abs(preview.fine.shape.spots - preview.coarse.shape.spots))},
      {"load_centre_x",
       with_sd(shape.centre_x, "m", std::abs(preview.fine.shape.centre_x - preview.coarse.shape.centre_x))},
      {"load_centre_y",
       with_sd(shape.centre_y, "m", std::abs(preview.fine.shape.centre_y - preview.coarse.shape.centre_y))},
      {"normal_force", with_sd(shape.force, "N", 0)}};
}

}  // namespace

PreviewedCase preview_case(const CaseInput& input, double hardness) {
  PreviewedCase preview;
  preview.hardness = hardness > 0 ? hardness : tabor_hardness(input);
  try {
    preview.contact = half_space::preview_of_case(input, preview.hardness);
  } catch (const InputError&) {  // a contact of that hardness may be no half-space's where the elastic one is
    if (hardness > 0 || std::isinf(preview.hardness)) throw;
    preview.hardness = std::numeric_limits<double>::infinity();
    preview.contact = half_space::preview_of_case(input, preview.hardness);
  }
  bool rubs = false;
  try {
    check_case(input);
    rubs = fem::make_friction_law(input.interface) != nullptr;
    const CaseInput derived = fem::with_derived_path_length(input);
    const fem::CaseSetup setup = fem::set_up_sizes(derived);
    const fem::SolveCost cost = fem::estimated_cost(derived, setup);
    preview.mesh = MeshPreview{setup.system.mesh.sizes.spacing_particle,
                               setup.system.mesh.sizes.region_particle,
                               cost.unknowns,
                               cost.memory,
                               cost.seconds,
                               cost.steps};
  } catch (const InputError& error) {
    preview.refusal = error.what();
  }
  preview.left_out = what_is_left_out(input, rubs);
  return preview;
}

void say_preview(const CaseInput& input, const PreviewedCase& preview,
                 const std::function<void(const std::string&)>& say) {
  const CasePreview& contact = preview.contact;
  const auto& shape = contact.fine.shape;
  const Hertz hertz = hertz_of(input);
  const double force = shape.force;
  for (const auto& sentence : preview.left_out) say(sentence);
  say(grid_text(input, contact.fine));
  say("normal force " + quantity(force, Dimension::force) +
      "; beside each number, how far half as many cells along a side are off, and Hertz' of smooth bodies");
  say("stiffness " + stiffness_text(contact.fine.stiffness) + " (" + percent(contact.error_of_stiffness()) +
      "; " + stiffness_text(hertz.normal_stiffness(force)) + ")");
  say("approach of the mean surfaces " + quantity(contact.fine.approach(), Dimension::length) + " (" +
      quantity(contact.error_of_approach(), Dimension::length, 2) + "; " +
      quantity(hertz.approach(force), Dimension::length) + "), from first touch " +
      quantity(contact.fine.approach() - contact.fine.first_touch, Dimension::length));
  say("real contact area " + area_text(shape.area) + " (" + percent(contact.error_of_area()) + "; " +
      area_text(hertz.contact_area(force)) + ") in " + std::to_string(shape.spots) + " spots");
  say("mean pressure " + quantity(shape.mean_pressure, Dimension::pressure) + ", largest " +
      quantity(shape.largest_pressure, Dimension::pressure) + " (" +
      percent(contact.error_of_largest_pressure()) + "; " +
      quantity(hertz.peak_pressure(force), Dimension::pressure) + ")");
  say_yielding(input, preview, say);
  say_mesh(preview, say);
}

std::string preview_json(const CaseInput& input, const PreviewedCase& preview) {
  const CaseContact& fine = preview.contact.fine;
  const Hertz hertz = hertz_of(input);
  json result{{"format", "asperity-preview/1"},
              {"title", input.title},
              {"inputs", {{"case", input.file}, {"entries", input.physical_entries}}},
              {"hertz",
               {{"contact_radius", hertz.contact_radius(fine.shape.force)},
                {"approach", hertz.approach(fine.shape.force)},
                {"reduced_modulus", hertz.reduced_modulus}}},
              {"grid",
               {{"cells", fine.grid.nx},
                {"spacing", fine.grid.dx},
                {"half_width", 0.5 * fine.grid.nx * fine.grid.dx},
                {"enlarged", fine.enlarged},
                {"reach", fine.shape.reach},
                {"iterations", fine.solution.iterations},
                {"error", fine.solution.error}}},
              {"elastic", numbers_of(fine, preview.contact)},
              {"left_out", preview.left_out}};
  if (preview.contact.capped) {
    const auto& capped = *preview.contact.capped;
    result["capped"] = numbers_of(capped, preview.contact);
    for (auto& number : result["capped"]) number["sd"] = nullptr;  // solved on one grid
    result["capped"]["hardness"] = with_sd(preview.hardness, "Pa", 0);
    result["capped"]["area_at_hardness"] = with_sd(capped.shape.area_at_bound, "m^2", NAN);
  }
  if (preview.mesh)
    result["mesh"] = {{"interface_spacing", preview.mesh->spacing},
                      {"contact_region", preview.mesh->region},
                      {"dofs", preview.mesh->unknowns},
                      {"peak_memory", preview.mesh->memory},
                      {"wall_time", preview.mesh->seconds},
                      {"steps", preview.mesh->steps}};
  else
    result["refusal"] = preview.refusal;
  return result.dump(1) + "\n";
}

}  // namespace asperity
