#include "engines/many_particles/particle_box.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/hertz.h"
#include "core/quantity.h"
#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/time_step.h"

namespace asperity {
namespace {

constexpr double spacing_over_diameter = 1.1, jitter = 0.04;  // of the spacing; no two overlap
constexpr double impacts_per_particle = 6;
constexpr long rows = 200;

std::vector<std::size_t> particle_materials(const MaterialMatrix& matrix) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < matrix.materials.size(); ++i)
    if (matrix.materials[i].density > 0) found.push_back(i);
  return found;  // time_step_of() has refused none at all
}

/// Work of loading up to a force [J]: Hertz' (2/5) F delta; Luding's straight lines k1 and, from delta_p on,
/// k_p.
double work_of_loading(const PairLaw& law, double effective_radius, double load) {
  if (!law.luding) return Hertz{law.reduced_modulus, effective_radius}.elastic_energy(load);
  const double k1 = law.luding->k1 * effective_radius, kp = law.luding->kp * effective_radius,
               knee = k1 * law.luding->full_approach(effective_radius);
  const double below = std::min(load, knee);
  return below * below / (2 * k1) + (load * load - below * below) / (2 * kp);
}

/// Of two equal particles: the work of loading is (1/2) (m/2) (2 v)^2.
double speed_of_impact(const MaterialMatrix& matrix, std::size_t material, double load) {
  const double R = matrix.smallest_radius;
  const double mass = 4.0 / 3 * M_PI * R * R * R * matrix.materials[material].density;
  return std::sqrt(work_of_loading(matrix.pair(material, material).law, R / 2, load) / mass);
}

/// On the unit sphere, from two random numbers of [0, 1).
std::array<double, 3> direction(double height, double turn) {
  const double z = 2 * height - 1, r = std::sqrt(1 - z * z), phi = 2 * M_PI * turn;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

}  // namespace

ParticleBox particle_box(const MaterialMatrix& matrix, int count) {
  if (count < 1) throw InputError("a box needs one particle at least");
  const TimeStep step = time_step_of(matrix);
  const std::vector<std::size_t> materials = particle_materials(matrix);
  const auto side = long(std::ceil(std::cbrt(double(count)) - 1e-9));
  const double spacing = 2 * matrix.largest_radius * spacing_over_diameter;
  ParticleBox box;
  box.edge = double(side) * spacing;
  box.time_step = step.advised;
  box.speed = speed_of_impact(matrix, materials.front(), matrix.load / 2);
  for (const std::size_t material : materials)
    box.speed = std::min(box.speed, speed_of_impact(matrix, material, matrix.load / 2));
  // mt19937_64 gives the same numbers everywhere; the library's distributions do not.
  std::mt19937_64 generator(1);
  const auto random = [&] { return double(generator() >> 11) * 0x1p-53; };
  for (long k = 0; k < count; ++k) {
    BoxParticle particle;
    particle.material = materials[std::size_t(k) % materials.size()];
    particle.radius = matrix.smallest_radius + random() * (matrix.largest_radius - matrix.smallest_radius);
    const long cell[3] = {k % side, k / side % side, k / side / side};
    for (int i = 0; i < 3; ++i)
      particle.position[i] = (double(cell[i]) + 0.5 + jitter * (2 * random() - 1)) * spacing;
    const double height = random(), turn = random();
    particle.velocity = direction(height, turn);
    for (double& v : particle.velocity) v *= box.speed;
    box.particles.push_back(particle);
  }
  // A neighbour is a gap of spacing - 2 R away, which both close.
  const double way = std::max(spacing - 2 * matrix.smallest_radius, 0.2 * matrix.largest_radius);
  box.every = std::max(1L, std::lround(impacts_per_particle * way / (box.speed * box.time_step) / rows));
  box.steps = rows * box.every;
  return box;
}

std::string write_box(const WrittenEngine& engine, const MaterialMatrix& matrix, int count,
                      const std::filesystem::path& folder) {
  const std::string contacts = matrix_input_of(engine, matrix);
  const ParticleBox box = particle_box(matrix, count);
  const std::vector<WrittenFile> files = engine.box_files(matrix, box);
  std::filesystem::create_directories(folder);
  write_file_atomically(folder / engine.matrix_file(), contacts);
  for (const auto& [name, text] : files) write_file_atomically(folder / name, text);
  return "box of " + std::to_string(box.particles.size()) + " particles, " + std::to_string(box.steps) +
         " steps of " + format_quantity(box.time_step, Dimension::time) + ": run " + files.front().first +
         " in " + folder.string();
}

}  // namespace asperity
