#include "report/page/words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/printed.h"
#include "report/page/axis.h"
#include "report/sentences/phrases.h"
#include "results/known_entries.h"

namespace asperity::report {
namespace {

/// Balances of a converged solve lie below it; nobody reads further digits.
constexpr double smallest_share = 1e-5;

/// "0", "0 nm", "0.0 GPa".
bool is_zero(const std::string& text) {
  char* end = nullptr;
  return std::strtod(text.c_str(), &end) == 0 && end != text.c_str();
}

/// "; a film of 5 nm, E = 70 GPa, ν = 0.17, elastic"; empty: there is none.
std::string film_in_words(const CaseEntries& entries, const std::string& section) {
  const std::string film = section + "/Film ";
  const double thickness = entries.quantity(film + "thickness", Dimension::length, 0);
  if (!(thickness > 0)) return "";
  const double yield = entries.quantity(film + "yield stress", Dimension::pressure, INFINITY);
  return "; a film of " + in_units(thickness, Dimension::length) + ", E = " +
         in_units(entries.quantity(film + "Young modulus", Dimension::pressure), Dimension::pressure) +
         ", ν = " + escaped(entries.text(film + "Poisson ratio")) +
         (std::isinf(yield) ? ", elastic" : ", yields at " + in_units(yield, Dimension::pressure));
}

std::string material_in_words(const SolvedCase& solved, const std::string& section) {
  const CaseEntries& entries = solved.entries;
  std::string words =
      "E = " +
      in_units(entries.quantity(section + "/Young modulus", Dimension::pressure), Dimension::pressure) +
      ", ν = " + escaped(entries.text(section + "/Poisson ratio"));
  const double yield = entries.quantity(section + "/Yield stress", Dimension::pressure, INFINITY);
  if (std::isinf(yield)) {
    const double relaxing = entries.quantity(section + "/Relaxing share", Dimension::none, 0);
    words += relaxing > 0 ? ", " + percent_text(relaxing) + " of its shear modulus relax with " +
                                escaped(entries.text(section + "/Relaxation time"))
                          : ", elastic";
    return words + film_in_words(entries, section);
  }
  words += ", yields at " + in_units(yield, Dimension::pressure);
  const double hardening = entries.quantity(section + "/Hardening modulus", Dimension::pressure, 0);
  if (hardening > 0)
    words += " with " + escaped(entries.text(section + "/Hardening", "isotropic")) + " hardening " +
             in_units(hardening, Dimension::pressure);
  const double voce = entries.quantity(section + "/Voce saturation", Dimension::pressure, 0);
  if (voce > 0) words += ", Voce hardening up to " + in_units(voce, Dimension::pressure) + " more";
  // Entries of laws from files of their own, by their names; 0: not given.
  for (const auto& [path, text] : entries.all()) {
    const bool is_of_film = path.rfind(section + "/Film ", 0) == 0;
    if (path.rfind(section + "/", 0) != 0 || is_known_entry(path) || is_of_film || is_zero(text)) continue;
    words += ", " + escaped(path.substr(section.size() + 1)) + " = " + escaped(text);
  }
  return words + film_in_words(entries, section);
}

}  // namespace

std::string topography_in_words(const TopographySpec& spec) {
  if (spec.is_smooth()) return "smooth";
  if (const auto* scan = spec.scan())
    return "measured: " + escaped(std::filesystem::path(scan->file).filename().string()) +
           (scan->outside == Outside::mirror ? ", continued by its mirror images" : "");
  const GeneratorParameters& generator = *spec.generator();
  return "generated roughness, RMS " + in_units(generator.spectrum.rms, Dimension::length) +
         (generator.window > 0 ? " as measured in scans of " + in_units(generator.window, Dimension::length)
                               : "") +
         " (Hurst exponent " + printed("%.3g", generator.spectrum.hurst) + ", roll-off " +
         in_units(generator.spectrum.rolloff, Dimension::length) + ", cut-off " +
         in_units(generator.spectrum.cutoff, Dimension::length) + ")";
}

std::string what_was_asked(const SolvedCase& solved) {
  const CaseEntries& entries = solved.entries;
  std::string words = "A sphere of radius " +
                      in_units(entries.quantity("Particle/Radius", Dimension::length), Dimension::length) +
                      " (" + material_in_words(solved, "Particle") +
                      "; surface: " + topography_in_words(entries.topography("Particle")) +
                      ") is pressed on a plane (" + material_in_words(solved, "Substrate") +
                      "; surface: " + topography_in_words(entries.topography("Substrate")) + ")";
  if (entries.text("Experiment/Control", "force") == "force")
    words += " with a force that grows to " +
             in_units(entries.quantity("Experiment/Normal load", Dimension::force, NAN), Dimension::force);
  else
    words +=
        " until they have approached each other by " +
        in_units(entries.quantity("Experiment/Normal approach", Dimension::length, NAN), Dimension::length);
  const std::string type = entries.text("Experiment/Type", "normal");
  const std::string back = entries.text("Experiment/Reverse", "true") == "true" ? " and back" : "";
  // 0 stands for a way that the solver derives from the load.
  const auto way = [&](const char* entry, Dimension dimension) {
    const double length = entries.quantity(entry, dimension, 0);
    return (length > 0 ? " by " + in_units(length, dimension) : "") + back;
  };
  if (type == "sliding") words += ", slid" + way("Experiment/Distance", Dimension::length);
  if (type == "rolling") words += ", rolled" + way("Experiment/Distance", Dimension::length);
  if (type == "torsion") words += ", spun" + way("Experiment/Angle", Dimension::angle);
  if (solved.motion() == Motion::program)
    words += ", then moved as " + (type == "program" ? "written" : escaped(type) + " moves it") + " (" +
             escaped(entries.text("Experiment/Program")) + ")";
  if (entries.text("Experiment/Unload", "true") == "true") {
    const std::string cycles = entries.text("Experiment/Cycles", "1");
    words += cycles == "1" ? ", and released" : ", and released, " + escaped(cycles) + " times";
  }
  if (type != "normal")
    words += ". The local friction of its surfaces is " + entries.text("Interface/Friction coefficient", "0");
  if (type != "normal")
    return words + ". How large is its resistance, and how much does each mechanism dissipate?";
  return words +
         ". How stiff is this contact, where does it differ from the smooth elastic contact of Hertz (1882), "
         "and what stays "
         "behind when the load has gone?";
}

std::string in_units(double value, Dimension dimension, int digits) {
  if (!std::isfinite(value)) return "–";
  // Heights and imprints are thought of in nanometres also where they are less than one.
  constexpr double nm = 1e-9, tenth = 0.1 * nm;
  if (dimension == Dimension::length && std::abs(value) < nm && std::abs(value) >= tenth) {
    return printed("%.*g nm", digits, value / nm);
  }
  return readable(format_quantity(value, dimension, digits));
}

std::string imprint_text(double imprint) {
  constexpr double nm = 1e-9, shown_as_zero = 0.005;
  return std::isfinite(imprint)
             ? printed("%.2f nm", std::abs(imprint / nm) < shown_as_zero ? 0.0 : imprint / nm)
             : "–";
}

std::string readable(const std::string& text) {
  std::string html = escaped(text);
  // "100 uN", "20um": a unit behind a number, and nothing behind the unit.
  for (std::size_t u = html.find('u', 1); u != std::string::npos; u = html.find('u', u + 1)) {
    const auto is = [&](std::size_t at, int (*kind)(int)) {
      return at < html.size() && kind(static_cast<unsigned char>(html[at])) != 0;
    };
    const bool behind_number =
        is(u - 1, std::isdigit) || (u > 1 && html[u - 1] == ' ' && is(u - 2, std::isdigit));
    const bool is_unit = u + 1 < html.size() && (html[u + 1] == 'N' || html[u + 1] == 'm') &&
                         !is(u + 2, std::isalnum) && html[std::min(u + 2, html.size() - 1)] != '_';
    if (behind_number && is_unit) html.replace(u, 1, "µ");
  }
  return html;
}

std::string area_text(double area) {
  constexpr double um2 = 1e-12;
  return std::isfinite(area) ? printed("%.3g µm²", area / um2) : "–";
}

std::string in_units(const Scatter& scatter, double unit, const std::string& name, int digits) {
  const std::string number = plus_minus(scatter, unit, digits);
  return std::isfinite(scatter.mean) && !name.empty() ? number + " " + name : number;
}

std::string ratio_text(const Scatter& scatter) { return plus_minus(scatter, 1, 3); }

std::string departure_text(double ratio) {
  if (!std::isfinite(ratio)) return "–";
  if (ratio >= 2) return printed("%.2g times", ratio);
  const double percent = 100 * (ratio - 1);
  constexpr double shown_as_zero = 0.05;
  if (std::abs(percent) < shown_as_zero) return "0.0\u00a0%";
  return (percent < 0 ? "−" : "+") +
         printed(std::abs(percent) < 9.95 ? "%.1f\u00a0%%" : "%.0f\u00a0%%", std::abs(percent));
}

std::string percent_text(double share, int digits) {
  if (!std::isfinite(share)) return "–";
  if (share != 0 && std::abs(share) < smallest_share) return "&lt; 0.001 %";
  return printed("%.*g %%", digits, 100 * share);
}

std::string percent_bound(double share) { return percent_text(std::max(std::abs(share), smallest_share)); }

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "–";
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return printed("%.3g s", seconds);
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

}  // namespace asperity::report
