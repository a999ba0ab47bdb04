// A recording whose truth comes from another model than the one that diagnoses: asperity conceal.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/conceal/truth.h"
#include "diagnosis/recording/recording.h"

namespace asperity {

/// What is concealed in which experiment.
struct ConcealOptions {
  Motion mode = Motion::normal;
  std::vector<std::string> effects;  ///< of the catalogue or out of it; none: a null
  double noise = 0.01;               ///< standard deviation of a sample over the largest response [-]
  unsigned seed = 1;
  /// "one_load", "ramp_only": experiments in which some effects are not distinguishable; "long_hold",
  /// "small_loops": those in which one looks like another; "other_code": yielding, roughness and films of a
  /// normal contact by finite elements and half-spaces that are not those of the diagnosis.
  std::string setting;
};

struct ConcealedRecording {
  Recording recording;
  Truth truth;
};

/// Throws InputError for effects that are unknown, belong to another mode, or do not go together.
ConcealedRecording conceal(const ConcealOptions& options);

/// Recording and truth.json in a folder.
void write_concealed(const ConcealedRecording& concealed, const std::filesystem::path& folder);

/// Effects that can be concealed in a mode; out_of_catalogue_effects() are not in the catalogue.
std::vector<std::string> concealable_effects(Motion mode);
std::vector<std::string> out_of_catalogue_effects(Motion mode);
/// Effects that only a case of finite elements can be told to lack (`diagnose --case`).
std::vector<std::string> effects_beside_a_case(Motion mode);
/// Effects that only setting other_code conceals.
std::vector<std::string> effects_by_other_code_alone(Motion mode);

/// A solved case's history as a recording of its mode with noise: the finite-element solver as truth.
/// `folder` holds history.csv and result.json or case.prm; `effects` say what the case shows. Several cases:
/// a run each, in torsion a load each. Throws InputError.
ConcealedRecording conceal_cases(const std::vector<std::filesystem::path>& folders,
                                 const ConcealOptions& options);
ConcealedRecording conceal_case(const std::filesystem::path& folder, const ConcealOptions& options);

}  // namespace asperity
