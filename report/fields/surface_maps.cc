#include "report/fields/surface_maps.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "report/fields/case_fields.h"
#include "report/page/axis.h"
#include "report/page/chart.h"
#include "report/page/display_units.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "surfaces/statistics.h"
#include "surfaces/surface_of_entry.h"

namespace asperity::report {
namespace {

namespace fs = std::filesystem;
constexpr int map_pixels = 360;

Map scaled(Map map, double unit) {
  for (double& value : map.values) value /= unit;
  return map;
}

MapFigure map_figure_of(const Map& map) {
  return figure_in_nm(map.x_low, map.x_high, map.y_low, map.y_high, "y");
}

/// Half width of the square that maps of the contact show [m].
double map_half_width(const SolvedCase& solved, const fs::path& file) {
  constexpr double room = 1.35;
  const InterfaceExtent extent = interface_extent(file);
  return std::min(extent.surface, room * std::max(extent.contact, hertz_radius(solved)));
}

struct Roughness {
  Map heights;  ///< [m]
  bool as_meshed = false;
};

/// As the solver saw it if it wrote that, else what the case file asks for.
Roughness roughness_of(const SolvedCase& solved, const std::string& section) {
  const auto files = files_at_largest_load(solved, "interface.pvd");
  if (!files.empty())
    return {interface_map(files[0], section == "Particle" ? "height_particle" : "height_substrate",
                          map_half_width(solved, files[0]), map_pixels),
            true};
  constexpr double contacts_across = 4;
  const double size = contacts_across * hertz_radius(solved), pixel = size / map_pixels;
  const HeightSampler sampler = heights_over(solved.entries.topography(section), size);
  Map map{map_pixels, map_pixels, -size / 2, size / 2, -size / 2, size / 2, {}};
  for (int iy = 0; iy < map_pixels; ++iy)
    for (int ix = 0; ix < map_pixels; ++ix)
      map.values.push_back(sampler.height((ix + 0.5) * pixel - size / 2, (iy + 0.5) * pixel - size / 2));
  return {map, false};
}

std::string roughness_statistics(const Map& heights) {
  Topography map;
  map.nx = heights.nx;
  map.ny = heights.ny;
  map.lx = heights.x_high - heights.x_low;
  map.ly = heights.y_high - heights.y_low;
  map.heights = heights.values;
  for (const double height : heights.values) map.missing.push_back(std::isnan(height));
  if (map.missing_count() == 0) map.missing.clear();
  const HeightMoments moments = height_moments(map);
  return "In this window: RMS height " + in_units(moments.Sq, Dimension::length) + ", peak to valley " +
         in_units(moments.Sz, Dimension::length) + ".";
}

std::string roughness_figure(const SolvedCase& solved, const std::string& section) {
  const std::string name = section == "Particle" ? "Sphere" : "Plane";
  const TopographySpec spec = solved.entries.topography(section);
  if (spec.is_smooth()) return note(name + ": smooth, so there is no map to show.");
  try {
    const Roughness roughness = roughness_of(solved, section);
    const Map map = scaled(roughness.heights, nm);
    MapFigure figure = map_figure_of(roughness.heights);
    figure.colour_label = "height [nm]";
    figure.range = colour_range(map, outliers);
    std::string where = "Around the contact, as the case file asks for it. ";
    if (roughness.as_meshed) {
      figure.circles = {hertz_radius(solved) / nm};
      figure.circle_label = "contact of smooth bodies at the largest load";
      where =
          "As the solver meshed it, seen along the axis of contact; the dashed circle is the contact that "
          "smooth bodies "
          "would have at the largest load. ";
    }
    return figure_html(name + ": " + (spec.generator() ? "generated roughness" : "measured roughness"),
                       to_svg(figure, paint(map, *figure.scale, figure.range)),
                       where + "Yellow stands out of the material, blue is lower. " +
                           roughness_statistics(roughness.heights));
  } catch (const InputError& error) {
    return note(name + ": the surface cannot be shown: " + escaped(error.what()) + ".");
  }
}

/// Means over rings around the axis.
struct Rings {
  std::vector<double> radius, mean;
};

Rings ring_means(const Map& map, int count) {
  std::vector<double> sum(count), points(count);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix) {
      const double x = map.x_low + (ix + 0.5) * (map.x_high - map.x_low) / map.nx;
      const double y = map.y_low + (iy + 0.5) * (map.y_high - map.y_low) / map.ny;
      const int ring = static_cast<int>(std::hypot(x, y) / map.x_high * count);
      const double value = map.values[static_cast<std::size_t>(iy) * map.nx + ix];
      if (ring >= count || !std::isfinite(value)) continue;
      sum[ring] += value;
      ++points[ring];
    }
  Rings rings;
  for (int i = 0; i < count; ++i) {
    rings.radius.push_back((i + 0.5) / count * map.x_high);
    rings.mean.push_back(sum[i] / points[i]);
  }
  return rings;
}

/// `pressure` in GPa; highest: what the darkest colour stands for, likewise.
std::string pressure_picture(const SolvedCase& solved, const Map& pressure, double highest) {
  MapFigure figure = map_figure_of(pressure);
  figure.colour_label = "contact pressure [GPa]";
  figure.scale = &ColourScale::white_to_red();
  figure.range = {0, std::max(highest, 1e-12)};
  figure.circles = {hertz_radius(solved) / nm};
  figure.circle_label = "contact of smooth bodies";
  return to_svg(figure, paint(pressure, *figure.scale, figure.range));
}

/// The same contact by half-spaces, where the solver has had them check it; in the colours of `pressure`.
std::vector<std::string> half_space_figure(const SolvedCase& solved, const Map& pressure, double half_width) {
  const fs::path file = solved.folder / half_space_map;
  if (!solved.finished() || !solved.result->document.contains("half_space") || !fs::exists(file)) return {};
  Map other = scaled(interface_map(file, "pressure", half_width, map_pixels), GPa);
  for (double& value : other.values)
    if (std::isnan(value)) value = 0;  // beyond the part that was written nothing presses
  return {
      figure_html("The same by half-spaces", pressure_picture(solved, other, pressure.largest()),
                  "The same surfaces and load, solved by boundary elements that know nothing of the mesh, "
                  "in the colours of the picture before. Their numbers stand in result.json beside those "
                  "of finite elements.")};
}

/// `pressure` in GPa.
std::string pressure_map_figure(const SolvedCase& solved, const Map& pressure) {
  return figure_html("Contact pressure", pressure_picture(solved, pressure, pressure.largest()),
                     "Where the bodies touch and how hard they press, seen from above at the largest load: "
                     "white is open, red presses. "
                     "Between smooth elastic bodies the pressure would fill the dashed circle, with " +
                         in_units(solved.hertz().peak_pressure(largest_force(solved)), Dimension::pressure) +
                         " in its middle.");
}

/// `gap` in nm; `status` is 1 where the surfaces touch.
std::string gap_map_figure(const SolvedCase& solved, const Map& gap, const Map& status) {
  // Gaps grow with the square of the distance outside of the contact: the upper tenth would take most of the
  // colours.
  constexpr double far_share = 0.1;
  const Colour closed{200, 30, 40};
  MapFigure figure = map_figure_of(gap);
  figure.colour_label = "gap [nm]";
  figure.range = {0, std::max(colour_range(gap, far_share).high, 1e-3)};
  figure.circles = {hertz_radius(solved) / nm};
  figure.circle_label = "contact of smooth bodies";
  Image image = paint(gap, *figure.scale, figure.range);
  constexpr double touching = 0.5;
  paint_over(image, status, touching, closed);
  return figure_html(
      "Gap, and what is closed", to_svg(figure, image),
      "The distance that is left between the surfaces at the largest load. <b style='color:" + hex(closed) +
          "'>Red</b> places touch; dark blue ones nearly do; yellow ones are as far apart as the bar's end, "
          "or farther.");
}

/// `pressure` in GPa.
std::string pressure_profile_figure(const SolvedCase& solved, const Map& pressure) {
  constexpr int rings = 40;
  const Rings means = ring_means(pressure, rings);
  const double a = hertz_radius(solved), p0 = solved.hertz().peak_pressure(largest_force(solved));
  Series computed{"mean over rings", "#0072b2", Series::Style::line_with_points, {}, {}, {}};
  Series hertz{"Hertz: smooth, elastic", "#555555", Series::Style::dashed, {}, {}, {}};
  for (int i = 0; i < rings; ++i) {
    computed.x.push_back(means.radius[i] / nm);
    computed.y.push_back(means.mean[i]);
  }
  constexpr int points = 100;
  for (int i = 0; i <= points; ++i) {
    const double share = static_cast<double>(i) / points;
    hertz.x.push_back(share * a / nm);
    hertz.y.push_back(p0 * std::sqrt(1 - share * share) / GPa);
  }
  Chart chart{"distance from the axis [nm]", "contact pressure [GPa]"};
  chart.series = {computed, hertz};
  chart.width = 520;
  return figure_html("Pressure against distance from the axis", to_svg(chart),
                     "The map averaged over rings (open places count as zero). Roughness spreads the load "
                     "over a wider circle "
                     "and lowers the mean in the middle; yielding flattens the top.");
}

}  // namespace

std::string roughness_figures(const SolvedCase& solved) {
  const std::string sphere = roughness_figure(solved, "Particle"),
                    plane = roughness_figure(solved, "Substrate");
  const bool both = sphere.rfind("<figure", 0) == 0 && plane.rfind("<figure", 0) == 0;
  return both ? side_by_side({sphere, plane}) : sphere + plane;
}

std::string contact_figures(const SolvedCase& solved) {
  const auto files = files_at_largest_load(solved, "interface.pvd");
  if (files.empty()) return no_fields(solved);
  const double half_width = map_half_width(solved, files[0]);
  const auto map = [&](const char* array) { return interface_map(files[0], array, half_width, map_pixels); };
  const Map pressure = scaled(map("pressure"), GPa);
  std::vector<std::string> figures{pressure_map_figure(solved, pressure)};
  for (const std::string& figure : half_space_figure(solved, pressure, half_width)) figures.push_back(figure);
  figures.push_back(gap_map_figure(solved, scaled(map("gap"), nm), map("status")));
  figures.push_back(pressure_profile_figure(solved, pressure));
  return side_by_side(figures);
}

std::string added_contact_figures(const SolvedCase& solved) {
  const auto files = files_at_largest_load(solved, "interface.pvd");
  if (files.empty()) return "";
  std::vector<std::string> figures;
  for (const auto& field : added_scalars(solved, "contact")) {
    const Map map = interface_map(files[0], field.name, map_half_width(solved, files[0]), map_pixels);
    MapFigure figure = map_figure_of(map);
    figure.colour_label = field.label();
    figure.range = colour_range(map, outliers);
    figures.push_back(figure_html(field.name, to_svg(figure, paint(map, *figure.scale, figure.range)),
                                  escaped(field.meaning)));
  }
  return figures.empty() ? "" : side_by_side(figures);
}

}  // namespace asperity::report
