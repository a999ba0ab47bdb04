// What a challenge conceals: its matrix of recordings, and that a seed conceals the same as ever.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/challenge/challenge_matrix.h"
#include "diagnosis/conceal/world.h"

namespace asperity {
namespace {

TEST(ChallengeMatrix_behaviour, seeds_follow_each_other_from_the_one_given) {
  for (const unsigned seed : {0u, 100u}) {
    const auto items = challenge_matrix(true, seed);
    for (std::size_t i = 0; i < items.size(); ++i)
      EXPECT_EQ(items[i].options.seed, seed + i + 1) << items[i].name;
  }
}

TEST(ChallengeMatrix_behaviour, numbers_its_items_and_says_what_they_hold) {
  const auto items = challenge_matrix(false, 0);
  EXPECT_EQ(items[0].name.substr(0, 11), "001-single-");
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(std::stoul(items[i].name.substr(0, 3)), i + 1);
    EXPECT_GT(items[i].options.noise, 0);
    EXPECT_EQ(items[i].family == "pair", items[i].options.effects.size() == 2) << items[i].name;
    EXPECT_EQ(items[i].family == "indistinguishable",
              items[i].options.setting == "one_load" || items[i].options.setting == "ramp_only");
    EXPECT_EQ(items[i].cases.empty(), items[i].family != "finite_elements");
    for (const auto& effect : items[i].options.effects)
      EXPECT_NE(items[i].name.find(effect), std::string::npos);
  }
  EXPECT_EQ(std::count_if(items.begin(), items.end(), [](const auto& item) { return item.family == "null"; }),
            30);
  EXPECT_EQ(std::count_if(items.begin(), items.end(), [](const auto& item) { return item.family == "pair"; }),
            40);
  for (const auto& item : challenge_matrix(true, 0)) {
    if (item.family == "null")
      EXPECT_EQ(item.options.noise, 0.003);
    else
      EXPECT_EQ(item.options.noise, 0.01) << item.name;
  }
}

TEST(ChallengeMatrix_behaviour, has_the_levels_of_noise_of_each_family) {
  std::map<std::string, std::map<double, int>> levels;
  for (const auto& item : challenge_matrix(false, 0)) ++levels[item.family][item.options.noise];
  EXPECT_EQ(levels["null"], (std::map<double, int>{{0.003, 10}, {0.01, 10}, {0.03, 10}}));
  EXPECT_EQ(levels["pair"], (std::map<double, int>{{0.005, 20}, {0.01, 20}}));
  EXPECT_EQ(levels["out_of_catalogue"], (std::map<double, int>{{0.003, 6}, {0.01, 6}, {0.02, 6}}));
  EXPECT_EQ(levels["finite_elements"], (std::map<double, int>{{0.005, 10}, {0.01, 10}, {0.02, 10}}));
  EXPECT_EQ(levels["decoy"], (std::map<double, int>{{0.01, 8}}));
  EXPECT_EQ(levels["indistinguishable"], (std::map<double, int>{{0.01, 8}}));
  EXPECT_EQ(levels["single"].size(), 5u);  // traces 0.003 to 0.03, series 0.005 to 0.02
}

/// Two numbers of what a seed conceals: root mean square, and a sum in which places differ.
struct WorldDigest {
  Motion mode;
  const char *effect, *setting;
  unsigned seed;
  std::size_t rows;
  double size, order;
};

WorldDigest digest_of(const WorldDigest& known) {
  WorldDigest found = known;
  std::vector<std::string> effects;
  if (*known.effect) effects = {known.effect};
  const ConcealedRecording concealed = conceal({known.mode, effects, 0.01, known.seed, known.setting});
  const RecordingTable& table = concealed.recording.tables[0];
  const auto& response = table.column(table.response);
  found.rows = response.size(), found.size = found.order = 0;
  for (std::size_t i = 0; i < response.size(); ++i) {
    found.size += response[i] * response[i] / static_cast<double>(response.size());
    found.order += response[i] * std::cos(0.1 * static_cast<double>(i));
  }
  found.size = std::sqrt(found.size);
  found.order /= found.size * static_cast<double>(response.size());
  return found;
}

const std::vector<WorldDigest>& known_worlds() {
  static const std::vector<WorldDigest> list{
      {Motion::normal, "", "", 3u, 780, 1.20217752e-08, -1.58829393e-05},
      {Motion::normal, "instrument_compliance", "", 1u, 780, 8.22651021e-05, -0.00365239677},
      {Motion::normal, "instrument_compliance", "", 2u, 780, 0.000396734281, -0.00423206414},
      {Motion::normal, "contact_point_offset", "", 1u, 780, 0.000122913515, -0.00285426991},
      {Motion::normal, "contact_point_offset", "", 2u, 780, 0.000365297417, 0.00904195926},
      {Motion::normal, "thermal_drift", "", 1u, 780, 0.000108755591, -0.0050286966},
      {Motion::normal, "thermal_drift", "", 2u, 780, 0.000459301927, 0.00193382745},
      {Motion::normal, "adhesion", "", 1u, 780, 1.34506501e-05, -0.00312546799},
      {Motion::normal, "adhesion", "", 2u, 780, 2.10431308e-05, -0.00100116371},
      {Motion::normal, "effective_radius", "", 1u, 780, 7.69158996e-05, -0.00289679179},
      {Motion::normal, "effective_radius", "", 2u, 780, 0.000703293801, -0.00250242947},
      {Motion::normal, "bulk_plasticity", "", 1u, 780, 0.000655681778, -0.00974072958},
      {Motion::normal, "bulk_plasticity", "", 2u, 780, 0.000897786855, -0.00673262718},
      {Motion::normal, "roughness_compliance", "", 1u, 780, 5.03375581e-05, -2.28369563e-05},
      {Motion::normal, "roughness_compliance", "", 2u, 780, 8.95761196e-05, 0.00246923659},
      {Motion::normal, "creep", "", 1u, 930, 8.8727978e-09, -0.00941532324},
      {Motion::normal, "creep", "", 2u, 930, 3.09673294e-08, -0.0100713708},
      {Motion::normal, "baseline_tilt", "", 1u, 780, 8.43541366e-05, -0.00129526782},
      {Motion::normal, "baseline_tilt", "", 2u, 780, 0.000660817373, -0.00428634021},
      {Motion::normal, "adhesion_hysteresis", "", 1u, 780, 1.45341341e-05, -0.00612539865},
      {Motion::normal, "adhesion_hysteresis", "", 2u, 780, 2.43890513e-05, 0.0033249311},
      {Motion::normal, "pop_in", "", 1u, 780, 8.42389936e-05, -0.004435515},
      {Motion::normal, "pop_in", "", 4u, 780, 0.000360678539, -0.00532602514},
      {Motion::normal, "interference", "", 1u, 780, 9.53100266e-05, -0.000990562224},
      {Motion::normal, "interference", "", 4u, 780, 0.000434662884, -8.55378346e-05},
      {Motion::normal, "piezo_hysteresis", "", 1u, 780, 9.70314552e-05, 0.00662443351},
      {Motion::normal, "piezo_hysteresis", "", 4u, 780, 0.000436752935, 0.00918050711},
      {Motion::normal, "thermal_oscillation", "", 1u, 780, 9.56925347e-05, -0.0113030151},
      {Motion::normal, "thermal_oscillation", "", 4u, 780, 0.00042745209, -0.00391469314},
      {Motion::sliding, "", "", 3u, 1080, 2.98193421e-05, 0.0211606534},
      {Motion::sliding, "lateral_compliance", "", 1u, 1080, 2.05027094e-05, 0.0162282288},
      {Motion::sliding, "lateral_compliance", "", 2u, 1080, 6.1356445e-05, 0.0139957726},
      {Motion::sliding, "adhesion_offset", "", 1u, 1080, 2.32952213e-05, 0.0197585163},
      {Motion::sliding, "adhesion_offset", "", 2u, 1080, 7.49587436e-05, 0.019631927},
      {Motion::sliding, "static_friction_peak", "", 1u, 1080, 2.14913322e-05, 0.022075527},
      {Motion::sliding, "static_friction_peak", "", 2u, 1080, 6.90254238e-05, 0.0253482334},
      {Motion::sliding, "velocity_dependence", "", 1u, 900, 2.68781375e-05, -0.00344990828},
      {Motion::sliding, "velocity_dependence", "", 2u, 900, 8.22769876e-05, 0.00763614502},
      {Motion::sliding, "partial_slip", "", 1u, 500, 0.000233652412, -0.0689133891},
      {Motion::sliding, "partial_slip", "", 2u, 500, 0.000608048172, -0.0139012159},
      {Motion::sliding, "surface_tilt", "", 1u, 1080, 2.10259152e-05, 0.0194409461},
      {Motion::sliding, "surface_tilt", "", 2u, 1080, 6.61943762e-05, 0.0241018945},
      {Motion::sliding, "lateral_zero_offset", "", 1u, 1080, 2.10717979e-05, 0.0206883424},
      {Motion::sliding, "lateral_zero_offset", "", 2u, 1080, 6.63864539e-05, 0.0227088423},
      {Motion::sliding, "area_proportional_friction", "", 1u, 1080, 1.85270077e-05, 0.0172749102},
      {Motion::sliding, "area_proportional_friction", "", 2u, 1080, 5.64679327e-05, 0.0178595607},
      {Motion::sliding, "run_in", "", 1u, 1960, 2.89247549e-05, 0.0137280555},
      {Motion::sliding, "run_in", "", 2u, 1960, 9.92532562e-05, 0.0142497007},
      {Motion::sliding, "stick_slip", "", 1u, 1200, 3.34735991e-05, 0.000338651268},
      {Motion::sliding, "stick_slip", "", 2u, 1200, 9.78414735e-05, -0.000136776377},
      {Motion::sliding, "rate_and_state", "", 1u, 800, 3.6237216e-05, -0.0113884983},
      {Motion::sliding, "rate_and_state", "", 2u, 800, 0.000106356931, -0.0136901748},
      {Motion::sliding, "position_weakening", "", 1u, 1080, 1.97833552e-05, 0.0399381294},
      {Motion::sliding, "position_weakening", "", 4u, 1080, 4.17007938e-05, 0.0325955875},
      {Motion::sliding, "lateral_oscillation", "", 1u, 1080, 2.11803187e-05, 0.0212816557},
      {Motion::sliding, "lateral_oscillation", "", 4u, 1080, 4.31075825e-05, 0.0213634483},
      {Motion::rolling, "", "", 3u, 48, 9.61643594e-07, -0.00370086443},
      {Motion::rolling, "rolling_adhesion_offset", "", 1u, 48, 9.05296992e-07, -0.00107907678},
      {Motion::rolling, "rolling_adhesion_offset", "", 2u, 48, 5.59066762e-06, 0.00281734676},
      {Motion::rolling, "contact_radius_scaling", "", 1u, 48, 7.13417992e-07, -0.0090075438},
      {Motion::rolling, "contact_radius_scaling", "", 2u, 48, 3.84494462e-06, -0.00575961913},
      {Motion::rolling, "roughness_dependent_rolling", "", 1u, 84, 3.9500977e-07, 0.00974145777},
      {Motion::rolling, "roughness_dependent_rolling", "", 2u, 84, 2.98317109e-06, 0.0138907892},
      {Motion::rolling, "viscous_rolling", "", 1u, 56, 8.44203585e-07, -0.00586627193},
      {Motion::rolling, "viscous_rolling", "", 2u, 56, 4.96623494e-06, -0.0042208217},
      {Motion::rolling, "resistance_peak", "", 1u, 48, 6.68324698e-07, -0.00326817623},
      {Motion::rolling, "resistance_peak", "", 4u, 48, 1.7705554e-06, 0.000265196542},
      {Motion::rail, "", "", 3u, 21, 1.22025255e-06, 0.29338931},
      {Motion::rail, "torsion_resistance", "", 1u, 21, 2.78406882e-06, 0.151362848},
      {Motion::rail, "torsion_resistance", "", 2u, 21, 2.12565594e-05, 0.133837874},
      {Motion::rail, "rolling_adhesion_offset", "", 1u, 21, 1.20250478e-06, 0.35761188},
      {Motion::rail, "rolling_adhesion_offset", "", 2u, 21, 7.48306896e-06, 0.37519368},
      {Motion::rail, "viscous_rolling", "", 1u, 84, 1.00878583e-06, 0.0720522591},
      {Motion::rail, "viscous_rolling", "", 2u, 84, 5.93616922e-06, 0.0649317101},
      {Motion::torsion, "", "", 3u, 24, 9.52685185e-07, 0.0122348302},
      {Motion::torsion, "contact_radius_scaling", "", 1u, 24, 7.46674941e-07, -0.0431228551},
      {Motion::torsion, "contact_radius_scaling", "", 2u, 24, 4.0516851e-06, -0.0447221629},
      {Motion::sliding, "surface_tilt", "one_load", 1u, 510, 3.67813571e-05, -0.00135493356},
      {Motion::sliding, "lateral_compliance", "small_loops", 1u, 500, 0.000232754118, -0.0553593565},
      {Motion::normal, "thermal_drift", "ramp_only", 1u, 220, 8.25285507e-09, -0.00605858739},
      {Motion::normal, "thermal_drift", "long_hold", 1u, 930, 6.04908818e-09, -0.00315624568},
  };
  return list;
}

/// A seed is an experiment: scores of a challenge can be compared only while it conceals the same.
TEST(ConcealedWorlds_regression, seeds_conceal_what_they_always_did) {
  for (const WorldDigest& known : known_worlds()) {
    const WorldDigest found = digest_of(known);
    const std::string name =
        name_of(known.mode) + " " + known.effect + " " + known.setting + " " + std::to_string(known.seed);
    EXPECT_EQ(found.rows, known.rows) << name;
    EXPECT_NEAR(found.size / known.size, 1, 1e-6) << name;
    EXPECT_NEAR(found.order, known.order, 1e-6) << name;
  }
  std::size_t effects = 0;
  for (const Motion mode : all_modes())
    effects += concealable_effects(mode).size() + out_of_catalogue_effects(mode).size();
  EXPECT_GE(known_worlds().size(), effects);
}

}  // namespace
}  // namespace asperity
