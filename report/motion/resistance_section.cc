#include "report/motion/resistance_section.h"

#include "report/motion/resistance_charts.h"
#include "report/motion/resistance_tables.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/sentences/phrases.h"
#include "report/sentences/resistance_answers.h"

namespace asperity::report {
namespace {

std::string list_html(const std::vector<std::string>& sentences) {
  std::string html = "<ul>";
  for (const auto& sentence : sentences) html += "<li>" + readable(sentence) + "</li>";
  return sentences.empty() ? "" : html + "</ul>\n";
}

bool moves(const MovingStudy& study, const MotionMode& mode) {
  for (const auto& contact : study.contacts)
    if (!contact.of(mode).empty()) return true;
  return false;
}

/// A figure with two points or more.
std::string figure(const std::string& title, const Chart& chart, const std::string& explanation) {
  std::size_t points = 0;
  for (const auto& series : chart.series) points += series.x.size();
  return points < 2 ? "" : figure_html(title, to_svg(chart), explanation);
}

std::string figures_over_load(const MovingStudy& study, const MotionMode& mode) {
  const std::string bars = " Bars are standard deviations.";
  if (&mode == &sliding_mode())
    return figure("Sliding resistance over load", resistance_over_load(study, mode, ResistanceUnit::load),
                  "Level lines are Amontons' law. Lines that rise towards small loads have an offset h, as "
                  "adhesion gives." +
                      bars);
  std::vector<std::string> figures{
      figure(
          "Over the contact radius", resistance_over_load(study, mode, ResistanceUnit::contact),
          "Level lines mean that the moment follows the contact radius, λ = a (Hertz' for smooth bodies)." +
              bars),
      figure("Over the particle's radius", resistance_over_load(study, mode, ResistanceUnit::particle),
             "The same moments. Level lines mean that they follow the particle's radius, λ = r; spheres of "
             "several radii then lie on one." +
                 bars)};
  if (&mode == &torsion_mode()) {
    const Chart coulomb = resistance_over_load(study, mode, ResistanceUnit::coulomb);
    if (!coulomb.series.empty())
      figures.push_back(
          figure("Over that of smooth bodies", coulomb,
                 "1 is full slip of Hertz' pressure with the local friction that went in." + bars));
  }
  return side_by_side(figures);
}

std::string rms_figures(const ResistanceFindings& findings) {
  std::vector<std::string> figures;
  for (const auto& trend : findings.trends) {
    const TrendAtLoad& middle = trend.loads[trend.loads.size() / 2];
    const std::string name = motion_name(*trend.mode, true);
    figures.push_back(
        figure(name + " resistance over roughness", resistance_over_rms(trend, findings.published),
               "One line per load; surfaces of one spectrum, scaled. Bars are standard deviations."));
    figures.push_back(figure(name + ": dissipation by mechanism", parts_over_rms(trend, middle),
                             "Dissipated per path length by each mechanism, at " +
                                 in_units(middle.load, Dimension::force) +
                                 ". What rises or falls here makes the whole rise or fall."));
  }
  return figures.empty() ? "" : side_by_side(figures);
}

std::string motion_section(const MovingStudy& study, const MotionMode& mode) {
  if (!moves(study, mode)) return "";
  const bool slides = &mode == &sliding_mode();
  std::string explanation =
      say("Resistance is the energy dissipated per {} along the steady part of the first pass, over surfaces "
          "not passed before. The conservative topographic part gives back what it takes, so the mean {} of "
          "a short path is mostly its own; over a long one both agree. ± holds the scatter of blocks of the "
          "path (block averaging) and of realisations, and what the energy balance leaves open. Slip, "
          "{} and bonds (opened with more work than they gave when closing) are their shares.",
          {slides ? "path length" : "angle", slides ? "force" : "moment", bodies_dissipate_by(study)});
  if (&mode == &rolling_mode())
    explanation +=
        " The discretisation itself shows moments of up to 5·10⁻⁴ P a on smooth elastic bodies "
        "(rolling_noise_floor in result.json); they come and go, and dissipate nothing.";
  return section_html(motion_name(mode, true) + ": dissipation by mechanism",
                      figures_over_load(study, mode) + resistance_table(study, mode) + note(explanation));
}

}  // namespace

std::string resistance_verdict(const ResistanceFindings& findings) {
  const ResistanceAnswers said = answers(findings);
  std::vector<std::string> sentences;
  for (const auto* list : {&said.length, &said.roughness})
    for (const auto& sentence : *list) sentences.push_back(readable(sentence));
  return verdict_html(readable(said.headline), sentences);
}

std::string resistance_sections(const ResistanceFindings& findings) {
  const ResistanceAnswers said = answers(findings);
  std::string html = section_html(
      "Two questions, and how far these cases answer them",
      paragraph(
          "Fuchs, Weinhart et al. (2014) could not decide whether rolling and torsion resistance, M = µ λ (f "
          "+ h), follow the particle's radius (λ = r) or that of the contact (λ = a): at a given particle "
          "the first grows with the load as P, the second as P<sup>4/3</sup>; at a given load the first with "
          "the radius as R, the second as R<sup>1/3</sup>. Nor why their rolling friction fell and their "
          "sliding friction rose with roughness. Statements are made at two standard deviations (exponents "
          "against a law: three); where they do not suffice, it says that the answer is not identifiable.") +
          exponent_table(findings));
  for (const MotionMode* mode : all_motions()) html += motion_section(findings.study, *mode);
  if (!said.rails.empty())
    html += section_html("On a rail: rolling and spinning at once",
                         list_html(said.rails) + rail_table(findings.study));
  const std::string roughness = rms_figures(findings) + trend_table(findings);
  if (!roughness.empty()) html += section_html("With roughness", roughness);
  if (!findings.contributions.empty())
    html += section_html("With a mechanism switched off",
                         list_html(said.mechanisms) + contribution_table(findings));
  if (!findings.inputs.empty())
    html += section_html("With other inputs: local friction, works of adhesion, yield stresses",
                         input_table(findings));
  if (!said.mesh.empty()) html += section_html("With another mesh", list_html(said.mesh));
  if (!said.measurement.empty())
    html += section_html("Beside the measurement", list_html(said.measurement) + measurement_table(findings));
  if (!said.care.empty()) html += section_html("To be taken with care", list_html(said.care));
  return html;
}

}  // namespace asperity::report
