#include "report/case_fields.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "report/axis.h"
#include "report/chart.h"
#include "report/page.h"
#include "report/words.h"
#include "surfaces/statistics.h"
#include "surfaces/topography_spec.h"

namespace asperity::report {
namespace {

namespace fs = std::filesystem;
constexpr double nm = 1e-9, GPa = 1e9;
constexpr int map_pixels = 360;

double largest_force(const SolvedCase& solved) {
  const auto& force = solved.history.normal_force;
  return force.empty() ? 0 : *std::max_element(force.begin(), force.end());
}

double hertz_radius(const SolvedCase& solved) { return solved.hertz().contact_radius(largest_force(solved)); }

Map scaled(Map map, double unit) {
  for (double& value : map.values) value /= unit;
  return map;
}

MapFigure lengths_in_nm(const Map& map) {
  MapFigure figure;
  figure.x_label = "x [nm]";
  figure.y_label = "y [nm]";
  figure.x_low = map.x_low / nm;
  figure.x_high = map.x_high / nm;
  figure.y_low = map.y_low / nm;
  figure.y_high = map.y_high / nm;
  return figure;
}

/// Half width of the square that maps of the contact show [m].
double map_half_width(const SolvedCase& solved, const fs::path& file) {
  constexpr double room = 1.35;
  const InterfaceExtent extent = interface_extent(file);
  return std::min(extent.surface, room * std::max(extent.contact, hertz_radius(solved)));
}

/// Share of values beyond the ends of a colour bar, so that single points do not decide it.
constexpr double outliers = 0.002;

std::string no_fields(const SolvedCase& solved) {
  return note("There are no fields of " + escaped(solved.title()) +
              " to draw (Output/Fields is off, or the case has not come to its largest load yet).");
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
  const double size = contacts_across * hertz_radius(solved);
  const Topography topography = topography_for(solved.entries.text(section + "/Topography", "smooth"), size, size / map_pixels);
  return {{topography.nx, topography.ny, 0, topography.lx, 0, topography.ly, topography.heights}, false};
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
  const std::string spec = solved.entries.text(section + "/Topography", "smooth");
  if (spec == "smooth") return note(name + ": smooth, so there is no map to show.");
  try {
    const Roughness roughness = roughness_of(solved, section);
    const Map map = scaled(roughness.heights, nm);
    MapFigure figure = lengths_in_nm(roughness.heights);
    figure.colour_label = "height [nm]";
    figure.range = colour_range(map, outliers);
    std::string where = "The whole surface, as the case file asks for it. ";
    if (roughness.as_meshed) {
      figure.circles = {hertz_radius(solved) / nm};
      figure.circle_label = "contact of smooth bodies at the largest load";
      where = "As the solver meshed it, seen along the axis of contact; the dashed circle is the contact that smooth bodies "
              "would have at the largest load. ";
    }
    return figure_html(name + ": " + (is_generator_call(spec) ? "generated roughness" : "measured roughness"),
                       to_svg(figure, paint(map, *figure.scale, figure.range)),
                       where + "Yellow stands out of the material, blue is lower. " + roughness_statistics(roughness.heights));
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

/// Largest value of a cell array among cells whose first point lies in the window, without the uppermost outliers.
ColourRange range_in_window(vtkPolyData& section, const SectionView& view) {
  vtkDataArray* array = section.GetCellData()->GetArray(view.array.c_str());
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < section.GetNumberOfCells(); ++i) {
    const double* bounds = section.GetCell(i)->GetBounds();
    if (bounds[1] > view.x_low && bounds[0] < view.x_high && bounds[5] > view.z_low && bounds[4] < view.z_high)
      values.push_back(array->GetComponent(i, 0));
  }
  if (values.empty()) return {0, 0};
  const auto at = values.begin() + static_cast<std::ptrdiff_t>((1 - outliers) * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return {0, *at > 0 ? *at : *std::max_element(values.begin(), values.end())};
}

/// A window of the given half width and height [m] around (x, 0), its colours from zero to the largest value in it.
SectionView section_view(vtkPolyData& section, const std::string& array, const ColourScale& scale, double x,
                         double half_width, double half_height, double spacing) {
  SectionView view{array, x - half_width, x + half_width, -half_height, half_height, &scale, {}};
  view.range = range_in_window(section, view);
  // Lines of the mesh closer than this would hide what they divide.
  constexpr double fewest_pixels_per_cell = 7;
  view.edges = spacing * view.width / (2 * half_width) >= fewest_pixels_per_cell;
  return view;
}

std::string section_svg(const SectionView& view, const Image& image, const std::string& label, double unit) {
  MapFigure figure;
  figure.x_label = "x [nm]";
  figure.y_label = "z [nm]";
  figure.x_low = view.x_low / nm;
  figure.x_high = view.x_high / nm;
  figure.y_low = view.z_low / nm;
  figure.y_high = view.z_high / nm;
  figure.colour_label = label;
  figure.scale = view.scale;
  figure.range = {view.range.low / unit, view.range.high / unit};
  figure.width = 520;
  return to_svg(figure, image);
}

}  // namespace

std::vector<Image> SectionPainter::draw(vtkPolyData& section, const std::vector<SectionView>& views) {
  if (!display_) display_ = std::make_unique<VirtualDisplay>();
  if (!display_->available()) throw WorkError(display_->problem());
  return draw_sections(section, views, display_->name());
}

StepFiles files_at_largest_load(const SolvedCase& solved, const std::string& pvd) {
  const auto steps = field_files(solved.folder / pvd);
  if (steps.empty()) return {};
  const StepFiles* best = &steps.rbegin()->second;
  double best_force = -1;
  constexpr double same_load = 1 + 1e-6;  // of a hold or a second cycle: the first is shown
  const auto& history = solved.history;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto found = steps.find(static_cast<int>(std::lround(history.step[i])));
    if (found == steps.end() || history.normal_force[i] <= best_force * same_load) continue;
    best_force = history.normal_force[i];
    best = &found->second;
  }
  return *best;
}

std::string roughness_figures(const SolvedCase& solved) {
  const std::string sphere = roughness_figure(solved, "Particle"), plane = roughness_figure(solved, "Substrate");
  const bool both = sphere.rfind("<figure", 0) == 0 && plane.rfind("<figure", 0) == 0;
  return both ? side_by_side({sphere, plane}) : sphere + plane;
}

std::string pressure_map_figure(const SolvedCase& solved, const std::string& title) {
  const auto files = files_at_largest_load(solved, "interface.pvd");
  if (files.empty()) return no_fields(solved);
  const Map map = scaled(interface_map(files[0], "pressure", map_half_width(solved, files[0]), map_pixels), GPa);
  MapFigure figure = lengths_in_nm(map);
  figure.colour_label = "contact pressure [GPa]";
  figure.scale = &ColourScale::white_to_red();
  figure.range = {0, std::max(map.largest(), 1e-12)};
  figure.circles = {hertz_radius(solved) / nm};
  figure.circle_label = "contact of smooth bodies";
  return figure_html(title, to_svg(figure, paint(map, *figure.scale, figure.range)),
                     "Where the bodies touch and how hard they press, at the largest load: white is open, red presses. Between "
                     "smooth elastic bodies the pressure would fill the dashed circle, with " +
                         in_units(solved.hertz().peak_pressure(largest_force(solved)), Dimension::pressure) + " in its middle.");
}

std::string pressure_profile_figure(const SolvedCase& solved) {
  const auto files = files_at_largest_load(solved, "interface.pvd");
  if (files.empty()) return "";
  constexpr int rings = 40;
  Map map = interface_map(files[0], "pressure", map_half_width(solved, files[0]), map_pixels);
  const Rings means = ring_means(map, rings);
  const double a = hertz_radius(solved), p0 = solved.hertz().peak_pressure(largest_force(solved));
  Series computed{"mean over rings", "#0072b2", Series::Style::line_with_points, {}, {}, {}};
  Series hertz{"Hertz: smooth, elastic", "#555555", Series::Style::dashed, {}, {}, {}};
  for (int i = 0; i < rings; ++i) {
    computed.x.push_back(means.radius[i] / nm);
    computed.y.push_back(means.mean[i] / GPa);
  }
  constexpr int points = 100;
  for (int i = 0; i <= points; ++i) {
    const double share = static_cast<double>(i) / points;
    hertz.x.push_back(share * a / nm);
    hertz.y.push_back(p0 * std::sqrt(1 - share * share) / GPa);
  }
  Chart chart;
  chart.x_label = "distance from the axis [nm]";
  chart.y_label = "contact pressure [GPa]";
  chart.series = {computed, hertz};
  chart.width = 520;
  return figure_html("Pressure against distance from the axis", to_svg(chart),
                     "The map averaged over rings (open places count as zero). Roughness spreads the load over a wider circle "
                     "and lowers the mean in the middle; yielding flattens the top.");
}

std::string section_figures(const SolvedCase& solved, SectionPainter& painter) {
  const auto files = files_at_largest_load(solved, "fields.pvd");
  if (files.empty()) return no_fields(solved);
  const double a = hertz_radius(solved);
  // Off the symmetry plane by a part of a cell: a cut along cell faces belongs to neither neighbour.
  constexpr double off_faces = 0.3;
  const double spacing = std::isfinite(solved.interface_spacing()) ? solved.interface_spacing() : a / 50;
  const auto surface = files_at_largest_load(solved, "interface.pvd");
  const InterfaceExtent contact = surface.empty() ? InterfaceExtent{} : interface_extent(surface[0]);
  const double y = contact.peak_y + off_faces * spacing;
  const auto section = vertical_section(files, y);

  // The whole contact, and a close-up of the interface; half widths and heights in contact radii.
  const SectionView stress = section_view(*section, "von_mises", ColourScale::viridis(), 0, 1.7 * a, 1.15 * a, spacing);
  const SectionView close_stress =
      section_view(*section, "von_mises", ColourScale::viridis(), contact.peak_x, 0.4 * a, 0.27 * a, spacing);
  const SectionView strain =
      section_view(*section, "equivalent_plastic_strain", ColourScale::white_to_red(), 0, 1.7 * a, 1.15 * a, spacing);
  const SectionView close_strain =
      section_view(*section, "equivalent_plastic_strain", ColourScale::white_to_red(), contact.peak_x, 0.4 * a, 0.27 * a, spacing);
  const bool has_yielded = strain.range.high > 0;
  std::vector<SectionView> views{stress, close_stress};
  if (has_yielded) views.insert(views.end(), {strain, close_strain});
  try {
    const auto images = painter.draw(*section, views);
    const std::string stress_label = "von Mises stress [GPa]", strain_label = "equivalent plastic strain [%]";
    constexpr double percent = 0.01;
    std::string html = side_by_side(
        {figure_html("Von Mises stress", section_svg(stress, images[0], stress_label, GPa),
                     "A vertical cut through sphere (above) and plane (below) at the largest load, through the place of the largest "
                     "pressure (y = " + in_units(y, Dimension::length) + "). This stress decides where "
                     "material yields. Between smooth bodies it is largest about half a contact radius below the surface; "
                     "roughness adds peaks under each asperity that touches."),
         figure_html("Von Mises stress, close to the interface", section_svg(close_stress, images[1], stress_label, GPa),
                     "The same cut around the largest pressure, magnified. Lines are the mesh; grey between the bodies is an open gap.")});
    if (!has_yielded) return html + note("No material has yielded anywhere in this section: there is no plastic strain to show.");
    return html + side_by_side(
        {figure_html("Plastic strain", section_svg(strain, images[2], strain_label, percent),
                     "Where material has yielded for good: white is still elastic, grey is outside of the bodies. Spots right at the surface are flattened "
                     "asperities; a zone deeper down would be yielding of the bulk."),
         figure_html("Plastic strain, close to the interface", section_svg(close_strain, images[3], strain_label, percent),
                     "The same cut around the largest pressure, magnified, with the mesh.")});
  } catch (const WorkError& error) {
    return note("The vertical section could not be drawn: " + escaped(error.what()) + ".");
  }
}

}  // namespace asperity::report
