#include "report/fields/section_figures.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "report/fields/case_fields.h"
#include "report/page/axis.h"
#include "report/page/display_units.h"
#include "report/page/page.h"
#include "report/page/words.h"

namespace asperity::report {
namespace {

constexpr double one_percent = 0.01;

/// Largest value of a cell array among cells whose first point lies in the window, without the uppermost
/// outliers.
ColourRange range_in_window(vtkPolyData& section, const SectionView& view) {
  vtkDataArray* array = section.GetCellData()->GetArray(view.array.c_str());
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < section.GetNumberOfCells(); ++i) {
    const double* bounds = section.GetCell(i)->GetBounds();
    if (bounds[1] > view.x_low && bounds[0] < view.x_high && bounds[5] > view.z_low &&
        bounds[4] < view.z_high)
      values.push_back(array->GetComponent(i, 0));
  }
  if (values.empty()) return {0, 0};
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>((1 - outliers) * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  const double high = *at > 0 ? *at : *std::max_element(values.begin(), values.end());
  return {std::min(0.0, *std::min_element(values.begin(), values.end())), high};
}

/// A window of the given half width and height [m] around (x, 0), its colours from zero, or below it, to the
/// largest value in it.
SectionView section_view(vtkPolyData& section, const std::string& array, const ColourScale& scale, double x,
                         double half_width, double half_height, double spacing) {
  SectionView view{array, x - half_width, x + half_width, -half_height, half_height, &scale, {}};
  view.range = range_in_window(section, view);
  // Lines of the mesh closer than this would hide what they divide.
  constexpr double fewest_pixels_per_cell = 7;
  view.edges = spacing * view.width / (2 * half_width) >= fewest_pixels_per_cell;
  return view;
}

/// What is drawn of a section, in which unit, and what is said about it.
struct SectionFigure {
  SectionView view;
  std::string colour_label;
  double unit;
  std::string title, explanation;
};

std::string html_of(const SectionFigure& section, const Image& image) {
  const SectionView& view = section.view;
  MapFigure figure = figure_in_nm(view.x_low, view.x_high, view.z_low, view.z_high, "z");
  figure.colour_label = section.colour_label;
  figure.scale = view.scale;
  figure.range = {view.range.low / section.unit, view.range.high / section.unit};
  figure.width = 520;
  return figure_html(section.title, to_svg(figure, image), section.explanation);
}

}  // namespace

std::vector<Image> SectionPainter::draw(vtkPolyData& section, const std::vector<SectionView>& views) {
  if (!display_) display_ = std::make_unique<VirtualDisplay>();
  if (!display_->available()) throw WorkError(display_->problem());
  try {
    return draw_sections(section, views, display_->name());
  } catch (const WorkError&) {
    // A server that starts while another one ends can lose its number to it; the next one has it for itself.
    if (!display_->is_own_server()) throw;
    display_.reset();
    display_ = std::make_unique<VirtualDisplay>();
    return draw_sections(section, views, display_->name());
  }
}

std::string section_figures(const SolvedCase& solved, SectionPainter& painter) {
  const auto files = files_at_largest_load(solved, "fields.pvd");
  if (files.empty()) return no_fields(solved);
  const double a = hertz_radius(solved);
  // Off the symmetry plane by a part of a cell: a cut along cell faces belongs to neither neighbour.
  constexpr double off_faces = 0.3, cells_over_radius = 50;
  const double spacing =
      std::isfinite(solved.interface_spacing()) ? solved.interface_spacing() : a / cells_over_radius;
  const auto surface = files_at_largest_load(solved, "interface.pvd");
  const InterfaceExtent contact = surface.empty() ? InterfaceExtent{} : interface_extent(surface[0]);
  const double y = contact.peak_y + off_faces * spacing;
  const auto section = vertical_section(files, y);

  // The whole contact, and a close-up of the interface; half widths and heights in contact radii.
  const auto whole = [&](const std::string& array, const ColourScale& scale) {
    return section_view(*section, array, scale, 0, 1.7 * a, 1.15 * a, spacing);
  };
  const auto close = [&](const std::string& array, const ColourScale& scale) {
    return section_view(*section, array, scale, contact.peak_x, 0.4 * a, 0.27 * a, spacing);
  };
  const std::string stress = "von Mises stress [GPa]", strain = "equivalent plastic strain [%]";
  std::vector<SectionFigure> figures{
      {whole("von_mises", ColourScale::viridis()), stress, GPa, "Von Mises stress",
       "A vertical cut through sphere (above) and plane (below) at the largest load, through the place of "
       "the largest pressure (y = " +
           in_units(y, Dimension::length) +
           "). This stress decides where material yields. Between smooth bodies it is largest about half a "
           "contact radius below the "
           "surface; roughness adds peaks under each asperity that touches."},
      {close("von_mises", ColourScale::viridis()), stress, GPa, "Von Mises stress, close to the interface",
       "The same cut around the largest pressure, magnified. Lines are the mesh; grey between the bodies is "
       "an open gap."}};
  const SectionView yielded = whole("equivalent_plastic_strain", ColourScale::white_to_red());
  const bool has_yielded = yielded.range.high > 0;
  if (has_yielded) {
    figures.push_back(
        {yielded, strain, one_percent, "Plastic strain",
         "Where material has yielded for good: white is still elastic, grey is outside of the bodies. Spots "
         "right at the "
         "surface are flattened asperities; a zone deeper down would be yielding of the bulk."});
    figures.push_back({close("equivalent_plastic_strain", ColourScale::white_to_red()), strain, one_percent,
                       "Plastic strain, close to the interface",
                       "The same cut around the largest pressure, magnified, with the mesh."});
  }
  for (const auto& field : added_scalars(solved, "bodies"))
    figures.push_back(
        {whole(field.name, ColourScale::viridis()), field.label(), 1, field.name, escaped(field.meaning)});
  std::vector<SectionView> views;
  for (const auto& figure : figures) views.push_back(figure.view);
  try {
    const auto images = painter.draw(*section, views);
    std::vector<std::string> html;
    for (std::size_t i = 0; i < figures.size(); ++i) html.push_back(html_of(figures[i], images[i]));
    return side_by_side(html) + (has_yielded ? ""
                                             : note("No material has yielded anywhere in this section: there "
                                                    "is no plastic strain to show."));
  } catch (const WorkError& error) {
    return note("The vertical section could not be drawn: " + escaped(error.what()) + ".");
  }
}

}  // namespace asperity::report
