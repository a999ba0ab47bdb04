// Where a residual is not noise: bins of the data, spikes that are left out, and what a region says.
#include "diagnosis/locate/scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "diagnosis/locate/waves.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

/// A trace up and down with white noise of a standard deviation of 4; residuals are counted in it.
struct ScannedTrace {
  static constexpr std::size_t half = 400, count = 2 * half;
  Samples samples = test::approach_and_back(0, 4e-8, half);
  Experiment experiment = test::experiment(Motion::normal);
  Noise noise;
  std::vector<double> residual;

  ScannedTrace() {
    samples.segment_names = {"load", "unload"};
    for (std::size_t i = half; i < count; ++i) samples.list[i].segment = samples.list[i].part = 1;
    samples.table_names = {"t.csv"};
    samples.response_channels = {"normal_force"};
    noise.sd.assign(count, 4.0);
    noise.shared = {{}};
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < count; ++i) residual.push_back(normal(random));
  }
  ScanResult scan(const std::vector<double>& tolerated = {}) const {
    std::vector<double> sized = residual, allowed = tolerated;
    for (double& r : sized) r *= 4;
    for (double& t : allowed) t *= 4;
    return Scanner(samples, experiment, noise, 1).scan(sized, allowed);
  }
};

TEST(Scan_behaviour, leaves_a_single_spike_out_and_keeps_two_neighbours) {
  for (const double sign : {1.0, -1.0}) {
    ScannedTrace one;
    one.residual[200] = 60 * sign;
    EXPECT_TRUE(one.scan().regions.empty());
    EXPECT_GT(one.scan().p_value, 0.01);
    // Two in a row are none: neither alike nor of opposite signs.
    ScannedTrace alike = one, opposite = one;
    alike.residual[201] = 60 * sign, opposite.residual[201] = -60 * sign;
    ASSERT_EQ(alike.scan().regions.size(), 1u);
    ASSERT_EQ(opposite.scan().regions.size(), 1u);
    EXPECT_GT(alike.scan().regions[0].size_in_noise * sign, 2);
    EXPECT_NEAR(opposite.scan().regions[0].size_in_noise, 0, 1);
    EXPECT_LT(opposite.scan().p_value, 1e-3);
  }
}

TEST(Scan_behaviour, leaves_a_spike_at_either_end_of_a_run_out_but_none_in_a_series) {
  ScannedTrace ends;
  ends.residual.front() = 60, ends.residual.back() = -60;
  EXPECT_TRUE(ends.scan().regions.empty());
  ends.samples.runs[0].independent_rows = true;
  EXPECT_FALSE(ends.scan().regions.empty());
}

TEST(Scan_analytic, tells_size_share_and_place_of_a_shift) {
  ScannedTrace shifted;
  for (std::size_t i = 100; i < 200; ++i) shifted.residual[i] -= 2;  // from 1e-8 to 2e-8 of the loading
  const ScanResult found = shifted.scan();
  ASSERT_EQ(found.regions.size(), 1u);
  const MismatchRegion& region = found.regions[0];
  EXPECT_EQ(region.table, "t.csv");
  EXPECT_EQ(region.channel, "normal_force");
  EXPECT_EQ(region.segment, "load");
  EXPECT_EQ(region.variable, "normal_displacement");
  EXPECT_EQ(region.unit, "m");
  EXPECT_NEAR(region.from, 1e-8, 0.15e-8);
  EXPECT_NEAR(region.to, 2e-8, 0.15e-8);
  EXPECT_NEAR(region.size_in_noise, -2, 0.35);
  EXPECT_GT(region.share, 0.8);
  EXPECT_LE(region.share, 1);
  EXPECT_LT(region.p_value, 1e-6);
  EXPECT_EQ(region.p_value, found.p_value);
}

TEST(Scan_analytic, sets_the_largest_region_first_and_gives_each_its_share) {
  ScannedTrace two;
  for (std::size_t i = 100; i < 150; ++i) two.residual[i] += 2;
  for (std::size_t i = 500; i < 700; ++i) two.residual[i] += 2;
  const auto regions = two.scan().regions;
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].segment, "unload");
  EXPECT_EQ(regions[1].segment, "load");
  EXPECT_NEAR(regions[0].share, 0.8, 0.12);
  EXPECT_NEAR(regions[1].share, 0.2, 0.12);
}

TEST(Scan_behaviour, does_not_count_what_the_laws_themselves_may_be_off_by) {
  ScannedTrace shifted;
  for (std::size_t i = 100; i < 200; ++i) shifted.residual[i] += 2;
  EXPECT_FALSE(shifted.scan(std::vector<double>(ScannedTrace::count, 0.1)).regions.empty());
  EXPECT_TRUE(shifted.scan(std::vector<double>(ScannedTrace::count, 3.0)).regions.empty());
}

TEST(Scan_behaviour, sees_noise_that_is_larger_than_stated_and_none_that_is_smaller) {
  ScannedTrace loud, quiet;
  for (double& r : loud.residual) r *= 1.6;
  for (double& r : quiet.residual) r *= 0.6;
  EXPECT_LT(loud.scan().p_value, 0.01);
  EXPECT_GT(quiet.scan().p_value, 0.2);
  EXPECT_TRUE(quiet.scan().regions.empty());
}

TEST(Scan_analytic, reduces_chi_squared_by_the_samples_that_count) {
  Samples samples = test::approach_and_back(0, 1e-8, 2);
  Noise noise;
  noise.sd = {1, 2, 4, 1};
  samples.list[3].counts = false;
  EXPECT_DOUBLE_EQ(chi2_reduced(samples, {2, 2, 4, 100}, noise), (4 + 1 + 1) / 3.0);
  EXPECT_EQ(chi2_reduced(samples, {}, noise), 0);
}

const View* view_of(const std::vector<View>& views, const std::string& segment, const std::string& variable) {
  for (const auto& view : views)
    if (view.segment == segment && view.variable == variable) return &view;
  return nullptr;
}

TEST(Views_analytic, cut_a_trace_into_bins_of_equal_count_along_its_displacement) {
  ScannedTrace trace;
  trace.samples.list[5].counts = false;
  const auto views = views_of(trace.samples, trace.experiment);
  ASSERT_FALSE(views.empty());
  EXPECT_EQ(views[0].variable, "");
  ASSERT_EQ(views[0].bins.size(), 1u);
  EXPECT_EQ(views[0].bins[0].samples.size(), ScannedTrace::count - 1);
  const View* load = view_of(views, "load", "normal_displacement");
  ASSERT_TRUE(load);
  ASSERT_EQ(load->bins.size(), 48u);  // 399 samples would make 49 of eight
  std::set<std::size_t> seen;
  for (std::size_t b = 0; b < 48; ++b) {
    const Bin& bin = load->bins[b];
    EXPECT_TRUE(bin.samples.size() == 8 || bin.samples.size() == 9) << b;
    if (b > 0) {
      EXPECT_GT(bin.from, load->bins[b - 1].to);
    }
    seen.insert(bin.samples.begin(), bin.samples.end());
  }
  EXPECT_EQ(seen.size(), 399u);
  EXPECT_EQ(seen.count(5), 0u);
  EXPECT_EQ(load->bins.front().from, 0);
  EXPECT_NEAR(load->bins.back().to, 4e-8, 1e-20);
  EXPECT_EQ(view_of(views, "load", "speed"), nullptr);
  EXPECT_EQ(view_of(views, "load", "cycle"), nullptr);  // there is one alone
}

TEST(Views_analytic, of_a_few_samples_have_eight_in_a_bin_and_of_a_series_one) {
  Samples samples = test::approach_and_back(0, 1e-8, 20);
  samples.table_names = {"t.csv"};
  const Experiment e = test::experiment(Motion::normal);
  EXPECT_EQ(view_of(views_of(samples, e), "only", "normal_displacement")->bins.size(), 5u);
  Samples rows = test::row(test::experiment(Motion::rolling), 1e-3);
  for (int i = 1; i < 12; ++i) {
    rows.list.push_back(rows.list[0]);
    rows.list.back().normal_force = 1e-3 * (1 + i % 4);
    rows.list.back().radius = i < 6 ? 8.5e-6 : 8.6e-6;  // closer than a fiftieth
  }
  test::close_run(rows, true);
  rows.table_names = {"s.csv"};
  const auto views = views_of(rows, test::experiment(Motion::rolling));
  const View* loads = view_of(views, "only", "normal_force");
  ASSERT_TRUE(loads);
  ASSERT_EQ(loads->bins.size(), 4u);
  for (std::size_t b = 0; b < 4; ++b) {
    EXPECT_EQ(loads->bins[b].samples.size(), 3u);
    EXPECT_EQ(loads->bins[b].from, loads->bins[b].to);
    EXPECT_NEAR(loads->bins[b].from, 1e-3 * double(b + 1), 1e-12);
  }
  EXPECT_EQ(view_of(views, "only", "radius"), nullptr);
  for (auto& s : rows.list) s.radius *= s.radius > 8.55e-6 ? 1.02 : 1;
  EXPECT_TRUE(view_of(views_of(rows, test::experiment(Motion::rolling)), "only", "radius"));
}

TEST(Views_behaviour, go_along_what_drives_and_in_a_hold_along_time) {
  Samples samples = test::approach_and_back(0, 1e-8, 100);
  samples.table_names = {"t.csv"};
  samples.segment_names = {"load", "hold"};
  for (std::size_t i = 0; i < 200; ++i) {
    Sample& s = samples.list[i];
    s.normal_force = 1e-4 * static_cast<double>(i), s.lateral_displacement = 1e-9 * static_cast<double>(i);
    s.segment = i < 100 ? 0 : 1, s.hold_time = i < 100 ? 0 : static_cast<double>(i - 100);
  }
  samples.runs[0].response_is_displacement = true;
  const auto force_driven = views_of(samples, test::experiment(Motion::normal));
  EXPECT_TRUE(view_of(force_driven, "load", "normal_force"));
  EXPECT_FALSE(view_of(force_driven, "load", "normal_displacement"));
  EXPECT_TRUE(view_of(force_driven, "hold", "time"));
  EXPECT_FALSE(view_of(force_driven, "hold", "normal_force"));
  const auto sliding = views_of(samples, test::experiment(Motion::sliding));
  EXPECT_TRUE(view_of(sliding, "load", "lateral_displacement"));
  EXPECT_TRUE(view_of(sliding, "load", "normal_force"));
}

/// Noise of which neighbours share all (memory 0.7), and a wave in time that looks like it in differences.
struct TraceWithWave : ScannedTrace {
  TraceWithWave(unsigned seed, double memory, double amplitude, double period) {
    noise.shared = {{memory > 0 ? 1.0 : 0.0, memory}};
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    double slow = normal(random);
    for (std::size_t i = 0; i < count; ++i) {
      residual[i] = 4 * (slow + amplitude * std::sin(2 * M_PI * static_cast<double>(i) / period));
      slow = memory * slow + std::sqrt(1 - memory * memory) * normal(random);
    }
  }
  double wave() const { return wave_left(samples, residual, noise); }
};

TEST(Waves_analytic, a_line_stands_out_of_a_smooth_spectrum_and_noise_has_none) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    EXPECT_EQ(TraceWithWave(seed, 0, 0, 16).wave(), 0) << seed;
    EXPECT_EQ(TraceWithWave(seed, 0.7, 0, 16).wave(), 0) << seed;
  }
  EXPECT_NEAR(TraceWithWave(1, 0, 1, 16).wave(), 16, 0.1);
  EXPECT_NEAR(TraceWithWave(1, 0.7, 1, 10.6).wave(), 10.67, 0.1);  // 12 of 128
  // Noise that is taken for shared (memory 0.7) because a wave of three deviations makes it look so.
  TraceWithWave taken_for_shared(1, 0, 3, 16);
  taken_for_shared.noise.sd.assign(ScannedTrace::count, 9.0);
  taken_for_shared.noise.shared = {{1, 0.7}};
  EXPECT_NEAR(taken_for_shared.wave(), 16, 0.1);
  TraceWithWave without_any(1, 0, 0, 16);
  without_any.residual.assign(ScannedTrace::count, 0.0);
  EXPECT_EQ(without_any.wave(), 0) << "a simulation that is the recording";
  // Neither slow structure nor rows without order.
  EXPECT_EQ(TraceWithWave(1, 0, 3, 400).wave(), 0);
  TraceWithWave rows(1, 0, 3, 16);
  rows.samples.runs[0].independent_rows = true;
  EXPECT_EQ(rows.wave(), 0);
}

}  // namespace
}  // namespace asperity
