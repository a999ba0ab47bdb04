#include "diagnosis/describe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/printed.h"
#include "diagnosis/choose/judged_sets.h"
#include "diagnosis/choose/law_shifts.h"
#include "diagnosis/fit/likely_surface.h"

namespace asperity {
namespace {

/// The interval with what laws and mesh may be off by in it: `by_laws` at 95 %, `by_mesh` one deviation.
DiagnosedParameter widened(DiagnosedParameter p, const FreeParameter& free, double by_laws, double by_mesh) {
  constexpr double two_sided_95 = 1.959964;
  const double model = std::hypot(by_laws, two_sided_95 * by_mesh);
  p.low = std::max(free.low, p.value - std::hypot(p.value - p.low, model));
  p.high = std::min(free.high, p.value + std::hypot(p.high - p.value, model));
  return p;
}

std::string titles(const std::vector<DiagnosedEffect>& effects) {
  std::string text;
  for (std::size_t i = 0; i < effects.size(); ++i)
    text += (i == 0 ? "" : i + 1 == effects.size() ? " and " : ", ") + effects[i].id;
  return text;
}

/// What each parameter would be off by if finite elements were off by what they state; in its unit. What
/// another surface changes is in the covariance already.
std::vector<double> shifts_by_mesh_errors(const FitProblem& problem, const ModelFit& fit) {
  std::vector<double> shifts(fit.values.size(), 0.0);
  if (!fit.explanation->correction()) return shifts;
  constexpr int steps = 6;
  const ModelFit at = refitted(problem, fit, problem.thin, false, steps);
  for (auto& explanation : off_by_mesh_errors(fit)) {
    ModelFit off = at;
    off.explanation = explanation;
    off = refitted(problem, off, problem.thin, false, steps);
    for (std::size_t k = 0; k < shifts.size(); ++k)
      shifts[k] = std::hypot(shifts[k], off.values[k] - at.values[k]);
  }
  return shifts;
}

}  // namespace

std::vector<DiagnosedEffect> described_effects(const FitProblem& problem, const ModelFit& fit,
                                               const ModelFit& baseline, double probability) {
  std::vector<DiagnosedEffect> list;
  const auto& effects = fit.explanation->effects();
  const double inflation =
      std::max(1.0, fit.cost / static_cast<double>(std::max<std::size_t>(1, fit.count))) *
      shared_variance(problem.samples, residual_beyond_surfaces(problem, fit), problem.noise);
  const ModelFit known = with_intervals(problem, fit);
  const std::vector<double> by_laws = half_widths_by_laws(problem, fit, baseline),
                            by_mesh = shifts_by_mesh_errors(problem, fit);
  // A pull-off force or a work of adhesion is known no better, even where a refit moves the range instead.
  const auto& correction = fit.explanation->correction();
  const double of_attraction = correction ? correction->attraction_error() : 0;
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const EffectDescription& d = effects[e]->description();
    DiagnosedEffect effect{d.id, d.title, d.equation, d.source, d.meaning, d.kind, probability, {}, {}, {}};
    for (std::size_t k = 0; k < fit.values.size(); ++k) {
      const FreeParameter& free = fit.explanation->parameters()[k];
      if (free.effect != static_cast<int>(e) || known.is_held(k)) continue;
      const DiagnosedParameter as_fitted = known.parameter(k, inflation);
      const bool is_size =
          d.kind == EffectKind::contact && (as_fitted.unit == "N" || as_fitted.unit == "J/m^2");
      const double own = is_size ? of_attraction : 0;
      effect.parameters.push_back(
          widened(as_fitted, free, by_laws[k], std::max(by_mesh[k], own * std::abs(as_fitted.value))));
    }
    list.push_back(effect);
  }
  return list;
}

bool is_described_as_no_effect(const FitProblem& problem, const ModelFit& fit, const ModelFit& baseline,
                               const std::vector<const Effect*>& known) {
  for (const DiagnosedEffect& effect : described_effects(problem, fit, baseline, 1)) {
    const Effect& of = effect_of(effect.id);
    if (std::find(known.begin(), known.end(), &of) != known.end()) continue;
    // The case's own value is one among others: its interval holds a mesh error that the evidence knows.
    if (of.is_another_value()) continue;
    for (const EffectParameter& admissible : of.parameters(problem.experiment))
      for (const DiagnosedParameter& p : effect.parameters)
        if (p.name == admissible.name && p.low <= admissible.no_effect && admissible.no_effect <= p.high)
          return true;
  }
  return false;
}

FitQuality quality_of(const FitProblem& problem, const ModelFit& fit, const HeldOut& held_out) {
  const std::vector<double> residual = fit.residual(problem.samples);
  FitQuality q;
  q.chi2_reduced = chi2_reduced(problem.samples, residual_beyond_surfaces(problem, fit), problem.noise);
  q.held_out_chi2_reduced = held_out.chi2_reduced;
  q.samples = fit.count;
  std::map<std::string, std::pair<double, double>> sums;
  for (const auto& run : problem.samples.runs)
    for (std::size_t i = run.begin; i < run.end; ++i)
      if (problem.samples.list[i].counts) {
        auto& [sum, count] = sums[problem.samples.response_channels[run.table]];
        sum += residual[i] * residual[i];
        ++count;
      }
  for (const auto& [channel, sum] : sums) q.rms[channel] = std::sqrt(sum.first / sum.second);
  return q;
}

std::map<std::string, NoiseEstimate> described_noise(const FitProblem& problem) {
  std::map<std::string, NoiseEstimate> noise;
  for (std::size_t t = 0; t < problem.samples.table_names.size(); ++t) {
    const std::string& channel = problem.samples.response_channels[t];
    if (noise.count(channel)) continue;
    std::vector<double> sd;
    for (const auto& run : problem.samples.runs)
      if (run.table == t)
        for (std::size_t i = run.begin; i < run.end; ++i) sd.push_back(problem.noise.sd[i]);
    std::nth_element(sd.begin(), sd.begin() + static_cast<long>(sd.size() / 2), sd.end());
    noise[channel] = {sd[sd.size() / 2], unit_of_channel(channel), problem.noise.from[t]};
  }
  return noise;
}

std::vector<ComparedTable> compared_tables(const Recording& recording, const FitProblem& problem,
                                           const ModelFit& before, const ModelFit& after) {
  std::vector<ComparedTable> tables;
  const auto simulated_before = before.simulate(problem.samples),
             simulated_after = after.simulate(problem.samples);
  for (std::size_t t = 0; t < problem.samples.table_names.size(); ++t) {
    ComparedTable table;
    table.table = problem.samples.table_names[t];
    table.channel = problem.samples.response_channels[t];
    table.unit = unit_of_channel(table.channel);
    const RecordingTable& source = recording.tables[t];
    table.variable = source.control.front();
    table.variable_unit = unit_of_channel(table.variable);
    for (const auto& run : problem.samples.runs) {
      if (run.table != t) continue;
      table.is_series = run.independent_rows;
      for (std::size_t i = run.begin; i < run.end; ++i) {
        const Sample& s = problem.samples.list[i];
        if (!s.counts) continue;
        table.x.push_back(source.column(table.variable)[static_cast<std::size_t>(s.row)]);
        table.recorded.push_back(s.response);
        table.before.push_back(simulated_before[i]);
        table.after.push_back(simulated_after[i]);
        table.sd.push_back(problem.noise.sd[i]);
        table.curve.push_back(s.part);
        table.segment.push_back(problem.samples.segment_names[static_cast<std::size_t>(s.segment)]);
      }
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

std::vector<SimulatedRows> simulated_rows(const Recording& recording, const FitProblem& problem,
                                          const ModelFit& before, const ModelFit& after) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto simulated_before = before.simulate(problem.samples),
             simulated_after = after.simulate(problem.samples);
  std::vector<SimulatedRows> tables;
  for (const RecordingTable& table : recording.tables)
    tables.push_back({std::vector<double>(table.rows(), none), std::vector<double>(table.rows(), none)});
  for (const auto& run : problem.samples.runs)
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const auto row = static_cast<std::size_t>(problem.samples.list[i].row);
      tables[run.table].before[row] = simulated_before[i];
      tables[run.table].after[row] = simulated_after[i];
    }
  return tables;
}

namespace {

/// What an explanation leaves.
std::string what_is_left(const Diagnosis& d) {
  if (d.rows_are_points_of_a_curve)
    return ": the rows are points of a curve that was fitted, which it goes through.";
  const double of_noise = largest_of_noise(d.improved.samples);
  if (d.improved.chi2_reduced >= of_noise)
    return d.simulation.by_finite_elements
               ? ", more than noise, but no more than mesh and laws of this kind are off by."
               : ", more than noise, but no more than laws of this kind are off by.";
  constexpr double clearly_more = 2;  // than the largest that noise leaves
  if (d.improved.held_out_chi2_reduced >= clearly_more * of_noise)
    return ", which is noise where it was fitted and more than noise where it was not.";
  return ", which is noise.";
}

/// Where no solution confirms anything, and one that did not come to its end excludes nothing either.
std::string left_open_in_words(const Diagnosis& d) {
  const bool is_one = d.alternatives.size() == 1;
  std::string names;
  for (const auto& alternative : d.alternatives)
    names += (names.empty() ? "" : "; ") + titles(alternative.effects);
  return "Something was left out. " +
         std::string(is_one ? "One explanation fits so far" : "These explanations fit so far") +
         ", by its law or the part that was solved: " + names +
         ". Nothing is named until it is solved to its end. What would tell: " +
         d.alternatives.front().told_apart_by + ".";
}

}  // namespace

std::string in_words(const Diagnosis& d) {
  const std::string numbers =
      printed("chi-square per sample falls from %.3g to %.3g (data kept out of the fit: %.3g to %.3g)",
              d.baseline.chi2_reduced, d.improved.chi2_reduced, d.baseline.held_out_chi2_reduced,
              d.improved.held_out_chi2_reduced);
  switch (d.verdict) {
    case Verdict::no_mismatch:
      return "Recording and simulation agree: what is left is " +
             std::string(d.rows_are_points_of_a_curve ? "far less than noise would leave" : "noise") +
             ". Nothing was left out that these data can show.";
    case Verdict::explained:
      return "The simulation left out " + titles(d.left_out) +
             (d.left_out.size() > 1 ? ". With them " : ". With it ") + numbers + what_is_left(d);
    case Verdict::partly_explained:
      return "The simulation left out " + titles(d.left_out) + ", and something more. With what is named " +
             numbers + "; structure remains.";
    case Verdict::ambiguous: {
      if (d.left_out.empty()) return left_open_in_words(d);
      const double likeliest = d.alternatives.front().probability;
      const auto others = std::count_if(d.alternatives.begin() + 1, d.alternatives.end(), [&](const auto& a) {
        return a.probability * std::exp(as_good) > likeliest;
      });
      if (others == 0)
        return "Something was left out. " + titles(d.left_out) + " fits: " + numbers +
               "; but other causes look like it in these data. What would tell: " +
               d.alternatives.front().told_apart_by + ".";
      return "Something was left out, and these data cannot say which of " + std::to_string(1 + others) +
             " explanations it is. With the likeliest, " + titles(d.left_out) + ", " + numbers + ".";
    }
    case Verdict::unexplained:
      return std::string("Recording and simulation part, and no effect of the catalogue explains it. ") +
             (d.mismatch.empty() ? "No part of the data stands out" : "The mismatch is located") +
             "; what it is remains open.";
  }
  return "";
}

}  // namespace asperity
