// Studies made from known laws, as findings and their sentences are tested with.
#pragma once

#include <cmath>
#include <optional>

#include "dem_compare/resistance/findings.h"
#include "paper/against_published.h"
#include "tests/dem_compare/resistance/moving_study.h"
#include "tests/engines/canonical_contact.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {

inline constexpr double nm = 1e-9;
inline const std::vector<double> three_loads{3e-5, 1e-4, 3e-4};

inline MovingFolder rolling(double load, double moment, unsigned random) {
  MovingFolder made;
  made.experiment = "rolling";
  made.load = load;
  made.friction = 0.6 * moment, made.plastic = 0.4 * moment, made.adhesion = 0;
  made.noise = 0.1, made.hills = 3, made.random = random;
  return made;
}

/// Rolling at three loads on spheres of three radii, with M = mu lambda P.
inline std::vector<StudyEntry> scaled(bool with_contact) {
  std::vector<StudyEntry> entries;
  unsigned random = 10;
  for (const double radius : {2.5e-6, 8.5e-6, 50e-6})
    for (const double load : three_loads) {
      MovingFolder made = rolling(load, 0, ++random);
      made.radius = radius;
      const double moment = 1e-3 * load * (with_contact ? made.contact_radius() : radius);
      made.friction = 0.6 * moment, made.plastic = 0.4 * moment;
      entries.push_back({"R " + std::to_string(std::lround(radius * 1e7)), made});
    }
  return entries;
}

/// Sliding and rolling on three surfaces; relative changes per nm of RMS of what slip and yielding take.
inline std::vector<StudyEntry> of_roughness(double slip, double yielding, int realisations = 1,
                                            double noise = 0.05) {
  std::vector<StudyEntry> entries;
  unsigned random = 50;
  for (const double rms : {0.3, 1.5, 2.7})
    for (const char* type : {"sliding", "rolling"})
      for (int seed = 1; seed <= realisations; ++seed)
        for (const double load : three_loads) {
          MovingFolder made;
          made.experiment = type, made.load = load, made.rms = rms, made.seed = seed, made.noise = noise,
          made.random = ++random;
          // A realisation has a scatter of its own, on all surfaces: it must not hide the trend.
          const double size =
              load * (seed == 2 ? 1.2 : 1) * (std::string(type) == "rolling" ? made.contact_radius() : 1);
          made.friction = 0.2 * size * (1 + slip * (rms - 1.5)),
          made.plastic = 0.02 * size * (1 + yielding * (rms - 1.5));
          entries.push_back({std::to_string(rms).substr(0, 3) + " nm", made});
        }
  return entries;
}

/// A study as it is read; keeps what the findings point into.
struct Study {
  explicit Study(const std::vector<StudyEntry>& entries,
                 const std::optional<Published>& published = std::nullopt)
      : findings(find_resistances(collect_cases({test::write_moving_study(root.path, entries)}))) {
    if (published) findings.published = against_published(findings.study, findings.trends, *published);
  }
  TemporaryFolder root;
  ResistanceFindings findings;
};

/// Cases of one motion on each of the paper's surfaces.
template <class Friction>
std::vector<StudyEntry> on_the_papers_surfaces(const Published& published, const std::string& experiment,
                                               double load, const Friction& friction) {
  std::vector<StudyEntry> entries;
  for (const auto& surface : published.surfaces) {
    MovingFolder made;
    made.experiment = experiment, made.load = load, made.rms = surface.rms.value / nm, made.noise = 0.01;
    made.random = static_cast<unsigned>(entries.size()) + 1;
    made.friction = friction(made, surface);
    entries.push_back({surface.name, made});
  }
  return entries;
}

/// M ~ R^0.85 at three loads with M ~ P: no length, but nearer the particle's radius.
inline std::vector<StudyEntry> nearer_the_particle_radius() {
  auto entries = scaled(false);
  for (auto& entry : entries) {
    const double moment = 1e-3 * entry.made.load * 8.5e-6 * std::pow(entry.made.radius / 8.5e-6, 0.85);
    entry.made.friction = 0.6 * moment, entry.made.plastic = 0.4 * moment;
  }
  return entries;
}

inline std::vector<StudyEntry> two_close_loads() {
  std::vector<StudyEntry> entries;
  for (const double load : {1e-4, 1.2e-4}) {
    MovingFolder made = rolling(load, 1e-13 * load / 1e-4, load > 1e-4 ? 1 : 2);
    made.path_in_radii = 3, made.noise = 0.3;
    entries.push_back({"one", made});
  }
  return entries;
}

/// Rolling with and without adhesion, which falls with roughness.
inline std::vector<StudyEntry> adhesion_over_roughness() {
  std::vector<StudyEntry> entries;
  unsigned random = 0;
  for (const double rms : {0.3, 2.7}) {
    const std::string surface = rms < 1 ? "smoother" : "rougher";
    MovingFolder with;
    with.experiment = "rolling", with.rms = rms, with.noise = 0.03, with.work_of_adhesion = "77 mJ/m^2",
    with.random = ++random;
    with.friction = 1e-13, with.adhesion = 1e-13 * (1 - 0.2 * rms);
    MovingFolder dry = with;
    dry.adhesion = 0, dry.work_of_adhesion = "0 J/m^2", dry.random = ++random;
    entries.push_back({surface, with}), entries.push_back({surface + " dry", dry});
  }
  return entries;
}

/// One input halved after the other, and two at once.
inline std::vector<StudyEntry> varied_inputs(unsigned draw = 0) {
  constexpr unsigned apart = 100;
  MovingFolder full;
  full.random = 1 + apart * draw;
  full.experiment = "rolling", full.friction = 1e-14, full.adhesion = 2e-13, full.plastic = 3e-14,
  full.noise = 0.02, full.local_friction = 0.3;
  full.work_of_adhesion = "77 mJ/m^2";
  MovingFolder slippery = full, dry = full, soft = full, both = full;
  slippery.local_friction = 0.15, slippery.random = full.random + 1;
  dry.work_of_adhesion = "38.5 mJ/m^2", dry.adhesion = 1e-13, dry.random = full.random + 2;
  soft.yield_stress = "1.5 GPa", soft.plastic = 9e-14, soft.random = full.random + 3;
  both.work_of_adhesion = "38.5 mJ/m^2", both.local_friction = 0.15, both.adhesion = 1e-13,
  both.random = full.random + 4;
  return {{"full", full},
          {"half friction", slippery},
          {"half adhesion", dry},
          {"half yield", soft},
          {"both", both}};
}

/// The paper's sphere rolls between wafer and indenter: halves that differ, whose mean is the measured
/// number.
inline std::vector<StudyEntry> between_wafer_and_indenter(const Published& published) {
  std::vector<StudyEntry> entries;
  for (const double load : {1e-4, 1e-3, 3e-3}) {
    const double at_indenter = 3e-9 * load;
    const auto rolled = on_the_papers_surfaces(
        published, "rolling", load, [&](const MovingFolder& made, const auto& surface) {
          return 2 * surface.rolling_r.value * made.radius * (load + surface.rolling_r_offset.value) -
                 at_indenter;
        });
    entries.insert(entries.end(), rolled.begin(), rolled.end());
    MovingFolder diamond;
    diamond.experiment = "rolling", diamond.load = load, diamond.rms = 4, diamond.plane = {1140e9, 0.07},
    diamond.friction = at_indenter;
    entries.push_back({"diamond", diamond});
  }
  return entries;
}

/// Resistance 20 uN (1 + spacing/200 nm): an error of first order.
inline MovingFolder on_spacing(double spacing, double rms = 1.5) {
  MovingFolder made;
  made.rms = rms, made.spacing = spacing, made.noise = 0.1;
  made.friction = 20e-6 * (1 + spacing / 200e-9);
  return made;
}

inline constexpr double degree = M_PI / 180, rolling_moment = 0.4e-12, torsion_moment = 4e-12,
                        share_of_torsion = 0.8;

/// A rail that resists by all of its rolling and 0.8 of its torsion.
inline MovingFolder on_rail(double inclination) {
  MovingFolder made;
  made.experiment = "program", made.inclination = inclination, made.hills = 0.5;
  made.spin_moment = share_of_torsion * torsion_moment;
  made.adhesion = rolling_moment * std::cos(inclination),
  made.friction = made.spin_moment * std::sin(inclination);
  return made;
}

inline std::vector<StudyEntry> rails_beside_separate_motions() {
  MovingFolder rolled, spun;
  rolled.experiment = "rolling", rolled.friction = 0, rolled.adhesion = rolling_moment;
  spun.experiment = "torsion", spun.friction = torsion_moment;
  return {{"1.5 nm", rolled},
          {"1.5 nm", spun},
          {"1.5 nm", on_rail(60 * degree)},
          {"1.5 nm", on_rail(25 * degree)}};
}

}  // namespace asperity::test
