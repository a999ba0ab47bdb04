// Operators on the solution, smoother, multigrid and linear solutions.
#include "benchmarks/hot_paths/measured_path.h"
#include "benchmarks/hot_paths/scene.h"

namespace asperity::hot_paths {
namespace {

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
  Vector<float> x = scene->vector<float>(), scratch = scene->vector<float>();
  for (auto _ : state) smoother.smooth(scene->single, x, b, false, scratch);
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

}  // namespace

void add_operators() {
  add("triad, double", triad<double>);
  add("triad, float", triad<float>);
  add("stiffness, double", stiffness<double, false>);
  add("stiffness, float", stiffness<float, false>);
  add("stiffness with yielding, double", stiffness<double, true>);
  add("stiffness with yielding, float", stiffness<float, true>);
  add("internal force", internal_force<false>);
  add("internal force with yielding", internal_force<true>);
  add("interface, double", interface_stiffness<double>);
  add("interface, float", interface_stiffness<float>);
  add("Chebyshev smoothing", chebyshev);
  add("V-cycle", v_cycle);
  add("multigrid update", multigrid_update);
  add("solution, matrix-free", matrix_free_solution);
  add("level transfer", level_transfer);
  benchmark::RegisterBenchmark("solution, assembled", assembled_solution)
      ->UseRealTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace asperity::hot_paths
