#include "report/study_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "dem_compare/comparison.h"
#include "report/axis.h"
#include "report/case_report.h"
#include "report/curves.h"
#include "report/page.h"
#include "report/result_tables.h"
#include "report/words.h"
#include "surfaces/topography_spec.h"

namespace asperity::report {
namespace {

namespace fs = std::filesystem;
constexpr double tolerance = 0.05;
constexpr double kN_per_m = 1e3, GPa = 1e9, nm = 1e-9, um = 1e-6;

/// Index of the axis that varies the load; -1 if none does.
int load_axis(const std::vector<CollectionAxis>& axes) {
  const std::string name = "Normal load";
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].name.size() >= name.size() && axes[i].name.compare(axes[i].name.size() - name.size(), name.size(), name) == 0)
      return static_cast<int>(i);
  return -1;
}

/// Groups with the same contact and different loads as one curve, in the study's order.
std::vector<StudyCurve> curves_of(const CaseCollection& collection, const Comparison& comparison) {
  const int load = load_axis(collection.axes);
  std::vector<StudyCurve> curves;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const GroupComparison& group = comparison.groups[g];
    std::string label;
    for (std::size_t i = 0; i < group.values.size(); ++i)
      if (static_cast<int>(i) != load) label += (label.empty() ? "" : ", ") + group.values[i];
    if (label.empty()) label = load >= 0 ? "computed" : group.label;
    auto at = std::find_if(curves.begin(), curves.end(), [&](const StudyCurve& curve) { return curve.label == label; });
    if (at == curves.end()) at = curves.insert(at, {label, {}, nullptr});
    at->groups.push_back(&group);
  }
  for (auto& curve : curves) {
    std::sort(curve.groups.begin(), curve.groups.end(),
              [](const auto* a, const auto* b) { return a->numbers.force < b->numbers.force; });
    curve.largest = &collection.groups[static_cast<std::size_t>(curve.groups.back() - comparison.groups.data())];
  }
  return curves;
}

std::string missing_html(const CaseCollection& collection) {
  if (collection.missing.empty()) return "";
  std::string html = "<div class='warning'><b>" + std::to_string(collection.missing.size()) + " of " +
                     std::to_string(collection.planned) +
                     " cases are not in this report.</b> Means and scatter are over those that are; <code>asperity study … "
                     "--resume</code> goes on with the rest.<ul>";
  for (const auto& missing : collection.missing)
    html += "<li>" + escaped(missing.name) + ": " + escaped(missing.state) +
            (missing.message.empty() ? "" : " (" + escaped(missing.message) + ")") + "</li>";
  return html + "</ul></div>\n";
}

std::string headline(const std::vector<StudyCurve>& curves) {
  std::size_t hertzian = 0;
  const StudyCurve* worst = nullptr;
  const LoadComparison* worst_load = nullptr;
  double departure = -1;
  for (const auto& curve : curves) {
    const GroupComparison& group = curve.last();
    if (!group.loads.empty() && group.hertzian_from <= group.loads.front().force) ++hertzian;
    for (const auto& load : group.loads)
      if (std::abs(load.stiffness_ratio.mean - 1) > departure) {
        departure = std::abs(load.stiffness_ratio.mean - 1);
        worst = &curve;
        worst_load = &load;
      }
  }
  if (!worst) return "There is nothing to judge yet.";
  std::string text = (hertzian == curves.size() ? std::string("All ") + std::to_string(curves.size())
                                                : std::to_string(hertzian) + " of " + std::to_string(curves.size())) +
                     " contacts are as stiff as Hertz within " + percent_text(tolerance) + " at every load";
  return text + "; the largest departure is " + departure_text(worst_load->stiffness_ratio.mean) + " (" + readable(worst->label) +
         ", at " + in_units(worst_load->force, Dimension::force) + ").";
}

std::string numerical_error_sentence(const std::vector<StudyCurve>& curves) {
  for (const auto& curve : curves) {
    const SolvedCase& solved = curve.largest->first();
    const GroupComparison& group = curve.last();
    if (solved.is_rough() || group.numbers.force >= solved.first_yield_force() || group.loads.empty()) continue;
    const auto& top = group.loads.back();
    return "Error of the computation, where the truth is known: the smooth contact (" + readable(curve.label) +
           ") must follow Hertz and departs by " + departure_text(top.stiffness_ratio.mean) + " in stiffness, " +
           departure_text(top.force_ratio.mean) + " in force and " + departure_text(top.area_ratio.mean) +
           " in contact area at " + in_units(top.force, Dimension::force) + ".";
  }
  return "";
}

std::string mesh_sentence(const Comparison& comparison) {
  double largest = 0;
  bool known = false;
  for (const auto& group : comparison.groups)
    if (group.mesh) known = true, largest = std::max(largest, std::abs(group.mesh->relative_error));
  return known ? "Mesh error of the stiffness, from several spacings: up to " + percent_text(largest) + " (a column of its own below)."
               : "Mesh error: each contact was solved on one spacing only, so it is not known from this study itself; vary "
                 "Mesh/Interface spacing to have it.";
}

std::string worst_balance_sentence(const CaseCollection& collection) {
  std::map<std::string, double> worst;
  for (const auto& group : collection.groups)
    for (const auto& solved : group.cases)
      if (solved.result.contains("balance"))
        for (const auto& [name, value] : solved.result["balance"].items())
          if (std::isfinite(number_of(value))) worst[name] = std::max(worst[name], std::abs(number_of(value)));
  std::string text;
  for (const auto& [name, error] : worst) text += (text.empty() ? "" : ", ") + escaped(name) + " " + percent_bound(error);
  return text.empty() ? "" : "Largest relative errors of the balances over all cases: " + text + ".";
}

std::string verdict(const CaseCollection& collection, const Comparison& comparison, const std::vector<StudyCurve>& curves) {
  std::vector<std::string> sentences;
  for (const auto& curve : curves)
    sentences.push_back("<b>" + readable(curve.label) + "</b>: " + readable(curve.last().verdict));
  for (const auto& sentence : {numerical_error_sentence(curves), mesh_sentence(comparison), worst_balance_sentence(collection)})
    if (!sentence.empty()) sentences.push_back(sentence);
  return verdict_html(headline(curves), sentences);
}

std::string mesh_error_cell(const GroupComparison& group) {
  return group.mesh ? percent_text(group.mesh->relative_error) + (group.mesh->order_is_assumed ? " *" : "") : "not known";
}

std::string stiffness_table(const std::vector<StudyCurve>& curves) {
  Table table{{"contact", "load", "realisations", "stiffness, loading [kN/m]", "over Hertz", "stiffness, unloading [kN/m]",
               "over Hertz", "standard error of the mean", "mesh error"}, {}, true};
  for (const auto& curve : curves)
    for (const auto* group : curve.groups) {
      const GroupNumbers& n = group->numbers;
      const double hertz = n.hertz.normal_stiffness(n.force);
      table.rows.push_back({readable(curve.label), in_units(n.force, Dimension::force), std::to_string(group->realisations),
                            plus_minus(n.loading_stiffness, kN_per_m), departure_text(n.loading_stiffness.mean / hertz),
                            plus_minus(n.unloading_stiffness, kN_per_m), departure_text(n.unloading_stiffness.mean / hertz),
                            percent_text(n.loading_stiffness.standard_error / n.loading_stiffness.mean), mesh_error_cell(*group)});
    }
  return table_html(table) +
         note("± is the standard deviation over realisations: how much one rough surface differs from the next with the same "
              "statistics. The standard error says how well their mean is known. The mesh error is the computation's own and not "
              "contained in ±; * marks an assumed order of convergence.");
}

std::string contact_table(const std::vector<StudyCurve>& curves) {
  Table table{{"contact", "load", "approach [nm]", "real contact area over Hertz", "largest pressure [GPa]", "over Hertz",
               "imprint left [nm]", "radius a Hertz fit reports [µm]", "exponent it would find"}, {}, true};
  for (const auto& curve : curves)
    for (const auto* group : curve.groups) {
      const GroupNumbers& n = group->numbers;
      table.rows.push_back({readable(curve.label), in_units(n.force, Dimension::force), plus_minus(n.approach, nm),
                            departure_text(n.contact_area.mean / n.hertz.contact_area(n.force)), plus_minus(n.largest_pressure, GPa),
                            departure_text(n.largest_pressure.mean / n.hertz.peak_pressure(n.force)),
                            plus_minus(n.residual_imprint, nm), plus_minus(n.fitted_radius, um), plus_minus(n.exponent)});
    }
  const double radius = curves.empty() ? NAN : curves.front().last().numbers.hertz.radius;
  return table_html(table) +
         note("The fit is what an experimenter would make of the loading curve with Hertz's law, the sphere's radius left free (the "
              "true one is " + in_units(radius, Dimension::length) + ", Hertz's exponent 1.5).");
}

/// What result.json says of a surface within the contact region [m]; NaN if it does not.
double as_meshed_rms(const SolvedCase& solved, const std::string& body) {
  const nlohmann::ordered_json inputs = solved.result.value("inputs", nlohmann::ordered_json::object());
  const nlohmann::ordered_json rms = inputs.value("rms_in_region", nlohmann::ordered_json::object());
  return rms.contains(body) ? number_of(rms[body]) : std::numeric_limits<double>::quiet_NaN();
}

/// Root mean square height of both surfaces together [m]; NaN where it is not known.
double composite_rms(const SolvedCase& solved) {
  double squares = 0;
  for (const std::string section : {"Particle", "Substrate"}) {
    const std::string spec = solved.entries.text(section + "/Topography", "smooth");
    if (spec == "smooth") continue;
    double rms = NAN;
    if (is_generator_call(spec)) {
      rms = parse_generator(spec).spectrum.rms;
    } else {
      rms = as_meshed_rms(solved, section == "Particle" ? "particle" : "substrate");
    }
    squares += rms * rms;
  }
  return std::sqrt(squares);
}

std::string rms_figure(const CaseCollection& collection, const Comparison& comparison) {
  std::map<std::string, Series> by_load;  // the load's text, in the order of the study
  std::vector<std::string> order;
  std::map<double, int> different;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const GroupComparison& group = comparison.groups[g];
    const double rms = composite_rms(collection.groups[g].first());
    if (!std::isfinite(rms) || group.loads.empty()) continue;
    ++different[rms];
    const std::string load = in_units(group.numbers.force, Dimension::force);
    auto found = by_load.find(load);
    if (found == by_load.end()) {
      found = by_load.emplace(load, Series{load, line_colour(by_load.size()), Series::Style::line_with_points, {}, {}, {}}).first;
      order.push_back(load);
    }
    found->second.x.push_back(rms / nm);
    found->second.y.push_back(group.loads.back().stiffness_ratio.mean);
    found->second.error.push_back(group.loads.back().stiffness_ratio.sd);
  }
  constexpr std::size_t fewest = 3;
  if (different.size() < fewest) return "";
  Chart chart;
  chart.x_label = "RMS roughness of both surfaces together [nm]";
  chart.y_label = "stiffness / Hertz";
  chart.y_from_zero = false;
  chart.band_low = 1 - tolerance;
  chart.band_high = 1 + tolerance;
  chart.band_label = "Hertz ± " + percent_text(tolerance);
  chart.width = 520;
  for (const auto& load : order) chart.series.push_back(by_load[load]);
  return figure_html("Stiffness against roughness", to_svg(chart),
                     "Each line is one load. Bars are the standard deviation over realisations. RMS is √(RMS² of the sphere + RMS² of "
                     "the plane); surfaces with the same RMS can still differ in how fine their roughness is.");
}

std::string curves_section(const std::vector<StudyCurve>& curves, const CaseCollection& collection, const Comparison& comparison) {
  std::string body = figure_html(
      "Load against approach", to_svg(load_approach_chart(curves)),
      "Loading and first unloading at the largest load; each thin line is one realisation of the surface, the dashed line is Hertz's "
      "law for the same bodies, smooth and elastic. A rough contact starts softer, because at first only the highest asperities carry; later it runs nearly parallel to Hertz's curve.");
  const std::string stiffness = figure_html(
      "Stiffness over Hertz's", to_svg(ratio_chart(curves, &LoadComparison::stiffness_ratio, "stiffness / Hertz (same load)", tolerance)),
      "1 is Hertz; the green band is where departures are smaller than the tolerance. Bars are the standard deviation over realisations.");
  const std::string area = figure_html(
      "Real contact area over Hertz's", to_svg(ratio_chart(curves, &LoadComparison::area_ratio, "contact area / Hertz (same load)", tolerance)),
      "How much of Hertz's circle truly touches. It grows with load as asperities are pressed in.");
  body += side_by_side({stiffness, area});
  const std::string force = figure_html(
      "Force over Hertz's", to_svg(ratio_chart(curves, &LoadComparison::force_ratio, "force / Hertz (same approach)", tolerance)),
      "At the same approach. This depends on where the approach is counted from: an experimenter who sets the zero at a small force sees less of it.");
  const std::string roughness = rms_figure(collection, comparison);
  body += side_by_side({force, roughness});
  return section_html("Against Hertz", body);
}

const SolvedCase& case_with_fields(const CaseGroup& group) {
  for (const auto& solved : group.cases)
    if (!files_at_largest_load(solved, "interface.pvd").empty()) return solved;
  return group.first();
}

std::string gallery(const std::vector<StudyCurve>& curves, SectionPainter& painter) {
  std::string body = note("Of each contact one realisation (the first with fields) at its largest load.");
  for (const auto& curve : curves) {
    const SolvedCase& solved = case_with_fields(*curve.largest);
    body += "<h3>" + readable(curve.label) + ", " + in_units(curve.last().numbers.force, Dimension::force) + "</h3>\n";
    if (solved.is_rough()) body += roughness_figures(solved);
    body += side_by_side({pressure_map_figure(solved, "Pressure, seen from above"), pressure_profile_figure(solved)});
    body += section_figures(solved, painter);
  }
  return section_html("The contacts in pictures", body);
}

std::string case_list(const CaseCollection& collection) {
  Table table{{"folder", "cells", "unknowns", "force", "moment", "energy", "wall time", "peak memory [GiB]"}, {}, true};
  for (const auto& group : collection.groups)
    for (const auto& solved : group.cases) {
      const auto entry = [&](const char* part, const char* name) {
        return solved.result.contains(part) && solved.result[part].contains(name) ? number_of(solved.result[part][name]) : NAN;
      };
      const auto count = [](double value) { return std::isfinite(value) ? std::to_string(std::llround(value)) : std::string("–"); };
      constexpr double GiB = 1024.0 * 1024 * 1024;
      table.rows.push_back({escaped(solved.folder.filename().string()), count(entry("mesh", "cells")), count(entry("mesh", "dofs")),
                            percent_text(entry("balance", "force")), percent_text(entry("balance", "moment")),
                            percent_text(entry("balance", "energy")), duration_text(entry("cost", "wall_time")),
                            plus_minus({1, entry("cost", "peak_memory"), NAN, NAN}, GiB)});
    }
  return table_html(table) + note("force, moment and energy are the relative errors of the balances. <code>asperity report</code> on "
                                  "one of the folders writes the full page of that case.");
}

}  // namespace

std::string study_report_html(const fs::path& folder, SectionPainter& painter) {
  const CaseCollection collection = collect_cases({folder});
  const Comparison comparison = compare_with_hertz(collection, tolerance);
  const std::vector<StudyCurve> curves = curves_of(collection, comparison);
  const std::string title = collection.title.empty() || collection.title == "untitled" ? "Study" : collection.title;

  std::string body;
  if (!collection.groups.empty()) {
    body += paragraph(what_was_asked(collection.groups.front().first()));
    std::string varied;
    for (const auto& axis : collection.axes) {
      varied += (varied.empty() ? "" : "; ") + escaped(axis.name) + ": ";
      for (std::size_t i = 0; i < axis.labels.size(); ++i) varied += (i ? ", " : "") + readable(axis.labels[i]);
    }
    if (!varied.empty())
      body += paragraph("That is the first of " + std::to_string(collection.planned) + " cases, in which these are varied: " + varied + ".");
  }
  body += missing_html(collection);
  if (collection.groups.empty()) return page_html(title, subtitle_of(folder, nullptr), body);
  body += verdict(collection, comparison, curves);
  body += section_html("Stiffness", stiffness_table(curves));
  body += section_html("Contact, imprint, and what a fit would report", contact_table(curves));
  body += curves_section(curves, collection, comparison);
  body += gallery(curves, painter);
  std::string tables;
  for (const auto& group : comparison.groups) tables += details_html(readable(group.label), paragraph(readable(group.verdict)) + ratio_table(group));
  body += section_html("Load by load", tables);
  body += section_html("How far to trust it, and what it cost", case_list(collection) +
                           details_html("First case: mesh, cost, versions", remaining_tables(collection.groups.front().first())));
  body += section_html("What went in", note("Of the first case:") + inputs_table(collection.groups.front().first()));
  return page_html(title, subtitle_of(folder, collection.groups.front().first().result), body);
}

}  // namespace asperity::report
