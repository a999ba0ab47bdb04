// A closed box of particles of several materials in random motion, as a first run of a matrix of materials:
// it cools by its impacts, so its energy never rises.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engines/engine_input.h"
#include "engines/many_particles/material_matrix.h"

namespace asperity {

/// One particle at the start.
struct BoxParticle {
  std::size_t material = 0;
  double radius = 0;                 ///< [m]
  std::array<double, 3> position{};  ///< from the box's corner [m]
  std::array<double, 3> velocity{};  ///< [m/s]
};

/// All of them; walls are of the matrix's wall material.
struct ParticleBox {
  std::vector<BoxParticle> particles;
  double edge = 0;       ///< of the cube [m]
  double speed = 0;      ///< of each particle at the start [m/s]
  double time_step = 0;  ///< [s]
  long steps = 0;        ///< until each particle has met some others
  long every = 0;        ///< steps between rows of energy.csv
};

/// Materials that particles are of (density known) take turns, and so do sizes between smallest and largest.
/// The speed is that whose head-on impact reaches half of the matrix's load. The same numbers give the same
/// box. Throws InputError for less than one particle.
ParticleBox particle_box(const MaterialMatrix& matrix, int count);

/// "Name" and text of a file.
using WrittenFile = std::pair<std::string, std::string>;

/// What each engine runs: `contacts` is the file of the matrix beside it. It writes energy.csv: time [s],
/// energy of translation and of rotation [J].
std::vector<WrittenFile> lammps_box(const MaterialMatrix& matrix, const ParticleBox& box,
                                    const std::string& contacts);
std::vector<WrittenFile> liggghts_box(const MaterialMatrix& matrix, const ParticleBox& box,
                                      const std::string& contacts);
std::vector<WrittenFile> yade_box(const MaterialMatrix& matrix, const ParticleBox& box,
                                  const std::string& contacts);

/// The matrix's contacts and all files of a box of `count` particles, into a folder that is made. Returns one
/// line for people: how many, and what to run. Throws InputError where that is not written for the engine.
std::string write_box(const WrittenEngine& engine, const MaterialMatrix& matrix, int count,
                      const std::filesystem::path& folder);

}  // namespace asperity
