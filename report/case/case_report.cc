#include "report/case/case_report.h"

#include <cctype>
#include <cmath>
#include <ctime>

#include "dem_compare/compare/comparison.h"
#include "report/curves/curves.h"
#include "report/fields/surface_maps.h"
#include "report/motion/motion_figures.h"
#include "report/motion/motion_lead.h"
#include "report/page/axis.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/result/result_tables.h"
#include "report/sentences/hertz_words.h"
#include "results/energy_balance.h"

namespace asperity::report {
namespace {

namespace fs = std::filesystem;

std::vector<Tile> tiles_of(const GroupNumbers& numbers) {
  const Hertz& hertz = numbers.hertz;
  const double force = numbers.force;
  const auto against = [](double value, double reference) {
    return value > 2 * reference ? departure_text(value / reference) + " Hertz's"
                                 : departure_text(value / reference) + " against Hertz";
  };
  constexpr double kN_per_m = 1e3, um = 1e-6;
  std::vector<Tile> tiles{{in_units(force, Dimension::force), "largest normal force",
                           "approach " + in_units(numbers.approach.mean, Dimension::length) + ", " +
                               against(numbers.approach.mean, hertz.approach(force))},
                          {in_units(numbers.loading_stiffness, kN_per_m, "kN/m"), "normal stiffness, loading",
                           against(numbers.loading_stiffness.mean, hertz.normal_stiffness(force))}};
  if (std::isfinite(numbers.unloading_stiffness.mean))
    tiles.push_back({in_units(numbers.unloading_stiffness, kN_per_m, "kN/m"),
                     "normal stiffness, start of unloading",
                     against(numbers.unloading_stiffness.mean, hertz.normal_stiffness(force))});
  tiles.push_back({area_text(numbers.contact_area.mean), "real contact area",
                   against(numbers.contact_area.mean, hertz.contact_area(force))});
  tiles.push_back({in_units(numbers.largest_pressure.mean, Dimension::pressure), "largest contact pressure",
                   against(numbers.largest_pressure.mean, hertz.peak_pressure(force))});
  if (std::isfinite(numbers.residual_imprint.mean))
    tiles.push_back(numbers.plastic_volume.mean == 0
                        ? Tile{"none", "imprint left after unloading", "nothing has yielded"}
                        : Tile{imprint_text(numbers.residual_imprint.mean), "imprint left after unloading",
                               numbers.residual_imprint.mean > 0
                                   ? "approach that has not come back"
                                   : "not significant beside the error of the computation"});
  if (std::isfinite(numbers.fitted_radius.mean))
    tiles.push_back({in_units(numbers.fitted_radius, um, "µm"), "radius a Hertz fit would report",
                     "the sphere has " + in_units(hertz.radius, Dimension::length)});
  return tiles;
}

std::string state_warning(const SolvedCase& solved) {
  if (solved.finished()) return "";
  const auto& force = solved.history.normal_force;
  return "<div class='warning'><b>This case is not finished.</b> Shown is what was accepted so far: " +
         std::to_string(force.size()) + " steps, the last at " +
         (force.empty() ? "no load" : in_units(force.back(), Dimension::force)) +
         ". <code>asperity solve … --resume</code> goes on with it.</div>\n";
}

std::string energy_warning(const SolvedCase& solved) {
  if (!is_energy_flagged(solved)) return "";
  return "<div class='warning'><b>The energy of this case does not balance.</b> " +
         escaped(open_energy_words(solved)) + ".</div>\n";
}

std::vector<std::string> trust_sentences(const SolvedCase& solved, const GroupComparison& group) {
  std::vector<std::string> sentences;
  const double yield = solved.first_yield_force();
  if (solved.relaxes())
    sentences.push_back(
        "Bodies relax with time: Hertz' curves are those of fast loading, and what departs from them depends "
        "on "
        "how fast the contact was loaded.");
  else if (!solved.is_rough() && group.numbers.force < yield)
    sentences.push_back(
        "Smooth bodies below their first yield (" +
        (std::isinf(yield) ? std::string("these cannot yield") : in_units(yield, Dimension::force)) +
        ") must follow Hertz: what departs here is the error of the computation.");
  else if (std::isfinite(yield))
    sentences.push_back("Without roughness these bodies would first yield at " +
                        in_units(yield, Dimension::force) + ", below the surface.");
  const std::string spacing =
      std::isfinite(group.interface_spacing)
          ? " (spacing " + in_units(group.interface_spacing, Dimension::length) + " at the interface)"
          : "";
  sentences.push_back(std::string("Error of the mesh: ") +
                      (solved.finished() ? "estimated beside each effective quantity (± sd)"
                                         : "estimated when the case is finished") +
                      spacing +
                      "; the same case on another spacing, compared by <code>asperity compare</code>, "
                      "measures it. Scatter over realisations: none, "
                      "this is one surface; a study with several seeds gives it.");
  for (const char* body : {"particle", "substrate"}) {
    const std::string resolved = resolved_roughness_sentence(solved, body);
    if (!resolved.empty()) sentences.push_back(resolved);
  }
  if (group.numbers.differencing_error > 0)
    sentences.push_back("The finite load steps change the stiffness by at most " +
                        percent_bound(group.numbers.differencing_error) + ".");
  if (solved.finished() && solved.result->reaches_rim)
    sentences.push_back(
        "<b>The contact reached the rim of the finely meshed region:</b> what lies beyond it is missing; "
        "solve again "
        "with a larger Mesh/Contact region.");
  const std::string balance = balance_sentence(solved);
  if (!balance.empty()) sentences.push_back(balance);
  return sentences;
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string curves_section(const SolvedCase& solved, const NormalNumbers& numbers) {
  return section_html(
      "Load against approach",
      figure_html("", to_svg(load_approach_chart(solved)),
                  "How far the bodies come together under a growing force, and while unloading. The dashed "
                  "line is Hertz's law for "
                  "the same bodies, smooth and elastic. A rough contact starts softer, because at first only "
                  "the highest "
                  "asperities carry; later it runs nearly parallel to Hertz's curve. If unloading does not "
                  "return on the loading curve, material "
                  "has yielded; where it meets the axis is the imprint that stays.") +
          side_by_side(
              {figure_html("Stiffness", to_svg(stiffness_chart(solved, numbers)),
                           "The slope of the curve above: how much force one more nanometre takes. Bars "
                           "bound the error that the "
                           "finite load steps make. The black point, where there is one, is the elastic "
                           "stiffness that the solver itself finds there. This is what a discrete "
                           "element simulation needs as k<sub>n</sub>."),
               figure_html("Real contact area", to_svg(contact_area_chart(solved)),
                           "The area that truly touches. Between rough surfaces it is smaller than Hertz's "
                           "circle; on unloading it "
                           "stays larger where asperities were flattened.")}));
}

/// Columns that files of their own have added.
std::string added_columns_section(const SolvedCase& solved) {
  std::vector<std::string> figures;
  for (std::size_t k = 0; k < solved.history.added.size(); ++k) {
    const AddedValues& column = solved.history.added[k];
    figures.push_back(figure_html(column.name, to_svg(added_column_chart(solved, column)),
                                  escaped(solved.result->added_columns[k].meaning)));
  }
  return figures.empty() ? "" : section_html("Further columns of the history", side_by_side(figures));
}

std::vector<std::string> joined(std::vector<std::string> sentences, const std::vector<std::string>& more) {
  sentences.insert(sentences.end(), more.begin(), more.end());
  return sentences;
}

std::string tables_of(const SolvedCase& solved, const GroupComparison& group, const NormalNumbers& numbers) {
  std::string body =
      section_html("Against Hertz, load by load",
                   ratio_table(group) +
                       note("Each number is the computed value over Hertz's for the same smooth, elastic "
                            "bodies: 1 is Hertz. "
                            "The force ratio at equal approach depends on where approach is counted from; "
                            "the stiffness ratio at equal load does not."));
  body += section_html("What a fit would report", fit_table(numbers, solved.hertz().radius));
  const std::string effective = effective_table(solved);
  if (!effective.empty()) body += section_html("Effective quantities in result.json", effective);
  body +=
      section_html("How far to trust it, and what it cost", balance_table(solved) + remaining_tables(solved));
  return body + section_html("What went in", inputs_table(solved));
}

}  // namespace

std::string subtitle_of(const fs::path& folder, const std::string& version) {
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d %H:%M", std::localtime(&now));
  std::string text = "asperity report of " +
                     escaped(fs::absolute(folder).lexically_normal().filename().string()) + ", written " +
                     date;
  if (!version.empty()) text += ", computed by asperity " + escaped(version);
  return text;
}

std::string case_report_html(const fs::path& folder, SectionPainter& painter) {
  const CaseCollection collection = collect_cases({folder}, RefusedCases::shown);
  const Comparison comparison = compare_with_hertz(collection, tolerance);
  const SolvedCase& solved = collection.groups.front().first();
  const NormalNumbers& numbers = collection.groups.front().numbers.front();
  const GroupComparison& group = comparison.groups.front();

  std::string body = paragraph(what_was_asked(solved));
  body += state_warning(solved) + energy_warning(solved);
  const std::vector<std::string> trust = trust_sentences(solved, group);
  const std::string pressed = capitalised(readable(verdict_against_hertz(group, tolerance)));
  const std::optional<MotionLead> motion = motion_lead(solved);
  if (is_energy_refused(solved)) {
    body +=
        verdict_html("No verdict: its energy does not balance. What follows shows where it went wrong", {});
  } else if (motion) {
    body += verdict_html(motion->headline, joined(motion->sentences, trust)) + tiles_html(motion->tiles);
  } else {
    body += verdict_html(pressed, trust) + tiles_html(tiles_of(group.numbers));
  }
  if (motion) body += motion_figure(solved);
  if (motion && !is_energy_refused(solved))
    body +=
        section_html("Pressed, before it moved", paragraph(pressed) + tiles_html(tiles_of(group.numbers)));
  if (solved.is_rough()) body += section_html("The surfaces", roughness_figures(solved));
  body += curves_section(solved, numbers);
  if (!motion) body += motion_figure(solved);
  body += added_columns_section(solved);
  body += section_html("Pressure and gap in the contact",
                       contact_figures(solved) + added_contact_figures(solved));
  body += section_html("Inside the bodies", section_figures(solved, painter));
  body += tables_of(solved, group, numbers);
  return page_html(solved.title(), subtitle_of(folder, solved.version()), body);
}

}  // namespace asperity::report
