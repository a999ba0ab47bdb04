// The paths where a solution spends its time, each against a reference measured in the same run: what is
// compared are times per unknown (or pixel, point), so that another machine or other work on this one cancels
// out.
//
//   hot_paths [--benchmark_filter=REGEX] [--benchmark_out=FILE]        OMP_NUM_THREADS=2 for two threads
#include <benchmark/benchmark.h>
#include <deal.II/base/mpi.h>
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/hot_paths/measured_path.h"
#include "benchmarks/hot_paths/scene.h"

namespace {

using namespace asperity::hot_paths;

/// A path, what it is compared with, and the reason.
struct Comparison {
  const char *path, *reference, *meaning;
};
constexpr Comparison comparisons[] = {
    {"stiffness, double", "triad, double", "operator against plain streaming of three vectors"},
    {"stiffness, float", "triad, float", "the same in single precision"},
    {"stiffness, float", "stiffness, double", "single against double precision"},
    {"stiffness with yielding, double", "stiffness, double", "what plastic tangents add"},
    {"stiffness with yielding, float", "stiffness, float", "the same in single precision"},
    {"internal force", "stiffness, double", "forces of elastic bodies against the operator"},
    {"internal force with yielding", "internal force", "what return mapping adds"},
    {"return mapping", "elastic stress", "a yielding point against an elastic one"},
    {"relaxation", "return mapping", "a relaxing point against a yielding one"},
    {"interface, float", "stiffness, float", "contact stiffness against the bodies'"},
    {"interface, double", "stiffness, double", "the same in double precision"},
    {"Chebyshev smoothing", "stiffness with yielding, float", "in operator applications (degree 4: four)"},
    {"V-cycle", "stiffness with yielding, float", "in operator applications (9 on the finest level)"},
    {"multigrid update", "V-cycle", "a new active set in V-cycles"},
    {"solution, assembled", "solution, matrix-free",
     "a Newton step's update and solution, algebraic against geometric multigrid"},
    {"level transfer", "stiffness, float", "there and back, against the operator"},
    {"forest set-up", "V-cycle", "in V-cycles"},
    {"mesh level set-up", "V-cycle", "in V-cycles"},
    {"system set-up", "V-cycle", "all levels, transfers and the coupling, in V-cycles"},
    {"surface generation", "Fourier transform", "a pixel in transforms"},
    {"power spectrum", "Fourier transform", "a pixel in transforms"},
    {"sampler set-up", "Fourier transform", "a pixel in transforms"},
    {"height samples", "Fourier transform", "a sample in pixels of a transform"},
    {"mortar coupling", "height samples", "a row in samples of a height"},
};

/// The console's table, and the shortest time per item of each path.
class Collector : public benchmark::ConsoleReporter {
 public:
  Collector() : ConsoleReporter(isatty(STDOUT_FILENO) ? OO_ColorTabular : OO_Tabular) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const auto& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double seconds =
          run.real_accumulated_time / static_cast<double>(run.iterations) / run.counters.at("items");
      const auto [known, added] = shortest_.emplace(run.run_name.function_name, seconds);
      if (!added) known->second = std::min(known->second, seconds);
    }
    ConsoleReporter::ReportRuns(runs);
  }
  void print_ratios() const {
    std::printf("\n%-34s %-34s %8s  %s\n", "path", "reference", "ratio",
                "times per item, shortest of the repetitions");
    for (const auto& c : comparisons)
      if (shortest_.count(c.path) && shortest_.count(c.reference))
        std::printf("%-34s %-34s %8.2f  %s\n", c.path, c.reference,
                    shortest_.at(c.path) / shortest_.at(c.reference), c.meaning);
  }

 private:
  std::map<std::string, double> shortest_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  int no_arguments = 0;
  char** none = nullptr;
  const dealii::Utilities::MPI::MPI_InitFinalize session(no_arguments, none,
                                                         static_cast<unsigned>(omp_get_max_threads()));
  scene = std::make_unique<Scene>();
  std::printf("%.0f unknowns, %d threads, %.1f %% of the cells yielding\n", scene->unknowns(),
              omp_get_max_threads(), 100 * scene->yielding);
  add_operators(), add_material_points(), add_set_up(), add_surfaces();
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  collector.print_ratios();
  scene.reset();
  return 0;
}
