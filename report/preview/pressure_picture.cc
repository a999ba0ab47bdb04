
#include "report/fields/map_figure.h"
#include "report/preview/preview_report.h"

namespace asperity::report {

std::string pressure_picture(const half_space::CaseContact& contact) {
  constexpr double nm = 1e-9, GPa = 1e9;
  const auto& grid = contact.grid;
  Map map;
  map.nx = grid.nx, map.ny = grid.ny;
  for (const double pressure : contact.solution.pressure) map.values.push_back(pressure / GPa);
  MapFigure figure;
  figure.x_label = "x [nm]", figure.y_label = "y [nm]",
  figure.colour_label = contact.attraction_in_touch > 0 ? "pressure that bears load and attraction [GPa]"
                                                        : "contact pressure [GPa]";
  figure.x_high = 0.5 * grid.nx * grid.dx / nm, figure.x_low = -figure.x_high;
  figure.y_high = 0.5 * grid.ny * grid.dx / nm, figure.y_low = -figure.y_high;
  figure.scale = &ColourScale::white_to_red();
  figure.range = {0, contact.shape.largest_pressure / GPa};
  figure.width = 640;
  std::string svg = to_svg(figure, paint(map, *figure.scale, figure.range));
  // On its own, a drawing has no page whose styles say how it looks.
  const std::string begin = "<svg ";
  svg.replace(0, begin.size(), "<svg xmlns='http://www.w3.org/2000/svg' width='640' ");
  return svg.insert(svg.find('>') + 1,
                    "<style>.frame{fill:none;stroke:#555}text{font:12px sans-serif;fill:#222}</style>"
                    "<rect width='100%' height='100%' fill='white'/>");
}

}  // namespace asperity::report
