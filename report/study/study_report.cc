#include "report/study/study_report.h"

#include <algorithm>
#include <map>
#include <optional>

#include "dem_compare/compare/comparison.h"
#include "paper/against_published.h"
#include "report/case/case_report.h"
#include "report/motion/resistance_file.h"
#include "report/motion/resistance_section.h"
#include "report/page/axis.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/result/result_tables.h"
#include "report/study/study_figures.h"
#include "report/study/study_tables.h"
#include "report/study/study_verdict.h"

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
  for (const auto& [state, count] : states)
    counts += (counts.empty() ? "" : ", ") + std::to_string(count) + " " + escaped(state);
  constexpr std::size_t most_in_view = 8;
  if (collection.missing.size() > most_in_view) list = details_html("Which ones", list);
  return "<div class='warning'><b>" + std::to_string(collection.missing.size()) + " of " +
         std::to_string(collection.planned) + " cases are not in this report</b> (" + counts +
         "). Means and scatter are over those that are; <code>asperity study … --resume</code> goes on with "
         "the rest." +
         list + "</div>\n";
}

/// Cases whose energy does not balance to a hundredth.
std::string doubt_html(const CaseCollection& collection) {
  if (collection.remarks.empty()) return "";
  std::string list;
  for (const auto& remark : collection.remarks) list += "<li>" + escaped(remark) + "</li>";
  return "<div class='warning'><b>The energy of " + std::to_string(collection.remarks.size()) +
         " of the cases does not balance:</b><ul>" + list + "</ul></div>\n";
}

std::string what_is_varied(const CaseCollection& collection) {
  std::string varied;
  for (const auto& axis : collection.axes) {
    if (axis.labels.size() < 2) continue;
    varied += (varied.empty() ? "" : "; ") + escaped(axis.name) + ": ";
    for (std::size_t i = 0; i < axis.labels.size(); ++i)
      varied += (i ? " | " : "") + readable(axis.labels[i]);
  }
  return varied.empty() ? ""
                        : paragraph("That is the first of " + std::to_string(collection.planned) +
                                    " cases, in which these are varied: " + varied + ".");
}

std::string which_mesh(const std::vector<StudyCurve>& curves) {
  if (curves.empty() || curves.front().last().other_spacings.empty()) return "";
  return note("Results are those of the finest mesh (" +
              in_units(curves.front().last().interface_spacing, Dimension::length) +
              " at the interface); the coarser ones serve to tell its error.");
}

/// Groups whose cases were loaded and unloaded only. Loading before a motion has too few steps to be set
/// beside Hertz.
CaseCollection only_pressed(const CaseCollection& collection) {
  CaseCollection pressed = collection;
  auto& groups = pressed.groups;
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [](const CaseGroup& group) { return mode_of(group.first()) != nullptr; }),
               groups.end());
  return pressed;
}

/// Empty without any.
std::string pressed_sections(const CaseCollection& pressed, SectionPainter& painter) {
  if (pressed.groups.empty()) return "";
  const Comparison comparison = compare_with_hertz(pressed, tolerance);
  const std::vector<StudyCurve> curves = curves_of(pressed, comparison);
  std::string body = study_verdict(pressed, curves) + which_mesh(curves);
  body += section_html("Against Hertz", load_figures(curves));
  const std::string dependence = roughness_dependence_figures(curves), surfaces = surfaces_table(curves);
  if (!(dependence + surfaces).empty()) body += section_html("RMS and spectrum", surfaces + dependence);
  body += section_html("Stiffness, load by load", stiffness_table(curves));
  body += section_html("Contact and pressure, load by load", contact_table(curves));
  body += section_html("What stays behind, and what a fit would report", imprint_and_fit_table(curves));
  body += section_html("The contacts in pictures", gallery(curves, painter));
  return body;
}

/// The paper's numbers, where they lie beside the program's sources.
std::optional<Published> published_numbers() {
  const fs::path folder = ASPERITY_RUNS "/paper/published";
  if (!fs::exists(folder)) return std::nullopt;
  return read_published(folder);
}

}  // namespace

StudyReport study_report(const fs::path& folder, SectionPainter& painter) {
  const CaseCollection collection = collect_cases({folder});
  const std::string title =
      collection.title.empty() || collection.title == "untitled" ? "Study" : collection.title;
  StudyReport report;
  std::string body;
  if (!collection.groups.empty())
    body += paragraph(what_was_asked(collection.groups.front().first())) + what_is_varied(collection);
  body += missing_html(collection) + doubt_html(collection);
  if (collection.groups.empty()) {
    report.page = page_html(title, subtitle_of(folder, ""), body);
    return report;
  }
  ResistanceFindings findings = find_resistances(collection);
  if (!findings.empty()) {
    if (const auto published = published_numbers())
      findings.published = against_published(findings.study, findings.trends, *published);
    body += resistance_verdict(findings) + resistance_sections(findings);
    report.files["resistance.csv"] = resistance_csv(findings.study);
    report.files["resistance.json"] = resistance_json(findings).dump(1) + "\n";
  }
  const CaseCollection pressed = only_pressed(collection);
  body += pressed_sections(pressed, painter);
  const SolvedCase& first = collection.groups.front().first();
  body += section_html("How far to trust it, and what it cost",
                       (pressed.groups.empty() ? note(worst_balance_sentence(collection)) : "") +
                           case_list(collection) +
                           details_html("First case: mesh, cost, versions", remaining_tables(first)));
  body += section_html("What went in", note("Of the first case:") + inputs_table(first));
  report.page = page_html(title, subtitle_of(folder, first.version()), body);
  return report;
}

}  // namespace asperity::report
