// The matrix of recordings that are set against a case of finite elements.
#include <algorithm>
#include <set>

#include "core/joined.h"
#include "core/printed.h"
#include "diagnosis/challenge/challenge_matrix.h"

namespace asperity {
namespace {

using Names = std::vector<std::string>;
constexpr const char* other_code = "other_code";

class CaseMatrix {
 public:
  explicit CaseMatrix(unsigned seed) : seed_(seed) {}

  std::vector<ChallengeItem> items() {
    nulls();
    for (const Motion mode : {Motion::normal, Motion::sliding})
      for (const auto& effect : out_of_catalogue_effects(mode))
        for (const double noise : {0.005, 0.01})
          if (noise < 0.01 || mode == Motion::sliding || effect == "thermal_oscillation")
            add(out_of_catalogue, mode, {effect}, {noise});
    add(other_code, Motion::normal, {"roughness_compliance"}, {0.003, 0.003, 0.005, 0.005, 0.01, 0.01},
        other_code);
    add(other_code, Motion::normal, {"bulk_plasticity"}, {0.003, 0.005, 0.01}, other_code);
    solved_truths();
    for (const char* effect :
         {"instrument_compliance", "contact_point_offset", "thermal_drift", "baseline_tilt",
          "effective_radius", "adhesion", "roughness_compliance", "creep"})
      add("single", Motion::normal, {effect}, {0.01});
    for (const Names& effects :
         {Names{"adhesion", "baseline_tilt"}, Names{"adhesion", "instrument_compliance"},
          Names{"effective_radius", "thermal_drift"}, Names{"bulk_plasticity", "thermal_drift"},
          Names{"roughness_compliance", "thermal_drift"}})
      add("pair", Motion::normal, effects, {0.005});
    beside_another_surface();
    sliding();
    rolling_and_torsion();
    return std::move(items_);
  }

  /// A dozen of all items: of each kind the first.
  static std::vector<ChallengeItem> some_of(std::vector<ChallengeItem> items) {
    const std::set<std::string> kinds{"null-normal",
                                      "null-sliding-partial_slip",
                                      "null-normal-rough_2.7nm_1",
                                      "out_of_catalogue-normal-thermal_oscillation",
                                      "out_of_catalogue-sliding-position_weakening",
                                      "other_code-normal-bulk_plasticity",
                                      "other_code-normal-roughness_compliance",
                                      "finite_elements-normal-adhesion-adhesion_0.3",
                                      "single-normal-instrument_compliance",
                                      "single-normal-effective_radius",
                                      "pair-normal-adhesion-baseline_tilt",
                                      "single-sliding-partial_slip"};
    std::set<std::string> met;
    items.erase(std::remove_if(items.begin(), items.end(),
                               [&](const ChallengeItem& item) {
                                 const std::string kind = item.name.substr(item.name.find('-') + 1);
                                 return kinds.count(kind) == 0 || !met.insert(kind).second;
                               }),
                items.end());
    return items;
  }

 private:
  void nulls() {
    add("null", Motion::normal, {}, {0.003, 0.01});
    for (const char* surface : {"smooth", "rough_2.7nm_1", "rough_2.7nm_2", "rough_2.7nm_3"})
      add_solved("null", surface, {}, {"Mesh/Interface spacing=20 nm"});
    add_solved("null", "rough_2.7nm_1", {},
               {"Substrate/Topography=generated(rms=2.7 nm, window=2.5 um, hurst=0.8, rolloff=500 nm, "
                "cutoff=72 nm, seed=12)",
                "Mesh/Interface spacing=20 nm"});
    items_.back().name += "-of-another-seed";
    for (const double noise : {0.005, 0.01}) {
      add("null", Motion::normal, {"roughness_compliance"}, {noise}, other_code);
      items_.back().knows_spectrum = true;
      items_.back().simulation->entries = {"Mesh/Interface spacing=16 nm"};
      items_.back().answer = Names{};
    }
    for (const double noise : {0.003, 0.01}) {
      add("null", Motion::sliding, {"partial_slip"}, {noise});
      items_.back().knows_friction = true;
      items_.back().answer = Names{};
    }
  }

  /// Solved by this program, on a finer mesh than the case's.
  void solved_truths() {
    const Names without{"Interface/Work of adhesion=0 J/m^2",
                        "Interface/Work of adhesion on separation=0 J/m^2", "Mesh/Interface spacing=20 nm"};
    for (const char* name : {"adhesion_0.3", "adhesion_0.5"})
      add_solved("finite_elements", name, {"adhesion"}, without);
    add_solved("finite_elements", "adhesion_hysteresis", {"adhesion_hysteresis"}, without);
    add_solved("finite_elements", "plastic_1GPa", {"bulk_plasticity"},
               {"Particle/Yield stress=inf", "Mesh/Interface spacing=80 nm"});
  }

  /// Half-spaces on another realisation of the case's surface, recorded by an instrument that is off.
  void beside_another_surface() {
    for (const char* effect :
         {"instrument_compliance", "contact_point_offset", "thermal_drift", "baseline_tilt"}) {
      add("single", Motion::normal, {"roughness_compliance", effect}, {0.005}, other_code);
      ChallengeItem& item = items_.back();
      item.name += "-of-another-seed";
      item.knows_spectrum = true;
      item.simulation->entries = {"Mesh/Interface spacing=16 nm"};
      item.answer = Names{effect};
    }
  }

  /// Loops with partial slip, which a case has of itself.
  void sliding() {
    for (const Names& effects : {Names{}, Names{"adhesion_offset"}, Names{"surface_tilt"},
                                 Names{"lateral_zero_offset"}, Names{"area_proportional_friction"}}) {
      Names concealed = effects, answer = effects;
      concealed.push_back("partial_slip");
      if (effects != Names{"area_proportional_friction"}) answer.push_back("friction_coefficient");
      add(answer.size() > 1 ? "pair" : "single", Motion::sliding, concealed, {0.005});
      items_.back().answer = answer;
    }
  }

  /// Against smooth elastic bodies, which lose nothing to adhesion and spin by a friction of their own.
  void rolling_and_torsion() {
    const Names lost{"rolling_adhesion_hysteresis"}, spun{"contact_radius_scaling"};
    add("single", Motion::rolling, lost, {0.005, 0.01});
    add("null", Motion::rolling, lost, {0.01});
    items_.back().knows_adhesion = true;
    items_.back().answer = Names{};
    add(out_of_catalogue, Motion::rolling, {lost.front(), "resistance_peak"}, {0.005});
    for (const double noise : {0.003, 0.01}) {
      add("null", Motion::torsion, spun, {noise});
      items_.back().knows_friction = true;
      items_.back().answer = Names{};
      add("single", Motion::torsion, spun, {noise});
      items_.back().answer = Names{"friction_coefficient"};
    }
    add("pair", Motion::torsion, {spun.front(), "adhesion_offset"}, {0.005});
    items_.back().answer = Names{"adhesion_offset", "friction_coefficient"};
  }

  /// A recording at each level of noise.
  void add(const std::string& family, Motion mode, const Names& effects, const std::vector<double>& noises,
           const std::string& setting = "") {
    for (const double noise : noises) {
      ChallengeItem item;
      item.family = family;
      item.options = {mode, effects, noise, seed_ + static_cast<unsigned>(items_.size()) + 1, setting};
      item.name = printed("%03zu", items_.size() + 1) + "-" + family + "-" + name_of(mode);
      if (!effects.empty()) item.name += "-" + joined(effects, "-", "");
      item.simulation.emplace();
      items_.push_back(item);
    }
  }

  /// The history of a solved case, and that case with other entries.
  void add_solved(const std::string& family, const std::string& name, const Names& effects,
                  const Names& entries) {
    add(family, Motion::normal, effects, {0.01});
    ChallengeItem& item = items_.back();
    item.name += "-" + name;
    item.cases = {solved_truth(name)};
    item.simulation = ChallengeCase{item.cases[0] / "case.prm", entries};
  }

  unsigned seed_;
  std::vector<ChallengeItem> items_;
};

}  // namespace

std::vector<ChallengeItem> case_challenge_matrix(bool quick, unsigned seed) {
  auto items = CaseMatrix(seed).items();
  return quick ? CaseMatrix::some_of(std::move(items)) : items;
}

}  // namespace asperity
