// Batches of cells that threads may write at the same time.
#include <deal.II/base/multithread_info.h>
#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <set>
#include <vector>

#include "fem/case/case_setup.h"
#include "fem/contact/contact_system.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

/// What for_each_run() hands out, in the order of its calls: the batches of the threads, then the rest.
std::vector<std::vector<int>> runs_of(const fem::MeshLevel& level) {
  std::vector<std::vector<int>> runs;
  std::mutex mutex;
  level.for_each_run([&](const int* first, const int* last) {
    const std::lock_guard<std::mutex> lock(mutex);
    runs.emplace_back(first, last);
  });
  return runs;
}

TEST(ThreadRuns_analytic, no_two_threads_write_a_node_and_few_batches_wait) {
  const unsigned before = dealii::MultithreadInfo::n_threads();
  double most_waiting = 0;
  for (const int threads : {2, 3, 4}) {
    dealii::MultithreadInfo::set_thread_limit(static_cast<unsigned>(threads));
    const fem::CaseSetup setup = fem::set_up(test::sphere_on_silicon("smooth", "smooth", 20e-9, 0));
    fem::ContactSystem system(MPI_COMM_WORLD, setup.system);
    const fem::MeshLevel& level = system.level();
    const auto runs = runs_of(level);
    // Rounds of as many runs as threads, then what one thread does alone.
    const auto in_round = static_cast<std::size_t>(threads);
    ASSERT_GT(runs.size(), in_round);
    ASSERT_EQ(runs.size() % in_round, 1u);
    std::multiset<int> handed_out;
    std::map<int, std::size_t> run_of_node;
    for (std::size_t run = 0; run < runs.size(); ++run) {
      handed_out.insert(runs[run].begin(), runs[run].end());
      if (run % in_round == 0) run_of_node.clear();
      for (const int batch : runs[run])
        for (const auto& nodes : level.batches()[static_cast<std::size_t>(batch)].node)
          for (const int node : nodes) ASSERT_EQ(run_of_node.emplace(node, run).first->second, run);
    }
    EXPECT_EQ(handed_out.size(), level.batches().size());
    EXPECT_EQ(std::set<int>(handed_out.begin(), handed_out.end()).size(), level.batches().size());
    most_waiting = std::max(most_waiting, static_cast<double>(runs.back().size()) /
                                              static_cast<double>(level.batches().size()) / (threads - 1));
  }
  dealii::MultithreadInfo::set_thread_limit(before);
  EXPECT_TRUE((test::Verified{"Meshes", "cell batches that wait for each further thread",
                              "batches in slabs of equal number"}
                   .below(100 * most_waiting, 5, "%")));
}

}  // namespace
