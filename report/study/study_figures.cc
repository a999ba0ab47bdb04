#include "report/study/study_figures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "report/curves/curves.h"
#include "report/fields/case_fields.h"
#include "report/fields/surface_maps.h"
#include "report/page/axis.h"
#include "report/page/colour_scale.h"
#include "report/page/display_units.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/result/surface_spectra.h"
#include "surfaces/virtual_afm.h"

namespace asperity::report {
namespace {

/// First, middle and last load of a path.
std::vector<std::size_t> shown_loads(const GroupComparison& group) {
  const std::size_t n = group.loads.size();
  if (n < 3) return n ? std::vector<std::size_t>{n - 1} : std::vector<std::size_t>{};
  return {0, n / 2, n - 1};
}

/// Stiffness over Hertz's against something of the surfaces, one line per load; the contacts are given in any
/// order.
Chart stiffness_against(std::vector<const StudyCurve*> curves, const std::string& label,
                        const std::function<double(const StudyCurve&)>& abscissa) {
  std::sort(curves.begin(), curves.end(),
            [&](const auto* a, const auto* b) { return abscissa(*a) < abscissa(*b); });
  Chart chart{label, "stiffness / Hertz (same load)"};
  chart.y_from_zero = false;
  chart.band_low = 1 - tolerance;
  chart.band_high = 1 + tolerance;
  chart.band_label = "Hertz ± " + percent_text(tolerance);
  chart.width = 520;
  for (const std::size_t at : shown_loads(curves.front()->last())) {
    const double force = curves.front()->last().loads[at].force;
    Series series{in_units(force, Dimension::force), line_colour(chart.series.size()),
                  Series::Style::line_with_points};
    for (const auto* curve : curves) {
      const auto& loads = curve->last().loads;
      constexpr double same = 1e-3;
      const auto load = std::find_if(loads.begin(), loads.end(),
                                     [&](const auto& l) { return std::abs(l.force - force) < same * force; });
      if (load == loads.end()) continue;
      series.x.push_back(abscissa(*curve));
      series.y.push_back(load->stiffness_ratio.mean);
      series.error.push_back(load->stiffness_ratio.sd);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

template <class Key>
std::vector<const StudyCurve*> largest_group(const std::map<Key, std::vector<const StudyCurve*>>& groups) {
  std::vector<const StudyCurve*> largest;
  for (const auto& [key, curves] : groups)
    if (curves.size() > largest.size()) largest = curves;
  return largest;
}

/// Contacts whose roughness has the same spectrum but for its RMS; smooth ones belong to all.
std::string rms_figure(const std::vector<StudyCurve>& curves) {
  std::map<std::string, std::vector<const StudyCurve*>> by_shape;
  for (const auto& curve : curves)
    if (!spectrum_shape(curve.largest->first()).empty())
      by_shape[spectrum_shape(curve.largest->first())].push_back(&curve);
  auto family = largest_group(by_shape);
  for (const auto& curve : curves)
    if (!curve.largest->first().is_rough()) family.push_back(&curve);
  constexpr std::size_t fewest = 3;
  if (family.size() < fewest) return "";
  return figure_html(
      "Stiffness against roughness",
      to_svg(stiffness_against(family, "RMS roughness of both surfaces together [nm]",
                               [](const StudyCurve& c) { return composite_rms(c.largest->first()) / nm; })),
      "Contacts with the same spectrum but for its height. Each line is one load of the path; bars are the "
      "standard deviation over realisations. RMS is √(RMS² of the sphere + RMS² of the plane).");
}

/// Contacts with the same RMS and different spectra.
std::string spectrum_figure(const std::vector<StudyCurve>& curves) {
  std::map<double, std::vector<const StudyCurve*>> by_rms;
  const auto correlation = [](const StudyCurve& curve) {
    return correlation_length(generator_of(curve.largest->first(), "Substrate")->spectrum) / nm;
  };
  for (const auto& curve : curves) {
    const auto generator = generator_of(curve.largest->first(), "Substrate");
    if (generator) by_rms[generator->spectrum.rms].push_back(&curve);
  }
  const auto family = largest_group(by_rms);
  constexpr std::size_t fewest = 2;
  if (family.size() < fewest) return "";
  return figure_html(
      "Stiffness against spectrum",
      to_svg(stiffness_against(family, "correlation length of the plane's surface [nm]", correlation)),
      "Contacts whose plane has the same RMS, " +
          in_units(generator_of(family.front()->largest->first(), "Substrate")->spectrum.rms,
                   Dimension::length) +
          ", and another spectrum: to the right its waves are longer and its slopes smaller.");
}

const SolvedCase& case_with_fields(const CaseGroup& group) {
  for (const auto& solved : group.cases)
    if (!files_at_largest_load(solved, "interface.pvd").empty()) return solved;
  return group.first();
}

}  // namespace

std::string load_figures(const std::vector<StudyCurve>& curves) {
  const std::string bars = "Bars are the standard deviation over realisations.";
  return figure_html("Load against approach", to_svg(load_approach_chart(curves)),
                     "Loading and first unloading at the largest load; each thin line is one realisation of "
                     "the surface, the dashed line is Hertz's law for the same bodies, smooth and elastic. A "
                     "rough contact starts softer, because at first only the highest asperities carry; later "
                     "it runs nearly parallel to Hertz's curve.") +
         side_by_side(
             {figure_html(
                  "Stiffness against load",
                  to_svg(value_chart(
                      curves, &LoadComparison::stiffness, kN_per_m, "normal stiffness dF/dδ [kN/m]",
                      [](const Hertz& hertz, double force) { return hertz.normal_stiffness(force); })),
                  "The slope of the loading curves, which a discrete element simulation needs as "
                  "k<sub>n</sub>. " +
                      bars),
              figure_html(
                  "Stiffness over Hertz's",
                  to_svg(
                      ratio_chart(curves, &LoadComparison::stiffness_ratio, "stiffness / Hertz (same load)")),
                  "1 is Hertz; the green band is where departures are smaller than the tolerance. " + bars),
              figure_html(
                  "Force over Hertz's",
                  to_svg(ratio_chart(curves, &LoadComparison::force_ratio, "force / Hertz (same approach)")),
                  "At the same approach. This depends on where the approach is counted from: an experimenter "
                  "who sets the zero at a small force sees less of it. " +
                      bars),
              figure_html("Real contact area over Hertz's",
                          to_svg(ratio_chart(curves, &LoadComparison::area_ratio,
                                             "contact area / Hertz (same load)")),
                          "How much of Hertz's circle truly touches. It grows with load as asperities are "
                          "pressed in. " +
                              bars),
              figure_html(
                  "Largest pressure",
                  to_svg(value_chart(
                      curves, &LoadComparison::largest_pressure, GPa, "largest contact pressure [GPa]",
                      [](const Hertz& hertz, double force) { return hertz.peak_pressure(force); })),
                  "On the hardest pressed asperity. Yielding bounds it near the hardness, about three times "
                  "the yield stress. " +
                      bars),
              figure_html(
                  "Mean pressure",
                  to_svg(value_chart(
                      curves, &LoadComparison::mean_pressure, GPa, "load / real contact area [GPa]",
                      [](const Hertz& hertz, double force) { return hertz.peak_pressure(force) * 2 / 3; })),
                  "Where roughness decides, it hardly depends on the load: more asperities come into contact "
                  "instead. " +
                      bars)});
}

std::string roughness_dependence_figures(const std::vector<StudyCurve>& curves) {
  std::vector<std::string> figures;
  for (const auto& figure : {rms_figure(curves), spectrum_figure(curves)})
    if (!figure.empty()) figures.push_back(figure);
  return figures.empty() ? "" : side_by_side(figures);
}

std::string gallery(const std::vector<StudyCurve>& curves, SectionPainter& painter) {
  std::string body = note("Of each contact one realisation (the first with fields) at its largest load.");
  for (const auto& curve : curves) {
    const SolvedCase& solved = case_with_fields(*curve.largest);
    body += "<h3>" + readable(curve.label) + ", " + in_units(curve.last().numbers.force, Dimension::force) +
            "</h3>\n";
    if (solved.is_rough()) body += roughness_figures(solved);
    body += contact_figures(solved);
    body += section_figures(solved, painter);
  }
  return body;
}

}  // namespace asperity::report
