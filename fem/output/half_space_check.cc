#include "fem/output/half_space_check.h"

#include <algorithm>

#include "core/error.h"
#include "core/quantity.h"
#include "fem/interface/surface_attraction.h"
#include "fem/materials/material_law.h"

namespace asperity::fem {

std::optional<half_space::CaseContact> half_space_check(const CaseInput& input, const CaseSetup& setup,
                                                        const HistoryRow& peak, double tension) {
  if (input.experiment.type != Motion::normal || peak.plastic_volume > 0 || !(peak.normal_force > 0) ||
      input.interface.attraction_force > 0 || relaxes(input))
    return std::nullopt;
  CaseInput pressed = input;
  pressed.experiment.control = ExperimentInput::Control::force;
  pressed.experiment.normal_load = peak.normal_force;
  half_space::CaseContactOptions options;
  options.attraction = surface_attraction(input.interface);
  options.half_width = setup.system.mesh.sizes.region_particle;
  options.spacing = std::min(setup.system.mesh.sizes.spacing_particle / 2, setup.attraction.zone / 3);
  options.most_cells = options.attraction ? 256 : 512;  // some two hundred contacts in place of one
  const double finest = 2 * options.half_width / options.most_cells;
  if (options.attraction && finest > setup.attraction.zone / 2) return std::nullopt;
  options.with_pull_off = tension > 0;
  options.with_shear_stiffness = true;
  options.edge_is_held = true;
  try {
    return half_space::contact_of_case(pressed, options);
  } catch (const InputError&) {  // a contact that goes beyond half the radius, or the scan
    return std::nullopt;
  } catch (const WorkError&) {  // not solved: a check that fails loses no result
    return std::nullopt;
  }
}

std::string half_space_text(const half_space::CaseContact& check, const HistoryRow& peak, double stiffness,
                            double tension) {
  const auto number = [](double value) { return format_quantity(value, Dimension::none, 4); };
  const auto pair = [&](const char* what, double half_spaces, double elements, double unit,
                        const char* symbol) {
    return std::string(what) + " " + number(half_spaces / unit) + " and " + number(elements / unit) + symbol;
  };
  return "half-spaces and finite elements: " +
         pair("area", check.shape.area, peak.contact_area, 1e-12, " um^2, ") +
         pair("largest pressure", check.largest_pressure(), peak.max_pressure, 1e9, " GPa, ") +
         pair("approach", check.approach(), peak.mean_plane_approach, 1e-9, " nm, ") +
         pair("stiffness", check.stiffness, stiffness, 1e3, " kN/m") +
         (check.pull_off ? pair(", pull-off force", check.pull_off->force, tension, 1e-6, " uN") : "");
}

}  // namespace asperity::fem
