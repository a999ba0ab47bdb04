// Meshes, levels, the whole system and the coupling of both surfaces.
#include <memory>
#include <vector>

#include "benchmarks/hot_paths/measured_path.h"
#include "benchmarks/hot_paths/scene.h"

namespace asperity::hot_paths {
namespace {

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

}  // namespace

void add_set_up() {
  add("forest set-up", forest_set_up);
  add("mesh level set-up", level_set_up);
  add("system set-up", system_set_up);
  add("mortar coupling", mortar_coupling);
}

}  // namespace asperity::hot_paths
