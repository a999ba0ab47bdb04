#include "diagnosis/challenge/challenge_matrix.h"

#include <filesystem>

#include "core/data_folder.h"
#include "core/printed.h"

namespace asperity {
namespace {

constexpr double middle_noise = 0.01;

const std::vector<std::pair<Motion, std::vector<std::string>>>& pairs() {
  static const std::vector<std::pair<Motion, std::vector<std::string>>> list{
      {Motion::normal, {"instrument_compliance", "thermal_drift"}},
      {Motion::normal, {"contact_point_offset", "instrument_compliance"}},
      {Motion::normal, {"adhesion", "instrument_compliance"}},
      {Motion::normal, {"adhesion", "baseline_tilt"}},
      {Motion::normal, {"effective_radius", "thermal_drift"}},
      {Motion::normal, {"bulk_plasticity", "thermal_drift"}},
      {Motion::normal, {"roughness_compliance", "thermal_drift"}},
      {Motion::normal, {"creep", "instrument_compliance"}},
      {Motion::sliding, {"lateral_compliance", "adhesion_offset"}},
      {Motion::sliding, {"lateral_compliance", "static_friction_peak"}},
      {Motion::sliding, {"lateral_compliance", "area_proportional_friction"}},
      {Motion::sliding, {"surface_tilt", "adhesion_offset"}},
      {Motion::sliding, {"surface_tilt", "lateral_zero_offset"}},
      {Motion::sliding, {"velocity_dependence", "lateral_zero_offset"}},
      {Motion::sliding, {"run_in", "lateral_zero_offset"}},
      {Motion::sliding, {"stick_slip", "adhesion_offset"}},
      {Motion::sliding, {"partial_slip", "surface_tilt"}},
      {Motion::rolling, {"rolling_adhesion_offset", "viscous_rolling"}},
      {Motion::rolling, {"roughness_dependent_rolling", "rolling_adhesion_offset"}},
      {Motion::rail, {"torsion_resistance", "rolling_adhesion_offset"}}};
  return list;
}

/// Cases that the finite-element solver solved, a few kilobytes each (challenge/data), and what they show.
struct SolvedTruth {
  const char* name;
  Motion mode;
  std::vector<std::string> effects;
  std::vector<const char*> cases;
};

const std::vector<SolvedTruth>& solved_truths() {
  static const std::vector<SolvedTruth> list{
      {"smooth", Motion::normal, {}, {"smooth"}},
      {"rough-1", Motion::normal, {"roughness_compliance"}, {"rough_2.7nm_1"}},
      {"rough-2", Motion::normal, {"roughness_compliance"}, {"rough_2.7nm_2"}},
      {"rough-3", Motion::normal, {"roughness_compliance"}, {"rough_2.7nm_3"}},
      {"0.3-J", Motion::normal, {"adhesion"}, {"adhesion_0.3"}},
      {"0.5-J", Motion::normal, {"adhesion"}, {"adhesion_0.5"}},
      {"0.2-and-0.8-J", Motion::normal, {"adhesion_hysteresis"}, {"adhesion_hysteresis"}},
      {"1-GPa", Motion::normal, {"bulk_plasticity"}, {"plastic_1GPa"}},
      {"shift", Motion::sliding, {"partial_slip"}, {"partial_slip"}},
      {"spin",
       Motion::torsion,
       {"contact_radius_scaling"},
       {"torsion_25uN", "torsion_50uN", "torsion_100uN", "torsion_200uN", "torsion_400uN", "torsion_800uN",
        "torsion_1600uN"}},
  };
  return list;
}

class Matrix {
 public:
  Matrix(bool quick, unsigned seed) : quick_(quick), seed_(seed) {}

  std::vector<ChallengeItem> items() {
    singles();
    for (const auto& [mode, effects] : pairs())
      for (const double noise : levels({0.005, middle_noise})) add("pair", mode, effects, noise);
    for (const Motion mode : all_modes())
      for (int i = 0; i < (quick_ ? 1 : 6); ++i)
        add("null", mode, {}, i % 3 == 0 ? 0.003 : i % 3 == 1 ? middle_noise : 0.03);
    for (const Motion mode : all_modes())
      for (const auto& effect : out_of_catalogue_effects(mode))
        for (const double noise : levels({0.003, middle_noise, 0.02}))
          add(out_of_catalogue, mode, {effect}, noise);
    for (int i = 0; i < (quick_ ? 1 : 2); ++i) {
      add("decoy", Motion::normal, {"thermal_drift"}, middle_noise, "long_hold");  // looks like creep
      add("decoy", Motion::normal, {"baseline_tilt"}, middle_noise);               // looks like attraction
      add("decoy", Motion::normal, {"contact_point_offset"}, middle_noise);        // looks like roughness
      add("decoy", Motion::sliding, {"lateral_compliance"}, middle_noise,
          "small_loops");  // looks like partial slip
    }
    for (int i = 0; i < (quick_ ? 1 : 2); ++i) {
      for (const char* effect : {"surface_tilt", "lateral_zero_offset"})
        add("indistinguishable", Motion::sliding, {effect}, middle_noise, "one_load");
      for (const char* effect : {"thermal_drift", "instrument_compliance"})
        add("indistinguishable", Motion::normal, {effect}, middle_noise, "ramp_only");
    }
    for (const auto& solved : solved_truths())
      for (const double noise : levels({0.005, middle_noise, 0.02})) {
        add("finite_elements", solved.mode, solved.effects, noise);
        items_.back().name += "-" + std::string(solved.name);
        for (const char* name : solved.cases) items_.back().cases.push_back(solved_truth(name));
      }
    for (const char* effect : {"bulk_plasticity", "roughness_compliance", "film"})
      for (const double noise : levels({0.003, 0.005, middle_noise}))
        for (int i = 0; i < (quick_ ? 1 : 2); ++i)
          add("other_code", Motion::normal, {effect}, noise, "other_code");
    return std::move(items_);
  }

 private:
  void singles() {
    for (const Motion mode : all_modes()) {
      const bool is_trace = mode == Motion::normal || mode == Motion::sliding;
      for (const auto& effect : concealable_effects(mode))
        for (const double noise : levels({is_trace ? 0.003 : 0.005, middle_noise, is_trace ? 0.03 : 0.02}))
          add("single", mode, {effect}, noise);
    }
  }
  std::vector<double> levels(const std::vector<double>& all) const {
    return quick_ ? std::vector<double>{middle_noise} : all;
  }

  void add(const std::string& family, Motion mode, const std::vector<std::string>& effects, double noise,
           const std::string& setting = "") {
    ChallengeItem item;
    item.family = family;
    // Seeds follow each other, so that parameters, kinds of noise and experiments differ from item to item.
    item.options = {mode, effects, noise, seed_ + static_cast<unsigned>(items_.size()) + 1, setting};
    item.name = printed("%03zu", items_.size() + 1) + "-" + family + "-" + name_of(mode);
    for (const auto& effect : effects) item.name += "-" + effect;
    items_.push_back(item);
  }

  bool quick_;
  unsigned seed_;
  std::vector<ChallengeItem> items_;
};

}  // namespace

std::vector<ChallengeItem> challenge_matrix(bool quick, unsigned seed) { return Matrix(quick, seed).items(); }

std::filesystem::path solved_truth(const std::string& name) {
  return data_folder("challenge", ASPERITY_CHALLENGE_DATA) / name;
}

ConcealedRecording conceal(const ChallengeItem& item) {
  return item.cases.empty() ? conceal(item.options) : conceal_cases(item.cases, item.options);
}

}  // namespace asperity
