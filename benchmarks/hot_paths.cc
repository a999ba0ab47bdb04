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
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/case_file.h"
#include "fem/case/case_setup.h"
#include "fem/contact/contact_solver.h"
#include "fem/solver/matrix_free_solver.h"
#include "surfaces/fft2d.h"
#include "surfaces/generate.h"
#include "surfaces/sampler.h"
#include "surfaces/spectrum.h"

namespace {

using namespace asperity;
using namespace asperity::fem;

/// The rough contact of rough_contact.prm at its largest load, on a mesh of 3e5 unknowns.
struct Scene {
  std::unique_ptr<ContactSystem> system;
  ContactState state;
  TangentField tangent;
  std::vector<RowStiffness> stiffness;  ///< of the rows in contact
  HexOperator<double> exact;
  HexOperator<float> single;
  std::unique_ptr<meshing::Triangulation> coarse_forest;
  std::unique_ptr<MeshLevel> coarse;
  double yielding = 0;  ///< share of the cell batches with plastic tangents

  static ContactSystemOptions options() {
    return set_up(read_case(ASPERITY_SOURCE_DIR "/benchmarks/rough_contact.prm",
                            {"Mesh/Interface spacing=10 nm"}))
        .system;
  }
  Scene()
      : system(std::make_unique<ContactSystem>(MPI_COMM_WORLD, options())),
        exact(system->level(), system->positions(), system->options().materials),
        single(system->level(), system->positions(), system->options().materials) {
    const CaseSetup setup = set_up(
        read_case(ASPERITY_SOURCE_DIR "/benchmarks/rough_contact.prm", {"Mesh/Interface spacing=10 nm"}));
    ContactSolver solver(*system, {});
    state = solver.first_touch();
    solver.push_rigidly(state, 0.8 * setup.hertz_approach);
    if (!solver.solve(state, setup.largest_load).converged)
      throw std::runtime_error("the contact to be measured was not solved");
    for (std::size_t r = 0; r < state.multiplier.size(); ++r)
      stiffness.push_back(state.multiplier[r] > 0
                              ? 8 * system->reduced_modulus() /
                                    system->options().mesh.sizes.spacing_particle * system->areas()[r]
                              : 0.0);
    Vector<double> force = vector<double>();
    system->bodies().internal_force(state.displacement, force, &tangent);
    for (const auto& batch : tangent.batch)
      yielding += batch ? 1.0 / static_cast<double>(tangent.batch.size()) : 0.0;
    system->interface().set_stiffness(stiffness);
    exact.set_interface(&system->interface());
    single.set_interface(&system->interface());
    multigrid().update(stiffness, &tangent, 0.0);
    coarse_forest = meshing::make_forest(MPI_COMM_WORLD, system->options().mesh, 1);
    coarse = std::make_unique<MeshLevel>(*coarse_forest, system->options().control);
  }

  Multigrid& multigrid() { return dynamic_cast<MatrixFreeSolver&>(system->linear()).multigrid(); }
  double unknowns() const { return static_cast<double>(system->level().size()); }
  template <typename Number>
  Vector<Number> vector() const {
    Vector<Number> v;
    system->level().initialise(v);
    return v;
  }
  /// The solution as a vector to apply operators to, of unit size.
  template <typename Number>
  Vector<Number> sample() const {
    Vector<Number> v = vector<Number>();
    const double scale = 1 / state.displacement.linfty_norm();
    for (unsigned i = 0; i < v.locally_owned_size(); ++i)
      v.local_element(i) = static_cast<Number>(scale * state.displacement.local_element(i));
    return v;
  }
};

std::unique_ptr<Scene> scene;

void count(benchmark::State& state, double items, double bytes = 0) {
  state.counters["items"] = items;
  state.counters["items/s"] = benchmark::Counter(items, benchmark::Counter::kIsIterationInvariantRate);
  if (bytes > 0)
    state.counters["bytes/s"] =
        benchmark::Counter(bytes, benchmark::Counter::kIsIterationInvariantRate, benchmark::Counter::kIs1024);
}

// What memory alone allows: y = x + a z over vectors as long as the solution.
template <typename Number>
void triad(benchmark::State& state) {
  const Vector<Number> x = scene->sample<Number>(), z = x;
  Vector<Number> y = scene->vector<Number>();
  const int n = static_cast<int>(scene->unknowns());
  const Number *a = x.begin(), *b = z.begin();
  Number* c = y.begin();
  for (auto _ : state) {
    for_entries(n, [=](int i) { c[i] = a[i] + Number(0.3) * b[i]; });
    benchmark::ClobberMemory();
  }
  count(state, scene->unknowns(), 3 * sizeof(Number) * scene->unknowns());
}

template <typename Number>
HexOperator<Number>& matrix_of(Scene& s);
template <>
HexOperator<double>& matrix_of<double>(Scene& s) {
  return s.exact;
}
template <>
HexOperator<float>& matrix_of<float>(Scene& s) {
  return s.single;
}

template <typename Number, bool yielding>
void stiffness(benchmark::State& state) {
  auto& matrix = matrix_of<Number>(*scene);
  matrix.set_tangent(yielding ? &scene->tangent : nullptr);
  const Vector<Number> x = scene->sample<Number>();
  Vector<Number> y = scene->vector<Number>();
  for (auto _ : state) matrix.vmult(y, x);
  // Least traffic: positions and x read, y read and written, node numbers.
  count(state, scene->unknowns(),
        4 * sizeof(Number) * scene->unknowns() +
            static_cast<double>(scene->system->level().batches().size() * sizeof(CellBatch)));
  if (yielding) state.counters["yielding"] = scene->yielding;
}

template <bool yielding>
void internal_force(benchmark::State& state) {
  Vector<double> force = scene->vector<double>();
  Vector<double> u = scene->state.displacement;
  if (!yielding) u *= 1e-3;
  TangentField tangent;
  for (auto _ : state) scene->system->bodies().internal_force(u, force, &tangent);
  count(state, scene->unknowns());
}

// Eight points at once, all beyond yield.
void return_mapping(benchmark::State& state) {
  J2Material material = J2Material::elastic(71e9, 0.17);
  material.yield_stress = 3e9;
  const J2Material* lane[lanes];
  Simd<double> shear;
  for (int l = 0; l < lanes; ++l) lane[l] = &material, shear[l] = material.shear_modulus;
  SymmetricTensor<Simd<double>> strain;
  for (int c = 0; c < 6; ++c)
    for (int l = 0; l < lanes; ++l) strain[c][l] = 0.1 * std::sin(1.0 + 3 * c + l);
  for (auto _ : state) {
    PlasticState<Simd<double>> history{};
    SymmetricTensor<Simd<double>> stress;
    J2Tangent<Simd<double>> tangent;
    benchmark::DoNotOptimize(strain);
    benchmark::DoNotOptimize(return_map(lane, shear, strain, history, stress, tangent));
    benchmark::DoNotOptimize(stress);
    benchmark::DoNotOptimize(tangent);
  }
  count(state, lanes);
}
// Eight points at once, all relaxing.
void relaxation(benchmark::State& state) {
  const RelaxationStep step({0.5, 1.0}, 0.3);
  SymmetricTensor<Simd<double>> before, now, viscous{};
  for (int c = 0; c < 6; ++c)
    for (int l = 0; l < lanes; ++l)
      before[c][l] = 0.1 * std::sin(1.0 + 3 * c + l), now[c][l] = 1.1 * before[c][l];
  for (auto _ : state) {
    benchmark::DoNotOptimize(now);
    for (int l = 0; l < lanes; ++l) relax(step, before, now, l, viscous);
    benchmark::DoNotOptimize(viscous);
  }
  count(state, lanes);
}
// Their reference: the same points' deviatoric stress without yielding.
void elastic_stress(benchmark::State& state) {
  const Simd<double> shear = Simd<double>{} + 30e9;
  SymmetricTensor<Simd<double>> strain;
  for (int c = 0; c < 6; ++c) strain[c] = Simd<double>{} + 0.1 * (c + 1);
  for (auto _ : state) {
    SymmetricTensor<Simd<double>> stress;
    benchmark::DoNotOptimize(strain);
    for (int c = 0; c < 6; ++c) stress[c] = 2.0 * shear * strain[c];
    benchmark::DoNotOptimize(stress);
  }
  count(state, lanes);
}

template <typename Number>
void interface_stiffness(benchmark::State& state) {
  const Vector<Number> x = scene->sample<Number>();
  Vector<Number> y = scene->vector<Number>();
  const auto& interface = scene->system->interface();
  for (auto _ : state) interface.apply(x.begin(), y.begin());
  count(state, scene->unknowns());
  state.counters["closed"] = static_cast<double>(interface.active().size());
}

void chebyshev(benchmark::State& state) {
  scene->single.set_tangent(&scene->tangent);
  Chebyshev smoother;
  smoother.update(scene->single);
  const Vector<float> b = scene->sample<float>();
  Vector<float> x = scene->vector<float>();
  for (auto _ : state) smoother.smooth(scene->single, x, b, false);
  count(state, scene->unknowns());
}

void v_cycle(benchmark::State& state) {
  const Vector<double> b = scene->sample<double>();
  Vector<double> x = scene->vector<double>();
  for (auto _ : state) scene->multigrid().vmult(x, b);
  count(state, scene->unknowns());
}

void multigrid_update(benchmark::State& state) {
  for (auto _ : state) scene->multigrid().update(scene->stiffness, &scene->tangent, 0.0);
  count(state, scene->unknowns());
}

// A linear solution to 1e-3 as a Newton step asks for it, with a new active set, by either path.
void solution(benchmark::State& state, LinearSolver& linear) {
  Vector<double> x = scene->vector<double>(), load = scene->vector<double>();
  load.local_element(scene->system->level().local_driven_dof()) = -1;
  int iterations = 0;
  for (auto _ : state) {
    linear.update(scene->stiffness, &scene->tangent, 0.0);
    iterations = linear.solve(x, load, 1e-3);
  }
  count(state, scene->unknowns());
  state.counters["cg"] = iterations;
}
void matrix_free_solution(benchmark::State& state) { solution(state, scene->system->linear()); }
void assembled_solution(benchmark::State& state) {
  auto& s = *scene->system;
  const auto assembled =
      make_linear_solver("assembled", {s.level(), s.positions(), s.options().materials, s.interface(),
                                       s.rows(), s.options().mesh, s.geometry(), s.options().control});
  solution(state, *assembled);
}

void level_transfer(benchmark::State& state) {
  const LevelTransfer transfer(scene->system->level(), *scene->coarse);
  Vector<float> fine = scene->sample<float>(), coarse;
  scene->coarse->initialise(coarse);
  for (auto _ : state) {
    transfer.restrict_to(coarse, fine);
    coarse *= 1e-3f;
    transfer.prolongate_and_add(fine, coarse);
  }
  count(state, scene->unknowns());
}

void forest_set_up(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(meshing::make_forest(MPI_COMM_WORLD, scene->system->options().mesh));
  count(state, scene->unknowns());
}
void level_set_up(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(
        std::make_unique<MeshLevel>(scene->system->forest(), scene->system->options().control));
  count(state, scene->unknowns());
}
void system_set_up(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(std::make_unique<ContactSystem>(MPI_COMM_WORLD, scene->system->options()));
  count(state, scene->unknowns());
}

std::vector<PlaneFace> lattice(int cells, double width, double offset) {
  std::vector<PlaneFace> faces;
  const double h = width / cells;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int n = j * (cells + 1) + i;
      faces.push_back({offset - width / 2 + i * h,
                       offset - width / 2 + (i + 1) * h,
                       offset - width / 2 + j * h,
                       offset - width / 2 + (j + 1) * h,
                       {n, n + 1, n + cells + 1, n + cells + 2}});
    }
  return faces;
}
void mortar_coupling(benchmark::State& state) {
  const auto particle = lattice(106, 1.06e-6, 0), substrate = lattice(118, 1.1e-6, 1.3e-9);
  std::size_t rows = 0;
  for (auto _ : state) rows = couple_interfaces(quads(particle), substrate).size();
  count(state, static_cast<double>(rows));
}

constexpr int pixels = 1024;
const SelfAffineSpectrum spectrum{1.5e-9, 0.8, 200e-9, 20e-9};
Topography surface() {
  GenerateOptions options;
  options.nx = options.ny = pixels;
  options.lx = options.ly = 5e-6;
  options.rms = spectrum.rms;
  return generate_periodic(spectrum, options);
}
void fourier_transform(benchmark::State& state) {
  const Topography map = surface();
  for (auto _ : state) benchmark::DoNotOptimize(forward_fft(map.heights, pixels, pixels));
  count(state, pixels * pixels);
}
void surface_generation(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(surface());
  count(state, pixels * pixels);
}
void power_spectrum(benchmark::State& state) {
  const Topography map = surface();
  for (auto _ : state) benchmark::DoNotOptimize(radial_spectrum(map));
  count(state, pixels * pixels);
}
void sampler_set_up(benchmark::State& state) {
  const Topography map = surface();
  for (auto _ : state) benchmark::DoNotOptimize(HeightSampler(map));
  count(state, pixels * pixels);
}
void height_samples(benchmark::State& state) {
  const HeightSampler sampler(surface());
  constexpr int points = 10000;
  double sum = 0;
  for (auto _ : state)
    for (int k = 0; k < points; ++k)
      sum += sampler.height(5e-7 * std::sin(0.7 * k), 5e-7 * std::cos(1.1 * k));
  benchmark::DoNotOptimize(sum);
  count(state, points);
}

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

void register_all() {
  constexpr int repetitions = 3;
  constexpr double least_seconds = 0.2;
  const auto add = [&](const char* name, void (*run)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, run)
        ->UseRealTime()
        ->Repetitions(repetitions)
        ->MinTime(least_seconds)
        ->Unit(benchmark::kMillisecond);
  };
  add("triad, double", triad<double>);
  add("triad, float", triad<float>);
  add("stiffness, double", stiffness<double, false>);
  add("stiffness, float", stiffness<float, false>);
  add("stiffness with yielding, double", stiffness<double, true>);
  add("stiffness with yielding, float", stiffness<float, true>);
  add("internal force", internal_force<false>);
  add("internal force with yielding", internal_force<true>);
  add("return mapping", return_mapping);
  add("relaxation", relaxation);
  add("elastic stress", elastic_stress);
  add("interface, double", interface_stiffness<double>);
  add("interface, float", interface_stiffness<float>);
  add("Chebyshev smoothing", chebyshev);
  add("V-cycle", v_cycle);
  add("multigrid update", multigrid_update);
  add("solution, matrix-free", matrix_free_solution);
  add("level transfer", level_transfer);
  add("forest set-up", forest_set_up);
  add("mesh level set-up", level_set_up);
  add("system set-up", system_set_up);
  add("mortar coupling", mortar_coupling);
  add("surface generation", surface_generation);
  add("power spectrum", power_spectrum);
  add("Fourier transform", fourier_transform);
  add("sampler set-up", sampler_set_up);
  add("height samples", height_samples);
  benchmark::RegisterBenchmark("solution, assembled", assembled_solution)
      ->UseRealTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

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
  register_all();
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  collector.print_ratios();
  scene.reset();
  return 0;
}
