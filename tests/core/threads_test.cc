#include "core/threads.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/thread_limit.h"

namespace {

using namespace asperity;

/// Runs `work` on at most so many threads.
template <typename Work>
void on_threads(std::size_t threads, const Work& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  work();
}

TEST(Threads_analytic, parts_hold_every_member_once_and_none_is_shorter_than_half_the_grain) {
  for (const int count : {0, 1, 7, 64, 1000, 12345}) {
    std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
    std::atomic<bool> too_short{false};
    constexpr int grain = 16;
    on_threads(3, [&] {
      for_parts(count, grain, [&](int first, int last) {
        if (last - first < std::min(count, grain / 2)) too_short = true;
        for (; first < last; ++first) ++visits[static_cast<std::size_t>(first)];
      });
    });
    for (const auto& visit : visits) ASSERT_EQ(visit, 1);
    EXPECT_FALSE(too_short) << count;
  }
}

TEST(Threads_analytic, sums_are_the_same_on_any_number_of_threads_and_may_change_their_entries) {
  constexpr int count = 100001;
  double first = 0;
  for (const std::size_t threads : {1u, 2u, 3u}) {
    std::vector<double> values(count);
    double* value = values.data();
    double sum = 0;
    on_threads(threads, [&] {
      for_entries(count, [=](int i) { value[i] = 1.0 / (1 + i); });
      sum = sum_over_entries(count, [=](int i) {
        value[i] *= 2;
        return value[i];
      });
    });
    if (threads == 1) first = sum;
    EXPECT_EQ(sum, first);
    EXPECT_EQ(values[9], 0.2);
  }
  constexpr double euler = 0.57721566490153286;  // of the harmonic series: ln n + euler + 1/2n
  EXPECT_NEAR(first, 2 * (std::log(count) + euler + 0.5 / count), 1e-9);
  EXPECT_EQ(sum_over_entries(0, [](int) { return 1.0; }), 0);
}

TEST(Threads_behaviour, a_limit_of_one_leaves_all_to_the_caller_until_it_is_lifted) {
  const auto allowed = [] {
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  };
  const char* set = std::getenv("OMP_NUM_THREADS");
  const std::string own_setting = set ? set : "";
  const std::size_t before = allowed();
  const auto own = std::this_thread::get_id();
  std::atomic<bool> elsewhere{false};
  ASSERT_EQ(::setenv("OMP_NUM_THREADS", "1", 1), 0);
  limit_threads_by_environment();
  ASSERT_EQ(::setenv("OMP_NUM_THREADS", "some", 1), 0);
  limit_threads_by_environment();  // not a number: as it was
  for_parts(1000, 1, [&](int, int) {
    if (std::this_thread::get_id() != own) elsewhere = true;
  });
  EXPECT_FALSE(elsewhere);
  EXPECT_EQ(allowed(), 1u);
  constexpr int all_cores = 0;
  limit_threads(all_cores);
  EXPECT_EQ(allowed(), before);
  if (set)
    ::setenv("OMP_NUM_THREADS", own_setting.c_str(), 1);
  else
    ::unsetenv("OMP_NUM_THREADS");
}

TEST(Threads_behaviour, a_failure_of_one_part_reaches_the_caller) {
  on_threads(2, [] {
    EXPECT_THROW(for_parts(1000, 10,
                           [](int first, int last) {
                             if (first <= 500 && 500 < last) throw std::runtime_error("here");
                           }),
                 std::runtime_error);
  });
}

}  // namespace
