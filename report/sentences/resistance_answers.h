// What a study of moving contacts says, in sentences.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/findings.h"

namespace asperity::report {

struct ResistanceAnswers {
  std::string headline;
  std::vector<std::string> length;       ///< on lambda
  std::vector<std::string> roughness;    ///< trends with RMS, and which mechanism makes them
  std::vector<std::string> mechanisms;   ///< what switching one off changes
  std::vector<std::string> inputs;       ///< scaling with local friction, works of adhesion, yield stresses
  std::vector<std::string> mesh;         ///< discretisation error
  std::vector<std::string> rails;        ///< rolling and spinning at once beside the sum of both on their own
  std::vector<std::string> measurement;  ///< where simulations and the paper disagree, and by how much
  std::vector<std::string> care;         ///< what stands in the way of more
};
/// Of the findings of a study.
ResistanceAnswers answers(const ResistanceFindings& findings);

/// "λ = a", "not identifiable"; of "neither" with decisive odds, which of the two lengths is the better one.
std::string length_verdict(const LengthAnswer& answer);
/// One per contact and motion.
std::vector<std::string> length_sentences(const std::vector<LengthAnswer>& lengths);
/// Trends, laws and magnitudes beside the paper's, and what has no partner there.
std::vector<std::string> measurement_sentences(const ResistanceFindings& findings);

}  // namespace asperity::report
