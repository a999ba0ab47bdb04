#include "app/driven_case.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/printed.h"
#include "core/topography_spec.h"

namespace asperity {

void set_entry(Settings& settings, const std::string& path, const std::string& value) {
  const std::size_t slash = path.find('/');
  override_setting(settings, {path.substr(0, slash), path.substr(slash + 1), value, "diagnosis"});
}

namespace {

bool gives(const Settings& settings, const std::string& path) {
  return std::any_of(settings.begin(), settings.end(),
                     [&](const Setting& setting) { return setting.path() == path; });
}

/// The substrate's generated surface, scaled.
void scale_substrate(Settings& settings, double rms) {
  constexpr const char* entry = "Substrate/Topography";
  const auto given = std::find_if(settings.begin(), settings.end(),
                                  [&](const Setting& setting) { return setting.path() == entry; });
  const TopographySpec surface = given == settings.end() ? TopographySpec() : TopographySpec(given->value);
  if (!surface.generator())
    throw InputError(std::string(entry) +
                     " is no generated surface, whose RMS roughness could follow the "
                     "recording; make it generated(rms=...)");
  GeneratorParameters scaled = *surface.generator();
  scaled.spectrum.rms = rms;
  set_entry(settings, entry, rms > 0 ? scaled.text() : "smooth");
}

}  // namespace

void drive(Settings& settings, const LoadingProtocol& protocol) {
  // Of a sphere at 34 approaches of first yield it leaves 0.15 % more of the approach than the default
  // of a case, in half of the time: less than a mesh of twelve cells over the contact radius does.
  constexpr const char* enough_for_a_recording = "0.02";
  if (!gives(settings, "Experiment/Load step error"))
    set_entry(settings, "Experiment/Load step error", enough_for_a_recording);
  const bool by_force = !(protocol.approach > 0);
  set_entry(settings, "Experiment/Control", by_force ? "force" : "displacement");
  set_entry(settings, "Experiment/Normal load", printed("%.6g N", by_force ? protocol.largest_force : 0.0));
  set_entry(settings, "Experiment/Normal approach", printed("%.6g m", protocol.approach));
  set_entry(settings, "Experiment/Unload", protocol.unloads ? "true" : "false");
  set_entry(settings, "Experiment/Retract", printed("%.6g m", protocol.retract));
  set_entry(settings, "Experiment/Cycles", "1");
  set_entry(settings, "Experiment/Hold steps", "0");
  constexpr const char* steps_to_resolve_pull_off = "30";
  if (protocol.retract > 0) set_entry(settings, "Experiment/Unload steps", steps_to_resolve_pull_off);
}

void drive(Settings& settings, const MotionProtocol& protocol) {
  if (protocol.substrate_rms) scale_substrate(settings, *protocol.substrate_rms);
  set_entry(settings, "Experiment/Type", name_of(protocol.motion));
  set_entry(settings, "Experiment/Control", "force");
  set_entry(settings, "Experiment/Normal load", printed("%.6g N", protocol.normal_force));
  set_entry(settings, "Experiment/Normal approach", "0 m");
  if (protocol.motion != Motion::torsion)
    set_entry(settings, "Experiment/Distance", printed("%.4g m", protocol.path));
  for (const char* back : {"Reverse", "Unload"})
    set_entry(settings, std::string("Experiment/") + back, "false");
  set_entry(settings, "Experiment/Return distance", "0 m");
  set_entry(settings, "Experiment/Retract", "0 m");
  set_entry(settings, "Experiment/Cycles", "1");
  set_entry(settings, "Experiment/Hold steps", "0");
}

}  // namespace asperity
