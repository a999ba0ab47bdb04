#include "report/motion/resistance_tables.h"

#include <cmath>
#include <limits>

#include "core/printed.h"
#include "dem_compare/cases/path_averages.h"
#include "report/page/display_units.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

std::string cell(const Uncertain& number) { return std::isfinite(number.value) ? number_text(number) : "–"; }

std::string share_of(const Uncertain& part, const Uncertain& whole) {
  return cell(ratio(part, {whole.value, 0}) * per_cent);
}

std::string rounded(double value, int digits = 3) {
  return std::isfinite(value) ? printed("%.*g", digits, value) : "–";
}

/// Of the first passes.
double shortest_path(const std::vector<MovingCase>& cases) {
  double path = std::numeric_limits<double>::infinity();
  for (const auto& item : cases) path = std::min(path, item.path_in_radii);
  return path;
}

}  // namespace

std::string resistance_table(const MovingStudy& study, const MotionMode& mode) {
  const bool slides = &mode == &sliding_mode(), spins = &mode == &torsion_mode();
  Table table{{"contact", "load", "realisations", slides ? "resistance [µN]" : "resistance [pN m]",
               slides ? "over load" : "over P a"}};
  if (!slides) table.head.emplace_back("over P r");
  if (!mode.has_length || spins) table.head.emplace_back(slides ? "over µ P" : "over 3π/16 µ P a");
  for (const std::string& head : {std::string("slip"), bodies_dissipate_by(study), std::string("bonds")})
    table.head.push_back(head + " [%]");
  table.head.emplace_back(slides ? "mean force [µN]" : "mean moment [pN m]");
  table.head.emplace_back("fluctuates by (sd)");
  for (const char* head : {"balance open [%]", spins ? "path [rad]" : "path [contact radii]",
                           "second pass over first", "real area over Hertz"})
    table.head.emplace_back(head);
  for (const auto& contact : study.contacts)
    for (const auto* state : contact.of(mode)) {
      const double unit = slides ? uN : pN_m;
      std::vector<std::string> row{readable(contact.label), in_units(state->load, Dimension::force),
                                   std::to_string(state->cases.size()), cell(state->resistance * (1 / unit)),
                                   cell(state->resistance * (1 / state->scale()))};
      if (!slides) row.push_back(cell(state->resistance * (1 / (state->load * contact.bodies.radius))));
      if (!mode.has_length || spins) row.push_back(cell(state->resistance * (1 / state->coulomb)));
      for (const auto& part : {state->parts.friction, state->parts.plastic, state->parts.adhesion})
        row.push_back(share_of(part, state->parts.total));
      row.push_back(cell(state->force * (1 / unit)));
      row.push_back(rounded(state->fluctuation / unit));
      row.push_back(rounded(per_cent * std::abs(state->unbalanced) / std::abs(state->resistance.value), 2));
      row.push_back(rounded(shortest_path(state->cases)));
      row.push_back(cell(state->back_over_first));
      row.push_back(rounded(state->contact_area / (M_PI * state->hertz_radius * state->hertz_radius)));
      table.rows.push_back(std::move(row));
    }
  return table_html(table);
}

std::string rail_table(const MovingStudy& study) {
  Table table{{"contact", "inclination", "load", "resistance [pN m]", "slip [%]",
               bodies_dissipate_by(study) + " [%]", "bonds [%]", "M_ro cos + M_to sin [pN m]", "over it",
               "spin moment [pN m]", "over torsion alone", "path [contact radii]"}};
  for (const auto& contact : study.contacts)
    for (const auto& rail : contact.rails) {
      std::vector<std::string> row{readable(contact.label), rounded(rail.inclination * 180 / M_PI) + "°",
                                   in_units(rail.load, Dimension::force), cell(rail.resistance * (1 / pN_m))};
      for (const auto& part : {rail.parts.friction, rail.parts.plastic, rail.parts.adhesion})
        row.push_back(share_of(part, rail.parts.total));
      for (const auto& number :
           {rail.sum * (1 / pN_m), rail.over_sum(), rail.spin_moment * (1 / pN_m), rail.spin_over_torsion})
        row.push_back(cell(number));
      row.push_back(rounded(shortest_path(rail.cases)));
      table.rows.push_back(std::move(row));
    }
  return table.rows.empty()
             ? ""
             : table_html(table) +
                   note(
                       "A sphere that rolls along a rail spins on its flanks by tan(inclination) for each "
                       "angle it rolls. Resistance is dissipated per angle about the rail's transverse axis. "
                       "The paper takes it for the sum of rolling and torsion on their own; a contact that "
                       "rolls meets surface that has not slipped yet, so that it resists its spin with less "
                       "than full slip the shallower the rail.");
}

std::string exponent_table(const ResistanceFindings& findings) {
  Table table{{"motion", "contact", "moment grows with", "exponent", "λ = r: 1, off by", "λ = a: off by",
               "bonds along a smooth rim: off by"}};
  const auto off = [](double distance) {
    return std::isfinite(distance) ? rounded(std::abs(distance), 2) + " σ" : std::string("–");
  };
  for (const auto& answer : findings.lengths)
    for (const auto& exponent : answer.exponents) {
      const bool load = exponent.over == "load";
      table.rows.push_back({motion_name(*answer.mode), readable(load ? exponent.what : answer.contact),
                            load ? "load" : "radius, at " + readable(exponent.what),
                            cell(exponent.exponent.slope), off(exponent.from_radius()),
                            rounded(exponent.with_contact) + ", " + off(exponent.from_contact()),
                            std::isfinite(exponent.with_bonds)
                                ? rounded(exponent.with_bonds) + ", " + off(exponent.from_bonds())
                                : "–"});
    }
  return table.rows.empty()
             ? ""
             : table_html(table) +
                   note(
                       "Without an offset h, which makes the power of the load smaller. Bonds that cost Δw "
                       "more to open than they give dissipate 2 a r Δw per angle along the rim of a smooth "
                       "contact: a law that is neither. A dash: a moment is not known to be positive.");
}

std::string trend_table(const ResistanceFindings& findings) {
  if (findings.trends.empty()) return "";
  Table table{{"motion", "load", "resistance [% per nm]", "of it slip", bodies_dissipate_by(findings.study),
               "bonds", "mean force or moment [% per nm]"}};
  for (const auto& trend : findings.trends)
    for (const auto& at : trend.loads) {
      std::vector<std::string> row{motion_name(*trend.mode), in_units(at.load, Dimension::force)};
      for (const Trend* part : {&at.total, &at.friction, &at.plastic, &at.adhesion})
        row.push_back(share_of(per_nanometre(part->slope), at.total.mean));
      row.push_back(share_of(per_nanometre(at.force.slope), at.force.mean));
      table.rows.push_back(std::move(row));
    }
  return table_html(table) + note(
                                 "Slope of a straight line over the RMS, over the mean resistance. The parts "
                                 "add up to the whole.");
}

std::string contribution_table(const ResistanceFindings& findings) {
  if (findings.contributions.empty()) return "";
  Table table{{"what is switched off", "contact", "beside", "motion", "load", "change of resistance [%]",
               "of slip [%]", "of " + bodies_dissipate_by(findings.study) + " [%]", "of bonds [%]"}};
  for (const auto& one : findings.contributions) {
    // What switching off changes: the negative of the contribution.
    std::vector<std::string> row{name_of(one.mechanism), readable(one.with->label),
                                 readable(one.without->label), motion_name(*one.mode),
                                 in_units(one.load, Dimension::force)};
    for (const auto& part : {one.difference, one.parts.friction, one.parts.plastic, one.parts.adhesion})
      row.push_back(share_of(part * -1, one.whole));
    table.rows.push_back(std::move(row));
  }
  return table_html(table) +
         note(
             "The same surfaces, seed by seed, with a mechanism and without it. Switching yielding off also "
             "changes what slip takes, because the topography stays higher and the real contact is another; "
             "the last columns say so.");
}

std::string input_table(const ResistanceFindings& findings) {
  if (findings.inputs.empty()) return "";
  Table table{{"input", "contact", "beside", "its factor", "motion", "load", "power of the resistance"}};
  for (const auto& one : findings.inputs)
    table.rows.push_back({one.input, readable(one.larger->label), readable(one.smaller->label),
                          rounded(one.factor, 3), motion_name(*one.mode),
                          in_units(one.load, Dimension::force), cell(one.exponent)});
  return table_html(table) + note(
                                 "The same surfaces, seed by seed, with one input multiplied by a factor: 1 "
                                 "where the resistance is proportional to it, 0 where it does not matter. "
                                 "These inputs are choices of the cases, not results.");
}

std::string measurement_table(const ResistanceFindings& findings) {
  if (findings.published.magnitudes.empty() && findings.published.trends.empty()) return "";
  Table table{{"quantity", "contact", "load", "simulated", "measured", "simulated / measured", "apart by"}};
  const auto row = [&](const std::string& what, const std::string& contact, const std::string& load,
                       const Uncertain& simulated, const Uncertain& measured, double sigmas) {
    table.rows.push_back({what, contact, load, cell(simulated), cell(measured),
                          cell(ratio(simulated, measured)),
                          std::isfinite(sigmas) ? rounded(std::abs(sigmas), 2) + " σ" : "–"});
  };
  for (const auto& one : findings.published.trends)
    row(motion_name(*one.trend->mode) +
            (std::isnan(one.load) ? ": coefficient µ per nm of RMS" : ": per nm of RMS"),
        "all of the spectrum",
        std::isnan(one.load) ? "slope over loads" : in_units(one.load, Dimension::force), one.simulated * nm,
        one.measured * nm, one.sigmas());
  for (const auto& one : findings.published.magnitudes)
    row(motion_name(*one.mode) + (one.mode == &sliding_mode() ? ": F/P" : ": M/(P r)"),
        readable(one.contact->label + (one.indenter ? ", mean with " + one.indenter->label : "")),
        in_units(one.load, Dimension::force), one.simulated, one.measured, one.sigmas());
  return table_html(table) +
         note(
             "Fuchs, Weinhart et al. (2014), Table 2, where sphere, plane, RMS and load are the paper's. Its "
             "rolling numbers are means over two contacts of the sphere, silicon below and a diamond "
             "indenter above (so are the simulated magnitudes where the study rolled the indenter's contact, "
             "too): what roughness changes at the silicon is twice what the mean shows, and that is what "
             "stands here as measured trend; the magnitudes are the paper's means. At a load the measured "
             "rolling resistance is µ(1 + h/P), and h grows with roughness: below about 0.6 mN the "
             "resistance itself rises, and only the coefficient µ falls. The local friction of the "
             "simulations is an input: the size of sliding and torsion resistance follows from it, how they "
             "change with roughness does not.");
}

}  // namespace asperity::report
