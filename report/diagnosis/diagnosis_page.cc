#include "report/diagnosis/diagnosis_page.h"

#include <cmath>
#include <ctime>

#include "core/printed.h"
#include "report/diagnosis/diagnosis_figures.h"
#include "report/page/axis.h"
#include "report/page/page.h"

namespace asperity::report {
namespace {

std::string number(double value, int digits = 3) {
  // Whole numbers up to a million are written out.
  const double size = std::abs(value);
  return size >= std::pow(10, digits) && size < 1e6 ? printed("%.0f", value) : printed("%.*g", digits, value);
}

std::string with_unit(double value, const std::string& unit, int digits = 3) {
  const DisplayUnit display = display_unit(unit, std::abs(value));
  return number(value / display.factor, digits) + (unit.empty() ? "" : " " + escaped(display.name));
}

std::string percent(double share) {
  return share > 0.995 ? "> 99 %" : share < 0.005 ? "< 1 %" : number(100 * share, 2) + " %";
}

std::string kind_words(EffectKind kind) {
  return kind == EffectKind::contact ? "physics of the contact" : "physics of the measurement (instrument)";
}

std::string headline(const Diagnosis& d) {
  switch (d.verdict) {
    case Verdict::no_mismatch:
      return "No mismatch: what is left is noise";
    case Verdict::explained:
      return "Explained: the simulation left out something, and it is named";
    case Verdict::partly_explained:
      return "Partly explained: something is named, and structure remains";
    case Verdict::ambiguous:
      return d.left_out.empty() ? "Ambiguous: what fits could not be solved to its end"
                                : "Ambiguous: several explanations do as well on these data";
    case Verdict::unexplained:
      return "Unexplained: there is a mismatch, and nothing in the catalogue explains it";
  }
  return "";
}

std::string interval(const DiagnosedParameter& p) {
  return with_unit(p.value, p.unit) + " (95 %: " + with_unit(p.low, p.unit) + " to " +
         with_unit(p.high, p.unit) + ")";
}

/// What the recording was set against, and which entries the corrected case has.
std::string simulation_words(const Diagnosis& d) {
  const SolvedSimulation& simulation = d.simulation;
  const auto corrected = d.corrected();
  std::string text = "The simulation is the case itself, solved by finite elements (" +
                     std::to_string(simulation.solves) + " solutions); " + escaped(simulation.off_by()) +
                     " (mesh and load steps), which is a part of the evidence.";
  if (!corrected.empty()) text += " In corrected.prm:";
  for (const auto& e : corrected)
    text += " " + escaped(e.entry) + " = " + escaped(e.written()) + " (" + escaped(e.interval()) + ").";
  return text;
}

std::vector<std::string> verdict_sentences(const Diagnosis& d) {
  std::vector<std::string> list{escaped(d.in_words)};
  if (d.simulation.by_finite_elements) list.push_back(simulation_words(d));
  for (const auto& effect : d.left_out) {
    std::string text =
        "<b>" + escaped(effect.title) + "</b> (" + kind_words(effect.kind) + "): " + escaped(effect.meaning);
    for (const auto& p : effect.parameters)
      text += " " + escaped(channel_words(p.name)) + " " + interval(p) + ".";
    list.push_back(text);
  }
  if (d.verdict == Verdict::ambiguous && !d.left_out.empty() && !d.alternatives.empty() &&
      !d.alternatives.front().told_apart_by.empty())
    list.push_back("What would tell them apart: " + escaped(d.alternatives.front().told_apart_by) + ".");
  return list;
}

std::string tiles(const Diagnosis& d) {
  const bool improved = !d.left_out.empty();
  std::vector<Tile> list;
  const auto arrow = [&](double before, double after) {
    return number(before) + (improved ? " → " + number(after) : "");
  };
  list.push_back(
      {arrow(d.baseline.chi2_reduced, d.improved.chi2_reduced), "chi-square per sample", "1 is noise alone"});
  list.push_back({arrow(d.baseline.held_out_chi2_reduced, d.improved.held_out_chi2_reduced),
                  "the same, predicted", "on data kept out of the fit"});
  for (const auto& [channel, noise] : d.noise)
    list.push_back({with_unit(noise.value, noise.unit, 2), "noise of one sample of " + channel_words(channel),
                    "from: " + noise.from});
  if (improved)
    list.push_back({percent(d.left_out.front().probability), "probability of what is named",
                    "among the explanations compared"});
  return tiles_html(list);
}

std::string region_table(const std::vector<MismatchRegion>& regions) {
  Table table{{"segment", "where", "from", "to", "mean size [noise]", "p-value", "share of the mismatch"}};
  for (const auto& r : regions)
    table.rows.push_back({escaped(r.segment.empty() ? "all" : r.segment), escaped(channel_words(r.variable)),
                          with_unit(r.from, r.unit), with_unit(r.to, r.unit), number(r.size_in_noise, 2),
                          r.p_value < 1e-6 ? "< 1e-6" : number(r.p_value, 2), percent(r.share)});
  return table_html(table);
}

std::string where_section(const Diagnosis& d) {
  if (d.mismatch.empty())
    return section_html(
        "Where they part",
        paragraph("Nowhere: no part of the recording departs from the simulation by more than noise does."));
  std::string body = paragraph(
      "Each row is a stretch of the data in which the simulation alone is off by more than noise. The "
      "p-value is the probability that noise alone departs as much anywhere; the share is how much of the "
      "whole excess lies there (stretches of several segments add up).");
  body += region_table(d.mismatch);
  return section_html("Where they part", body);
}

std::string effect_section(const DiagnosedEffect& effect) {
  std::string body = "<h3>" + escaped(effect.title) + " <code>" + escaped(effect.id) + "</code></h3>" +
                     paragraph(escaped(effect.meaning));
  body += paragraph("Equation: <code>" + escaped(effect.equation) +
                    "</code><br>Source: " + escaped(effect.source) + "<br>Kind: " + kind_words(effect.kind) +
                    "<br>Probability: " + percent(effect.probability));
  if (effect.parameters.empty()) return body + paragraph("It has no parameter of its own.");
  Table table{{"parameter", "value", "95 % interval"}};
  for (const auto& p : effect.parameters)
    table.rows.push_back({escaped(channel_words(p.name)), with_unit(p.value, p.unit, 4),
                          with_unit(p.low, p.unit, 4) + " to " + with_unit(p.high, p.unit, 4)});
  return body + table_html(table);
}

std::string nothing_named_words(Verdict verdict) {
  switch (verdict) {
    case Verdict::no_mismatch:
      return "Nothing that these data can show.";
    case Verdict::ambiguous:
      return "Nothing is named: what fits stands under the other explanations, and no solution of the case "
             "confirms it yet.";
    default:
      return "Nothing of the catalogue: no effect, and no few of them together, brings the residuals down to "
             "noise.";
  }
}

std::string left_out_section(const Diagnosis& d) {
  std::string body;
  for (const auto& effect : d.left_out) body += effect_section(effect);
  if (d.left_out.empty()) body = paragraph(nothing_named_words(d.verdict));
  return section_html(d.verdict == Verdict::ambiguous && !d.left_out.empty()
                          ? "What was left out, if the likeliest is right"
                          : "What was left out",
                      body);
}

Beside beside_simulation(const Diagnosis& d) {
  return !d.left_out.empty()  ? Beside::what_was_left_out
         : !d.nearest.empty() ? Beside::nearest
                              : Beside::nothing;
}

Table fits_table(const Diagnosis& d) {
  const Beside beside = beside_simulation(d);
  const FitQuality& other = beside == Beside::nearest ? d.with_nearest : d.improved;
  Table table{{"", "simulation alone"}};
  if (beside != Beside::nothing)
    table.head.push_back(beside == Beside::nearest ? "with the nearest, not named"
                                                   : "with what was left out");
  const auto row = [&](const std::string& name, const std::string& before, const std::string& after) {
    std::vector<std::string> cells{name, before};
    if (beside != Beside::nothing) cells.push_back(after);
    table.rows.push_back(cells);
  };
  row("chi-square per sample, in the fit", number(d.baseline.chi2_reduced), number(other.chi2_reduced));
  row("chi-square per sample, kept out of the fit", number(d.baseline.held_out_chi2_reduced),
      number(other.held_out_chi2_reduced));
  for (const auto& [channel, rms] : d.baseline.rms) {
    const auto after = other.rms.find(channel);
    row("RMS residual of " + channel_words(channel), with_unit(rms, unit_of_channel(channel)),
        after == other.rms.end() ? "" : with_unit(after->second, unit_of_channel(channel)));
  }
  return table;
}

/// What fits best and is not named, with its numbers.
std::string nearest_words(const Diagnosis& d) {
  std::string text = "The nearest that the catalogue has:";
  for (const auto& effect : d.nearest) {
    text += (&effect == &d.nearest.front() ? " " : "; ") + ("<b>" + escaped(effect.title) + "</b>");
    for (const auto& p : effect.parameters)
      text += ", " + escaped(channel_words(p.name)) + " " + with_unit(p.value, p.unit);
  }
  return text + ". It leaves more than noise, so that neither its names nor its numbers are an answer.";
}

std::string better_section(const Diagnosis& d) {
  const Beside beside = beside_simulation(d);
  const bool improved = beside == Beside::what_was_left_out;
  std::string body = beside == Beside::nearest ? paragraph(nearest_words(d)) : "";
  body += table_html(fits_table(d));
  for (const auto& compared : d.compared) {
    if (d.compared.size() > 1) body += "<h3>" + escaped(compared.table) + "</h3>";
    body += response_figure(compared, beside);
    const double limit = residual_limit(compared);
    std::vector<std::string> figures{
        residual_figure(compared, compared.before, d.mismatch,
                        beside == Beside::nothing ? "Residual" : "Residual of the simulation alone", limit)};
    if (beside != Beside::nothing)
      figures.push_back(residual_figure(
          compared, compared.after, improved ? d.remaining : std::vector<MismatchRegion>{},
          improved ? "Residual with what was left out" : "Residual with the nearest, not named", limit));
    body += side_by_side(figures);
  }
  return section_html(improved ? "How much better the fit is" : "Recording and simulation", body);
}

std::string alternatives_section(const Diagnosis& d) {
  if (d.alternatives.empty()) return "";
  Table table{{"explanation", "probability", "chi-square, kept out", "what would tell it from the first"}};
  for (const auto& a : d.alternatives) {
    std::string names;
    for (const auto& effect : a.effects) {
      names += (names.empty() ? "" : " + ") + escaped(effect.id);
      for (const auto& p : effect.parameters)
        names += "<br>" + escaped(channel_words(p.name)) + " " + interval(p);
    }
    table.rows.push_back({names, d.left_out.empty() ? "not confirmed" : percent(a.probability),
                          number(a.held_out_chi2_reduced), escaped(a.told_apart_by)});
  }
  return section_html("Other explanations",
                      paragraph("Each was fitted to the same data; the probability weighs how well it fits "
                                "against how much it may choose.") +
                          table_html(table));
}

std::string remaining_section(const Diagnosis& d) {
  if (d.remaining.empty() || d.left_out.empty()) return "";
  return section_html(
      "What still remains",
      paragraph("With what is named, these stretches are still not noise.") + region_table(d.remaining));
}

std::string how_section(const Diagnosis& d) {
  std::string remarks;
  for (const auto& remark : d.remarks) remarks += "<li>" + escaped(remark) + ".</li>";
  std::string body = remarks.empty() ? "" : "<ul>" + remarks + "</ul>";
  for (const auto& p : d.calibrated)
    body += paragraph("Calibrated before any physics was added: " + escaped(channel_words(p.name)) + " = " +
                      interval(p) + ".");
  body += details_html(
      "How this was found",
      "<p>The simulation is driven by the recorded control and calibrated where the recording allows it. Its "
      "residuals are tested against simulated noise of the same standard deviation and correlation. Every "
      "effect of the catalogue that such data can show, then pairs and, where structure remains, sets of "
      "three, are fitted within physical bounds with parameters shared by all segments and runs. They are "
      "compared by evidence (Schwarz' criterion) and by predicting blocks of data kept out of the fit; each "
      "member of a set must earn its place. A last test asks whether what remains is noise, up to 5 to 30 % "
      "of the effect's own contribution, which is what published laws of the same physics differ by.</p>");
  return section_html("How sure one can be", body);
}

/// Its material, or else its modulus.
std::string body_words(const RecordedBody& body) {
  return body.material.empty() ? "a body of " + with_unit(body.youngs_modulus, "Pa") : escaped(body.material);
}

std::string subtitle(const Recording& recording) {
  const std::time_t now = std::time(nullptr);
  char date[64];
  std::strftime(date, sizeof date, "asperity diagnose, written %Y-%m-%d %H:%M", std::localtime(&now));
  return "mode " + name_of(recording.mode) + ", particle of radius " +
         with_unit(recording.particle.radius, "m") + " (" + body_words(recording.particle) + ") on " +
         body_words(recording.substrate) + " · " + date;
}

}  // namespace

std::string diagnosis_page(const Recording& recording, const Diagnosis& d) {
  std::string body = verdict_html(headline(d), verdict_sentences(d));
  body += tiles(d);
  body += where_section(d);
  body += left_out_section(d);
  body += better_section(d);
  body += remaining_section(d);
  body += alternatives_section(d);
  body += how_section(d);
  return page_html("Diagnosis: " + escaped(recording.title.empty() ? "recording" : recording.title),
                   subtitle(recording), body);
}

}  // namespace asperity::report
