#include "report/study/study_tables.h"

#include <algorithm>
#include <cmath>

#include "core/printed.h"
#include "report/page/axis.h"
#include "report/page/display_units.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/result/result_tables.h"
#include "report/result/surface_spectra.h"
#include "report/sentences/phrases.h"
#include "surfaces/surface_of_entry.h"
#include "surfaces/virtual_afm.h"

namespace asperity::report {
namespace {

/// One row per contact and load; the contact is named in its first row.
template <class Cells>
Table load_by_load(const std::vector<StudyCurve>& curves, std::vector<std::string> head, const Cells& cells) {
  head.insert(head.begin(), {"contact", "load"});
  Table table{std::move(head), {}, true};
  for (const auto& curve : curves)
    for (const auto& load : curve.last().loads) {
      const bool first = &load == &curve.last().loads.front();
      std::vector<std::string> row{first ? readable(curve.label) : "",
                                   in_units(load.force, Dimension::force)};
      for (auto& cell : cells(curve, load)) row.push_back(std::move(cell));
      table.rows.push_back(std::move(row));
    }
  return table;
}

/// Mesh error of a small difference, which says more in its own unit than in per cent.
std::string absolute_mesh_error(const Estimate& estimate, double unit) {
  if (!estimate.mesh) return "–";
  const double error = (estimate.mean - estimate.mesh->extrapolated) / unit;
  return (error < 0 ? "−" : "+") + printed("%.2f", std::abs(error));
}

std::string spectrum_cells(const GeneratorParameters& generator, std::vector<std::string>& row) {
  const SelfAffineSpectrum& spectrum = generator.spectrum;
  row.insert(row.end(), {in_units(spectrum.rms, Dimension::length),
                         generator.window > 0 ? "scans of " + in_units(generator.window, Dimension::length)
                                              : "the whole surface",
                         printed("%.3g", spectrum.hurst), in_units(spectrum.rolloff, Dimension::length),
                         in_units(spectrum.cutoff, Dimension::length),
                         in_units(correlation_length(spectrum), Dimension::length)});
  return printed("%.3f", surface_spectrum(generator).rms_slope());
}

}  // namespace

std::string surfaces_table(const std::vector<StudyCurve>& curves) {
  Table table{{"contact", "surface of", "RMS", "as seen in", "Hurst exponent", "roll-off", "short cut-off",
               "correlation length", "RMS slope", "RMS in the contact region [nm]"}};
  for (const auto& curve : curves)
    for (const std::string section : {"Particle", "Substrate"}) {
      const auto generator = generator_of(curve.largest->first(), section);
      if (!generator) continue;
      std::vector<std::string> row{readable(curve.label), section == "Particle" ? "sphere" : "plane"};
      const std::string slope = spectrum_cells(*generator, row);
      row.insert(row.end(), {slope, plus_minus(meshed_rms(*curve.largest, section), nm)});
      table.rows.push_back(std::move(row));
    }
  if (table.rows.empty()) return "";
  return table_html(table) +
         note(
             "RMS alone does not fix a surface: the spectrum says how the heights are shared out among long "
             "and short waves, and with them slopes and curvatures. The patch under the contact is smaller "
             "than a scan and misses the longest waves, so its own RMS is lower on average and scatters (±) "
             "from one realisation to the next.");
}

std::string stiffness_table(const std::vector<StudyCurve>& curves) {
  const Table table = load_by_load(
      curves,
      {"realisations", "stiffness, loading [kN/m]", "mesh error", "standard error of the mean",
       "load-step error", "over Hertz", "stiffness, unloading [kN/m]", "mesh error", "over Hertz"},
      [](const StudyCurve& curve, const LoadComparison& load) -> std::vector<std::string> {
        return {std::to_string(curve.last().realisations),
                plus_minus(load.stiffness, kN_per_m),
                mesh_error_text(load.stiffness),
                percent_text(load.stiffness.standard_error / load.stiffness.mean),
                percent_text(load.step_error),
                departure_text(load.stiffness_ratio.mean),
                plus_minus(load.unloading_stiffness, kN_per_m),
                mesh_error_text(load.unloading_stiffness),
                departure_text(load.unloading_ratio.mean)};
      });
  return table_html(table) +
         note(
             "The slope dF/dδ of the loading path at each of its loads, and of the unloading path where it "
             "passes the same load. ± is the standard deviation over realisations: how much one rough "
             "surface differs from the next with the same statistics; the standard error says how well their "
             "mean is known. The mesh error is the computation's own and is not contained in ±: what the "
             "value would lose on an infinitely fine mesh, extrapolated from the spacings solved, with a "
             "standard error of its own where realisations give one. The load-step error bounds what the "
             "finite steps do to the slope.");
}

std::string contact_table(const std::vector<StudyCurve>& curves) {
  const Table table = load_by_load(
      curves,
      {"approach [nm]", "force over Hertz, same approach", "mesh error", "real area over Hertz", "mesh error",
       "mean pressure [GPa]", "mesh error", "largest pressure [GPa]", "mesh error",
       "plastic volume [10⁻³ µm³]"},
      [](const StudyCurve&, const LoadComparison& load) -> std::vector<std::string> {
        constexpr double thousandth = 1e-3;
        return {plus_minus(load.approach, nm),          ratio_text(load.force_ratio),
                mesh_error_text(load.force_ratio),      ratio_text(load.area_ratio),
                mesh_error_text(load.area_ratio),       plus_minus(load.mean_pressure, GPa),
                mesh_error_text(load.mean_pressure),    plus_minus(load.largest_pressure, GPa),
                mesh_error_text(load.largest_pressure), plus_minus(load.plastic_volume, thousandth * um3)};
      });
  return table_html(table) +
         note(
             "The real area is that of all nodes that carry, so a contact spot counts too large by about a "
             "third of a cell all around: small spots at low loads are where the mesh error is largest. Mean "
             "pressure is the load over this area.");
}

std::string imprint_and_fit_table(const std::vector<StudyCurve>& curves) {
  Table table{{"contact", "load", "imprint left [nm]", "its mesh error [nm]", "plastic volume [10⁻³ µm³]",
               "dissipated energy [fJ]", "radius a Hertz fit reports [µm]", "mesh error",
               "with the zero of approach free [µm]", "exponent it would find", "with the zero free"}};
  constexpr double thousandth = 1e-3;
  for (const auto& curve : curves)
    for (const auto* group : curve.groups) {
      const GroupNumbers& n = group->numbers;
      table.rows.push_back({readable(curve.label), in_units(n.force, Dimension::force),
                            plus_minus(n.residual_imprint, nm), absolute_mesh_error(n.residual_imprint, nm),
                            plus_minus(n.plastic_volume, thousandth * um3),
                            plus_minus(n.dissipated_energy, fJ), plus_minus(n.fitted_radius, um),
                            mesh_error_text(n.fitted_radius), plus_minus(n.fitted_radius_with_offset, um),
                            plus_minus(n.exponent), plus_minus(n.exponent_with_offset)});
    }
  const double radius = curves.empty() ? NAN : curves.front().last().numbers.hertz.radius;
  return table_html(table) + note(
                                 "The fit is what an experimenter would make of the loading curve with "
                                 "Hertz's law, the sphere's radius left free (the true one is " +
                                 in_units(radius, Dimension::length) +
                                 ", Hertz's exponent 1.5). Leaving the zero of approach free as well takes "
                                 "out the soft beginning, where only the highest asperities carry. The "
                                 "imprint is the approach that has not come back; one that is smaller than "
                                 "its scatter or mesh error, or negative, is not significant.");
}

std::string case_list(const CaseCollection& collection) {
  Table table{{"folder", "cells", "unknowns", "force", "moment", "energy", "wall time", "peak memory [GiB]"}};
  for (const auto& group : collection.groups)
    for (const auto& solved : group.cases) {
      if (!solved.finished()) continue;
      const CaseResult& result = *solved.result;
      const auto count = [](double value) {
        return std::isfinite(value) ? std::to_string(std::llround(value)) : std::string("–");
      };
      constexpr double GiB = 1024.0 * 1024 * 1024;
      table.rows.push_back({escaped(solved.folder.filename().string()), count(result.cells),
                            count(result.unknowns), percent_text(result.balance_of("force")),
                            percent_text(result.balance_of("moment")),
                            percent_text(result.balance_of("energy")), duration_text(result.wall_time),
                            plus_minus({1, result.peak_memory, NAN, NAN}, GiB)});
    }
  return table_html(table) +
         note(
             "force, moment and energy are the relative errors of the balances. <code>asperity report</code> "
             "on one of the folders writes the full page of that case.");
}

}  // namespace asperity::report
