// A matrix of materials as each engine takes it.
#pragma once

#include <string>

#include "engines/engine_input.h"
#include "engines/many_particles/material_matrix.h"

namespace asperity {

/// With the matrix's own normal law; throws InputError where that is not written for this engine.
inline std::string matrix_input_of(const WrittenEngine& engine, const MaterialMatrix& matrix) {
  return matrix.yields() ? engine.elastoplastic_matrix_input(matrix) : engine.matrix_input(matrix);
}

/// pair_style granular with all pair_coeff, and a variable for each pair at a plane, for fix wall/gran.
std::string lammps_matrix(const MaterialMatrix& matrix);
/// Materials, functors and asperity_step() with all pairs.
std::string yade_matrix(const MaterialMatrix& matrix);
/// Properties by type, rolling by the model epsd3. Throws InputError for a material without E or nu.
std::string liggghts_matrix(const MaterialMatrix& matrix);
/// The same three of pairs that yield, with Luding's law.
std::string liggghts_luding_matrix(const MaterialMatrix& matrix);
std::string yade_luding_matrix(const MaterialMatrix& matrix);
std::string mercurydpm_luding_matrix(const MaterialMatrix& matrix);
/// Species and mixed species.
std::string mercurydpm_matrix(const MaterialMatrix& matrix);
/// MaterialsDEM.json with all relations. Throws InputError for a material without E or nu.
std::string kratos_matrix(const MaterialMatrix& matrix);
/// Lines for a job script: properties of compounds and interactions.
std::string musen_matrix(const MaterialMatrix& matrix);

}  // namespace asperity
