#include "diagnosis/conceal/concealed_recording.h"

#include <algorithm>

#include "core/error.h"
#include "core/nearest_name.h"
#include "diagnosis/conceal/add_noise.h"
#include "diagnosis/conceal/world.h"

namespace asperity {
namespace {

using hidden::WorldRequest;

/// Laws of the contact that exclude each other.
const std::vector<std::vector<std::string>>& exclusive() {
  static const std::vector<std::vector<std::string>> sets{
      {"adhesion", "adhesion_hysteresis", "bulk_plasticity", "roughness_compliance", "film", "creep",
       "capillary", "viscoelasticity"},
      {"partial_slip", "lateral_compliance"},
      {"partial_slip", "static_friction_peak"},
      {"partial_slip", "stick_slip"},
      {"partial_slip", "run_in"},
      {"partial_slip", "position_weakening"},
      {"partial_slip", "velocity_dependence", "rate_and_state"},
      {"area_proportional_friction", "adhesion_offset"},
      {"rate_and_state", "run_in"},
      {"contact_radius_scaling", "roughness_dependent_rolling"}};
  return sets;
}

void check(const ConcealOptions& options) {
  std::vector<std::string> known = concealable_effects(options.mode);
  for (const auto& name : out_of_catalogue_effects(options.mode)) known.push_back(name);
  for (const auto& name : effects_beside_a_case(options.mode)) known.push_back(name);
  const std::vector<std::string> alone = effects_by_other_code_alone(options.mode);
  for (const auto& name : alone) known.push_back(name);
  for (const auto& effect : options.effects) {
    if (std::find(known.begin(), known.end(), effect) == known.end())
      throw InputError("no effect '" + effect + "' can be concealed in mode " + name_of(options.mode) + "; " +
                       did_you_mean(effect, known));
    if (options.setting != hidden::by_other_code &&
        std::find(alone.begin(), alone.end(), effect) != alone.end())
      throw InputError("'" + effect +
                       "' is concealed by another code's solution only; add --setting other_code");
  }
  for (const auto& set : exclusive()) {
    std::vector<std::string> both;
    for (const auto& effect : options.effects)
      if (std::find(set.begin(), set.end(), effect) != set.end()) both.push_back(effect);
    if (both.size() > 1)
      throw InputError("'" + both[0] + "' and '" + both[1] +
                       "' are two laws for one place of the contact; conceal one of them");
  }
  if (!(options.noise >= 0 && options.noise < 1))
    throw InputError(
        "the noise must be at least 0 and below 1, relative to the largest response; write --noise 0.01 for "
        "1 %");
  const std::vector<std::string> settings{"",          "one_load",    "ramp_only",
                                          "long_hold", "small_loops", hidden::by_other_code};
  if (std::find(settings.begin(), settings.end(), options.setting) == settings.end())
    throw InputError("there is no setting '" + options.setting +
                     "'; there are one_load, ramp_only, long_hold, small_loops and other_code");
  const std::vector<std::string> solved = hidden::concealable_by_other_code(options.mode);
  const bool has_one =
      std::any_of(options.effects.begin(), options.effects.end(), [&](const std::string& effect) {
        return std::find(solved.begin(), solved.end(), effect) != solved.end();
      });
  if (options.setting == hidden::by_other_code && !has_one)
    throw InputError(
        "setting other_code has the effects bulk_plasticity, film and roughness_compliance of mode normal by "
        "another code's solution, and none of them is concealed; add one, or leave the setting out");
}

/// Effects that are not distinguishable from those concealed by these data.
std::vector<std::string> look_alikes(const ConcealOptions& options) {
  const auto is = [&](const char* effect) { return options.effects == std::vector<std::string>{effect}; };
  if (options.setting == "one_load") {
    if (is("surface_tilt")) return {"lateral_zero_offset"};
    if (is("lateral_zero_offset")) return {"surface_tilt"};
  }
  if (options.setting == "ramp_only") {
    if (is("thermal_drift")) return {"instrument_compliance"};
    if (is("instrument_compliance")) return {"thermal_drift"};
  }
  return {};
}

std::string family_of(const ConcealOptions& options, const Truth& truth) {
  if (!truth.cannot_be_told_from.empty()) return "indistinguishable";
  if (options.effects.empty()) return "null";
  for (const auto& effect : truth.effects)
    if (!effect.in_catalogue) return out_of_catalogue;
  return options.effects.size() == 1 ? "single" : "pair";
}

}  // namespace

std::vector<std::string> concealable_effects(Motion mode) { return hidden::concealable(mode); }
std::vector<std::string> out_of_catalogue_effects(Motion mode) {
  return hidden::concealable_out_of_catalogue(mode);
}
std::vector<std::string> effects_beside_a_case(Motion mode) {
  return hidden::concealable_beside_a_case(mode);
}

std::vector<std::string> effects_by_other_code_alone(Motion mode) {
  const std::vector<std::string> others = concealable_effects(mode);
  std::vector<std::string> alone;
  for (const auto& effect : hidden::concealable_by_other_code(mode))
    if (std::find(others.begin(), others.end(), effect) == others.end()) alone.push_back(effect);
  return alone;
}

ConcealedRecording conceal(const ConcealOptions& options) {
  check(options);
  const WorldRequest request{options.mode, options.effects, options.setting, options.seed};
  hidden::World world = options.mode == Motion::normal    ? hidden::normal_world(request)
                        : options.mode == Motion::sliding ? hidden::sliding_world(request)
                                                          : hidden::series_world(request);
  ConcealedRecording concealed{std::move(world.recording), {}};
  concealed.truth.effects = world.effects;
  concealed.truth.coefficients = world.coefficients;
  concealed.truth.cannot_be_told_from = look_alikes(options);
  concealed.truth.family = family_of(options, concealed.truth);
  hidden::add_noise(concealed, world.without_effects, options);
  check_recording(concealed.recording);
  return concealed;
}

void write_concealed(const ConcealedRecording& concealed, const std::filesystem::path& folder) {
  write_recording(concealed.recording, folder);
  write_truth(concealed.truth, folder);
}

}  // namespace asperity
