// The header of a matrix of materials as an engine takes it: materials, where each pair's law is from, how
// the laws go with the particles' size, what is left out with its error, time step and damping.
#pragma once

#include <string>
#include <vector>

#include "engines/escaped_text.h"
#include "engines/many_particles/material_matrix.h"

namespace asperity {

/// What an engine adds to it.
struct MatrixHeader {
  std::string engine;                      ///< "LAMMPS"
  std::string sizes;                       ///< how its rolling and torsion go with the radius
  std::string damping;                     ///< how the restitution enters
  std::vector<std::string> not_expressed;  ///< for all pairs
};

/// Lines as they are; texts of the records are in them.
std::vector<std::string> header_lines(const MaterialMatrix& matrix, const MatrixHeader& header);
/// The same as comments of one language.
std::string header_text(const MaterialMatrix& matrix, const MatrixHeader& header,
                        const CommentStyle& comment);

/// "type 1 (borosilicate) and type 2 (silicon)".
std::string pair_name(const MaterialMatrix& matrix, std::size_t i, std::size_t j);

/// Where an engine takes one number for all sizes: which of them Luding's stiffness is right for, and by what
/// it is off for the smallest.
std::string one_size_of_stiffness(const MaterialMatrix& matrix);

/// Damping ratio beta that makes a restitution e, -ln e/(ln^2 e + pi^2)^(1/2): of a linear spring with the
/// damper 2 beta (m k)^(1/2), and of a Hertz contact whose damper goes with the root of its tangent stiffness
/// k, 2 beta (5/6)^(1/2) (m k)^(1/2) (Antypov & Elliott 2011, EPL 94, 50004).
double damping_ratio(double restitution);

}  // namespace asperity
