#include "fem/output/progress_line.h"

#include "core/printed.h"
#include "core/quantity.h"

namespace asperity::fem {
namespace {

std::string moment(double value) { return printed("%.4g N m", value); }

/// Tangential motions and forces.
std::string motion_of(const HistoryRow& r) {
  std::string text;
  if (r.shift != 0)
    text += "  shift " + format_quantity(r.lateral_displacement, Dimension::length) + "  lateral force " +
            format_quantity(r.lateral_force, Dimension::force);
  if (r.rolling_angle != 0)
    text += "  rolled " + format_quantity(r.rolling_angle, Dimension::angle) + "  moment " +
            moment(r.rolling_moment);
  if (r.torsion_angle != 0)
    text += "  spin " + format_quantity(r.torsion_angle, Dimension::angle) + "  moment " +
            moment(r.torsion_moment);
  return text;
}

}  // namespace

std::string progress_of(const HistoryRow& r) {
  return "  load " + format_quantity(r.normal_force, Dimension::force) + motion_of(r) + "  approach " +
         format_quantity(r.normal_displacement, Dimension::length) + "  area " +
         std::to_string(r.contact_area * 1e12).substr(0, 7) + " um^2  p_max " +
         format_quantity(r.max_pressure, Dimension::pressure) + "  newton " +
         std::to_string(static_cast<int>(r.newton_iterations)) + "  cg " +
         std::to_string(static_cast<int>(r.linear_iterations));
}

}  // namespace asperity::fem
