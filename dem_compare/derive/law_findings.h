// What was found on one law, as facts and for programs, and what the cases could not tell.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/motion.h"
#include "dem_compare/derive/facts.h"

namespace asperity {

struct LawFindings {
  const MotionMode* mode = nullptr;  ///< none: of the normal law
  std::vector<double> radii{};       ///< of the particle, where sets that differ by it are taken together [m]
  std::vector<Fact> found{};
  std::vector<OpenQuestion> open{};
  nlohmann::ordered_json details{};
  std::vector<ResistancePoint> points{};  ///< of a resistance: what its law was fitted to

  Motion motion() const { return mode ? mode->motion : Motion::normal; }
};

/// Scatter between realisations and error of the mesh, apart; or what would show them.
void find_scatter_and_mesh(const std::vector<CaseNumber>& all, Derived what, LawFindings& findings);
/// How a stiffness grows with the load, n of the law taken being `taken` [-].
void find_growth(const PowerLaw& law, double taken, Derived what, LawFindings& findings);
/// Which of the two lengths a resistance goes with.
void find_length(const LengthChoice& choice, LawFindings& findings);

}  // namespace asperity
