#include "report/study_report.h"

#include <map>

#include "dem_compare/comparison.h"
#include "report/axis.h"
#include "report/case_report.h"
#include "report/page.h"
#include "report/result_tables.h"
#include "report/study_figures.h"
#include "report/study_tables.h"
#include "report/study_verdict.h"
#include "report/words.h"

namespace asperity::report {
namespace {

namespace fs = std::filesystem;

std::string missing_html(const CaseCollection& collection) {
  if (collection.missing.empty()) return "";
  std::string list = "<ul>";
  std::map<std::string, int> states;
  for (const auto& missing : collection.missing) {
    ++states[missing.state];
    list += "<li>" + escaped(missing.name) + ": " + escaped(missing.state) +
            (missing.message.empty() ? "" : " (" + escaped(missing.message) + ")") + "</li>";
  }
  list += "</ul>";
  std::string counts;
  for (const auto& [state, count] : states) counts += (counts.empty() ? "" : ", ") + std::to_string(count) + " " + escaped(state);
  constexpr std::size_t most_in_view = 8;
  if (collection.missing.size() > most_in_view) list = details_html("Which ones", list);
  return "<div class='warning'><b>" + std::to_string(collection.missing.size()) + " of " + std::to_string(collection.planned) +
         " cases are not in this report</b> (" + counts +
         "). Means and scatter are over those that are; <code>asperity study … --resume</code> goes on with the rest." + list + "</div>\n";
}

std::string what_is_varied(const CaseCollection& collection) {
  std::string varied;
  for (const auto& axis : collection.axes) {
    if (axis.labels.size() < 2) continue;
    varied += (varied.empty() ? "" : "; ") + escaped(axis.name) + ": ";
    for (std::size_t i = 0; i < axis.labels.size(); ++i) varied += (i ? " | " : "") + readable(axis.labels[i]);
  }
  return varied.empty() ? ""
                        : paragraph("That is the first of " + std::to_string(collection.planned) +
                                    " cases, in which these are varied: " + varied + ".");
}

std::string which_mesh(const std::vector<StudyCurve>& curves) {
  if (curves.empty() || curves.front().last().other_spacings.empty()) return "";
  return note("Results are those of the finest mesh (" + in_units(curves.front().last().interface_spacing, Dimension::length) +
              " at the interface); the coarser ones serve to tell its error.");
}

}  // namespace

std::string study_report_html(const fs::path& folder, SectionPainter& painter) {
  const CaseCollection collection = collect_cases({folder});
  const Comparison comparison = compare_with_hertz(collection, tolerance);
  const std::vector<StudyCurve> curves = curves_of(collection, comparison);
  const std::string title = collection.title.empty() || collection.title == "untitled" ? "Study" : collection.title;

  std::string body;
  if (!collection.groups.empty()) body += paragraph(what_was_asked(collection.groups.front().first())) + what_is_varied(collection);
  body += missing_html(collection);
  if (collection.groups.empty()) return page_html(title, subtitle_of(folder, nullptr), body);
  const SolvedCase& first = collection.groups.front().first();
  body += study_verdict(collection, curves);
  body += which_mesh(curves);
  body += section_html("Against Hertz", load_figures(curves));
  const std::string dependence = roughness_dependence_figures(curves), surfaces = surfaces_table(curves);
  if (!(dependence + surfaces).empty()) body += section_html("RMS and spectrum", surfaces + dependence);
  body += section_html("Stiffness, load by load", stiffness_table(curves));
  body += section_html("Contact and pressure, load by load", contact_table(curves));
  body += section_html("What stays behind, and what a fit would report", imprint_and_fit_table(curves));
  body += section_html("The contacts in pictures", gallery(curves, painter));
  body += section_html("How far to trust it, and what it cost",
                       case_list(collection) + details_html("First case: mesh, cost, versions", remaining_tables(first)));
  body += section_html("What went in", note("Of the first case:") + inputs_table(first));
  return page_html(title, subtitle_of(folder, first.result), body);
}

}  // namespace asperity::report
