#include "app/characterise_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/case_file.h"
#include "core/attraction_zone.h"
#include "core/error.h"
#include "core/hertz.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "fem/preview_case.h"

namespace asperity {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr const char* planned = "the plan of characterise";

/// Below four cells a contact of Hertz is not a circle any more; a quick answer takes three and says so.
const std::vector<Rung>& ladder() {
  static const std::vector<Rung> rungs{{3, 1.8, 1, 1}, {4, 2, 2, 1},   {4, 2, 2, 2},
                                       {5, 2.5, 2, 2}, {5, 2.5, 2, 3}, {6, 3, 2, 3},
                                       {6, 3, 3, 3},   {8, 3.5, 3, 4}, {10, 4, 3, 4}};
  return rungs;
}

std::string text_of(double value, Dimension dimension) { return format_quantity(value, dimension, 4); }

/// One in the geometric middle, or the ends and what lies evenly between in the logarithm.
std::vector<double> loads_of(const std::vector<double>& ends, int count) {
  if (ends.size() == 1) return ends;
  if (count == 1) return {std::sqrt(ends[0] * ends[1])};
  std::vector<double> loads;
  for (int i = 0; i < count; ++i) loads.push_back(ends[0] * std::pow(ends[1] / ends[0], i / (count - 1.0)));
  return loads;
}

void add_body(Settings& settings, const std::string& section, const Material& material) {
  settings.push_back(
      {section, "Young modulus", text_of(material.youngs_modulus.value, Dimension::pressure), planned});
  settings.push_back({section, "Poisson ratio", text_of(material.poisson_ratio, Dimension::none), planned});
  if (material.yields())
    settings.push_back(
        {section, "Yield stress", text_of(material.yield_stress(), Dimension::pressure), planned});
}

Settings base_of(const CharacteriseRequest& request, const CharacterisePlan& plan,
                 const MeasuredScan& substrate, const std::optional<MeasuredScan>& particle) {
  Settings settings;
  settings.push_back({"Particle", "Radius", text_of(request.particle.radius, Dimension::length), planned});
  add_body(settings, "Particle", request.particle.material);
  GeneratorParameters generator;
  const auto surface = [&](const MeasuredScan& scan, std::uint64_t seed) {
    TopographySpec spec = topography_of(scan, request.surface, plan.cutoff);
    if (!spec.generator()) return spec.text();
    generator = *spec.generator();
    generator.seed = seed;
    return generator.text();
  };
  settings.push_back({"Particle", "Topography", particle ? surface(*particle, 1) : "smooth", planned});
  add_body(settings, "Substrate", request.substrate);
  settings.push_back({"Substrate", "Topography", surface(substrate, 2), planned});
  if (request.adhesion) {
    settings.push_back({"Interface", "Work of adhesion",
                        text_of(request.adhesion->work, Dimension::surface_energy), planned});
    settings.push_back({"Interface", "Adhesion law", "exponential", planned});
    settings.push_back(
        {"Interface", "Adhesion range", text_of(request.adhesion->range, Dimension::length), planned});
  }
  settings.push_back({"Mesh", "Interface spacing", text_of(plan.spacing, Dimension::length), planned});
  settings.push_back({"Mesh", "Layers", "2", planned});
  settings.push_back({"Output", "Fields", "false", planned});
  return settings;
}

PlannedMotion motion_of(const std::string& type, double friction, bool named,
                        const std::vector<std::pair<std::string, std::string>>& entries) {
  PlannedMotion motion;
  motion.label = type + (named ? printed(" at local friction %g", friction) : "");
  motion.settings.push_back({"Experiment", "Type", type, planned});
  motion.settings.push_back({"Interface", "Friction coefficient", printed("%g", friction), planned});
  for (const auto& [entry, value] : entries) motion.settings.push_back({"Experiment", entry, value, planned});
  return motion;
}

/// Normal load without friction, which hardly changes it and so counts for each coefficient; then each motion
/// at each coefficient.
/// contact_radius: at the largest load [m].
std::vector<PlannedMotion> motions_of(const CharacteriseRequest& request, double contact_radius) {
  using Entries = std::vector<std::pair<std::string, std::string>>;
  std::vector<PlannedMotion> motions{
      motion_of("normal", 0, false, {{"Load steps", "6"}, {"Unload steps", "5"}, {"Unload", "true"}})};
  const bool named = request.friction.size() > 1;
  const std::string back = text_of(contact_radius, Dimension::length);
  const auto quick_path = [&](double radii, const char* steps) {
    return Entries{{"Distance", text_of(radii * contact_radius, Dimension::length)}, {"Motion steps", steps}};
  };
  for (const double friction : request.friction) {
    const Entries torsion{{"Load steps", "4"}, {"Unload", "false"}, {"Reverse", "false"}};
    // Friction is known to a per cent after that: the time is for what rolls.
    constexpr double slid_radii = 3;
    Entries there = torsion;
    Entries there_and_back{
        {"Load steps", "4"}, {"Unload", "false"}, {"Reverse", "true"}, {"Return distance", back}};
    if (!request.quick)
      there.emplace_back("Distance", text_of(slid_radii * contact_radius, Dimension::length));
    else {
      // Rolling is steady a radius later.
      for (auto& entry : quick_path(3.5, "24")) there.push_back(entry);
      for (auto& entry : quick_path(4.5, "31")) there_and_back.push_back(entry);
    }
    motions.push_back(motion_of("sliding", friction, named, there));
    motions.push_back(motion_of("rolling", friction, named, there_and_back));
    motions.push_back(motion_of("torsion", friction, named, torsion));
  }
  return motions;
}

/// Of one realisation of a motion at all loads; two cases at a time, a core for each.
double seconds_of(const CharacterisePlan& plan, const PlannedMotion& motion) {
  constexpr int at_a_time = 2;
  double seconds = 0;
  for (const double load : plan.loads) {
    Settings settings = plan.base;
    for (const auto& setting : motion.settings) override_setting(settings, setting);
    override_setting(settings, {"Experiment", "Normal load", text_of(load, Dimension::force), planned});
    seconds += preview_mesh(case_from_settings(settings, planned)).seconds_on_one_core;
  }
  return seconds / at_a_time;
}

/// One more surface for some of the motions, up to `most`, as long as the time allows.
template <class Chosen>
void add_realisations(CharacterisePlan& plan, double time, int most, const Chosen& is_chosen) {
  std::vector<PlannedMotion*> chosen;
  double each = 0;
  for (PlannedMotion& motion : plan.motions)
    if (is_chosen(motion)) chosen.push_back(&motion), each += seconds_of(plan, motion);
  while (chosen.front()->realisations < most && plan.seconds + each <= time) {
    for (PlannedMotion* motion : chosen) ++motion->realisations;
    plan.seconds += each;
    plan.cases += static_cast<int>(chosen.size() * plan.loads.size());
  }
}

/// What rolls scatters most from surface to surface, and what is only pressed costs least.
void add_realisations(CharacterisePlan& plan, double time) {
  constexpr int most_rolled = 6, most_pressed = 10;
  add_realisations(plan, time, most_rolled,
                   [](const PlannedMotion& motion) { return motion.label.rfind("rolling", 0) == 0; });
  add_realisations(plan, time, most_pressed,
                   [](const PlannedMotion& motion) { return motion.label == "normal"; });
}

/// Surfaces by half-spaces: of normal load for the stiffnesses, and of torsion for its moment where all
/// slips; a fifth of them at least, as the time allows.
void add_half_spaces(CharacterisePlan& plan, bool adhesive, double time) {
  const double seconds_a_surface = adhesive ? 1.5 : 0.15;  // two at a time; attraction takes a separation
  constexpr double least_share = 0.2;
  int surfaces = 0;
  for (PlannedMotion& motion : plan.motions) {
    if (motion.label == "normal")
      motion.half_space_surfaces = adhesive ? 40 : 200;
    else if (motion.label.rfind("torsion", 0) == 0)
      motion.half_space_surfaces = adhesive ? 10 : 60;
    surfaces += motion.half_space_surfaces;
  }
  const double seconds = surfaces * seconds_a_surface * static_cast<double>(plan.loads.size()),
               share = std::clamp((time - plan.seconds) / seconds, least_share, 1.0);
  for (PlannedMotion& motion : plan.motions)
    motion.half_space_surfaces = static_cast<int>(std::lround(share * motion.half_space_surfaces));
  plan.seconds += share * seconds;
}

CharacterisePlan plan_at(const Rung& rung, const CharacteriseRequest& request, const MeasuredScan& substrate,
                         const std::optional<MeasuredScan>& particle) {
  constexpr double cells_per_wave = 4;
  CharacterisePlan plan;
  plan.rung = rung;
  plan.loads = loads_of(request.loads, rung.loads);
  const Hertz smooth = smooth_contact(request);
  const double work = request.adhesion ? request.adhesion->work : 0, E = smooth.reduced_modulus,
               R = smooth.radius, least = radius_least_by_attraction(E, R, work, plan.loads.front()),
               widest = radius_widest_by_attraction(E, R, work, plan.loads.back());
  const double rolloff = std::min(rolloff_of(substrate), particle ? rolloff_of(*particle) : infinite),
               measured = std::max(substrate.shortest_wave, particle ? particle->shortest_wave : 0);
  const double needed = std::max(rolloff / rung.waves, measured) / cells_per_wave;
  plan.spacing = std::min(least / rung.cells_per_radius, needed);
  plan.cutoff = std::max(cells_per_wave * plan.spacing, measured);
  const bool drawn =
      from_spectrum(substrate, request.surface) || (particle && from_spectrum(*particle, request.surface));
  if (!drawn) plan.rung.realisations = 1;
  plan.base = base_of(request, plan, substrate, particle);
  plan.motions = motions_of(request, widest);
  for (PlannedMotion& motion : plan.motions) motion.realisations = plan.rung.realisations;
  plan.cases = static_cast<int>(plan.loads.size() * plan.motions.size()) * plan.rung.realisations;
  for (const auto& motion : plan.motions) plan.seconds += seconds_of(plan, motion) * plan.rung.realisations;
  return plan;
}

}  // namespace

CharacterisePlan plan_of(const CharacteriseRequest& request, const MeasuredScan& substrate,
                         const std::optional<MeasuredScan>& particle) {
  CharacterisePlan plan = plan_at(ladder().front(), request, substrate, particle);
  plan.is_least = true;
  for (std::size_t i = 1; i < ladder().size(); ++i) {
    const CharacterisePlan dearer = plan_at(ladder()[i], request, substrate, particle);
    if (request.quick || dearer.seconds > request.time) {
      plan.next = dearer.rung, plan.next_seconds = dearer.seconds;
      break;
    }
    plan = dearer;
  }
  if (!request.quick && plan.rung.realisations > 1) {
    add_half_spaces(plan, request.adhesion.has_value(), request.time);
    add_realisations(plan, request.time);
  }
  return plan;
}

}  // namespace asperity
