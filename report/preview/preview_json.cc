#include <cmath>
#include <nlohmann/json.hpp>

#include "report/preview/preview_report.h"

namespace asperity::report {
namespace {

using half_space::CaseContact;
using half_space::CasePreview;
using nlohmann::json;

json with_sd(double value, const char* unit, double sd) {
  return {{"value", value}, {"unit", unit}, {"sd", std::isfinite(sd) ? json(sd) : json(nullptr)}};
}

json numbers_of(const CaseContact& contact, const CasePreview& preview) {
  const auto& shape = contact.shape;
  const double area = preview.error_of_area() * shape.area;
  json numbers = {
      {"contact_area", with_sd(shape.area, "m^2", area)},
      {"mean_pressure",
       with_sd(contact.mean_pressure(), "Pa", preview.error_of_area() * contact.mean_pressure())},
      {"max_pressure", with_sd(contact.largest_pressure(), "Pa",
                               preview.error_of_largest_pressure() * contact.largest_pressure())},
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
      {"normal_force", with_sd(contact.force(), "N", 0)}};
  if (contact.lateral_stiffness > 0) {
    const auto off = [&](double CaseContact::*number) {
      return std::abs(preview.fine.*number / (preview.coarse.*number) - 1) * contact.*number;
    };
    numbers["lateral_stiffness"] =
        with_sd(contact.lateral_stiffness, "N/m", off(&CaseContact::lateral_stiffness));
    numbers["torsion_stiffness"] =
        with_sd(contact.torsion_stiffness, "N m/rad", off(&CaseContact::torsion_stiffness));
  }
  if (contact.pull_off) {
    numbers["attraction"] =
        with_sd(contact.attracting, "N", std::abs(preview.fine.attracting - preview.coarse.attracting));
    numbers["pull_off_force"] =
        with_sd(contact.pull_off->force, "N", preview.error_of_pull_off() * contact.pull_off->force);
  }
  return numbers;
}

}  // namespace

std::string preview_json(const CaseInput& input, const PreviewedCase& preview) {
  const CaseContact& fine = preview.contact.fine;
  const Hertz hertz = hertz_of(input);
  json result{{"format", "asperity-preview/1"},
              {"title", input.title},
              {"inputs", {{"case", input.file}, {"entries", input.physical_entries}}},
              {"hertz",
               {{"contact_radius", hertz.contact_radius(fine.force())},
                {"approach", hertz.approach(fine.force())},
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
              {"left_out", left_out_sentences(preview.left_out)}};
  if (preview.slip) {
    const FullSlip &slip = *preview.slip, &coarse = *preview.coarse_slip;
    result["elastic"]["slipping_force"] =
        with_sd(slip.lateral_force, "N", std::abs(slip.lateral_force - coarse.lateral_force));
    result["elastic"]["slipping_moment"] =
        with_sd(slip.torsion_moment, "N m", std::abs(slip.torsion_moment - coarse.torsion_moment));
  }
  for (const SlipPoint& point : preview.partial_slip)
    result["partial_slip"].push_back(
        {{"shift", point.shift}, {"lateral_force", point.force}, {"slipping", point.slipping}});
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

}  // namespace asperity::report
