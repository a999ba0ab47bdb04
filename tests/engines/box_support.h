// Boxes of particles as written, run by the engines.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "engines/many_particles/matrix_inputs.h"
#include "engines/many_particles/particle_box.h"
#include "tests/engines/engine_support.h"

namespace asperity::test {

/// Energy of a box [J], row by row, and whether it came to its end.
struct BoxRun {
  std::vector<double> energy;
  std::string log;
};

inline BoxRun run_box(const WrittenEngine& written, const Engine& engine, const MaterialMatrix& matrix,
                      int count, const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  folder.write(written.matrix_file(), matrix_input_of(written, matrix));
  for (const auto& [name, text] : written.box_files(matrix, particle_box(matrix, count)))
    folder.write(name, text);
  std::vector<std::string> command{find_program(engine.executable()).string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  run_program(command, folder.path, "log", std::chrono::seconds(280), environment_alone_in_mpi());
  BoxRun run;
  std::ifstream log(folder.path / "log");
  run.log = {std::istreambuf_iterator<char>(log), {}};
  std::ifstream rows(folder.path / "energy.csv");
  std::string line;
  std::getline(rows, line);
  while (std::getline(rows, line)) {
    double time = 0, translation = 0, rotation = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &time, &translation, &rotation) == 3)
      run.energy.push_back(translation + rotation);
  }
  return run;
}

/// What contacts hold elastically comes back within an impact: so the largest energy of motion of a window
/// that is longer than an impact stands for all of the energy.
inline void expect_that_energy_never_rises(const BoxRun& run, const MaterialMatrix& matrix,
                                           const ParticleBox& box, double least = 0.1) {
  ASSERT_GE(run.energy.size(), 199u) << run.log;
  double mass = 0;
  for (const BoxParticle& p : box.particles)
    mass += matrix.materials[p.material].density * 4.0 / 3 * M_PI * std::pow(p.radius, 3);
  EXPECT_NEAR(run.energy.front() / (mass * box.speed * box.speed / 2), 1, 1e-6);
  constexpr std::size_t window = 20;
  double before = run.energy.front();
  for (std::size_t i = 0; i + window <= run.energy.size(); i += window) {
    const double largest =
        *std::max_element(run.energy.begin() + long(i), run.energy.begin() + long(i + window));
    EXPECT_LE(largest, before * (1 + 1e-9)) << "row " << i;
    before = largest;
  }
  EXPECT_LT(run.energy.back(), 0.6 * run.energy.front()) << "the particles hardly met";
  EXPECT_GT(run.energy.back(), least * run.energy.front());
}

}  // namespace asperity::test
