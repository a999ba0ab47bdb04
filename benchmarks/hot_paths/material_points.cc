// Material laws, eight points at once.
#include <cmath>

#include "benchmarks/hot_paths/measured_path.h"
#include "benchmarks/hot_paths/scene.h"

namespace asperity::hot_paths {
namespace {

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

}  // namespace

void add_material_points() {
  add("return mapping", return_mapping);
  add("relaxation", relaxation);
  add("elastic stress", elastic_stress);
}

}  // namespace asperity::hot_paths
