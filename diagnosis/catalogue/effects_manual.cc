// docs/effects.md from the catalogue itself.

#include <cmath>

#include "core/printed.h"
#include "diagnosis/catalogue/effect.h"

namespace asperity {
namespace {

/// Bounds and the like are told for a sphere of 8.5 um under up to 3 mN.
Experiment example(Motion mode) {
  Experiment e;
  e.mode = mode;
  e.particle = {71e9, 0.17};
  e.substrate = {179e9, 0.25};
  e.indenter = {1140e9, 0.07};
  e.radius = e.smallest_radius = e.largest_radius = 8.5e-6;
  e.largest_force = 3e-3;
  e.typical_force = 1e-3;
  e.smallest_force = 1e-4;
  e.largest_displacement = e.hertz().approach(e.largest_force);
  e.largest_response = 1e-3;
  e.stroke = 2e-6;
  e.duration = 60;
  e.hold_duration = 20;
  e.slowest = 1e-7;
  e.fastest = 1e-5;
  e.cycles = 20;
  e.smoothest = 0.3e-9;
  e.roughest = 4e-9;
  return e;
}

std::string plain(double value) { return printed("%.3g", value); }

}  // namespace

std::string effects_manual(Equations equations) {
  std::string text =
      "# Effects that a diagnosis can name\n\n"
      "Written by `asperity diagnose --catalogue --typeset` from the effects themselves "
      "(`diagnosis/effects/`, one "
      "file each). An effect\n"
      "changes the mechanics of the simulation; its parameters are shared by all segments and runs and stay "
      "within the bounds.\n"
      "Bounds are SI, for a sphere of 8.5 um under up to 3 mN.\n";
  for (const auto& effect : effect_catalogue()) {
    const EffectDescription& d = effect->description();
    std::string modes;
    for (const Motion mode : d.modes) modes += (modes.empty() ? "" : ", ") + name_of(mode);
    text += "\n## " + d.id + "\n\n" + d.title + " (" +
            (d.kind == EffectKind::contact ? "contact" : "instrument") + "; modes: " + modes + ").\n\n";
    text += displayed(d.equation, equations) + "\n\n" + d.meaning + "\n\nSource: " + d.source + "\n";
    const NeededValues needed = effect->needs();
    if (needed.count > 0)
      text += "\nNot named from fewer than " + std::to_string(needed.count) + " different values of `" +
              needed.channel + "`.\n";
    const auto parameters = effect->parameters(example(d.modes.front()));
    if (parameters.empty()) {
      text += "\nNo parameters.\n";
      continue;
    }
    text += "\n| parameter | unit | meaning | from | to |\n| --- | --- | --- | --- | --- |\n";
    for (const auto& p : parameters)
      text += "| `" + p.name + "` | " + (p.unit.empty() ? "–" : p.unit) + " | " + p.meaning +
              (std::isfinite(p.absent) ? "; only where the data show it" : "") + " | " + plain(p.low) +
              " | " + plain(p.high) + " |\n";
  }
  return text;
}

}  // namespace asperity
