// What a study of moving contacts says on the paper's two open questions: which length rolling and torsion
// resistance follow, and why rolling friction falls and sliding friction rises with roughness. SI units.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/input_exponent.h"
#include "dem_compare/resistance/length_answer.h"
#include "dem_compare/resistance/measured_resistances.h"
#include "dem_compare/resistance/mesh_effect.h"
#include "dem_compare/resistance/switched_off.h"

namespace asperity {

/// Points into lists of its own: not to be copied.
struct ResistanceFindings {
  MovingStudy study;
  std::vector<RoughnessTrend> trends;
  std::vector<LengthAnswer> lengths;
  std::vector<Contribution> contributions;
  std::vector<ContributionTrend> contribution_trends;
  std::vector<InputExponent> inputs;
  std::vector<MeshEffect> meshes;
  AgainstPublished published;  ///< empty: for those who have measurements to fill in

  ResistanceFindings() = default;
  ResistanceFindings(const ResistanceFindings&) = delete;
  ResistanceFindings(ResistanceFindings&&) = default;
  ResistanceFindings& operator=(ResistanceFindings&&) = default;
  bool empty() const { return study.empty(); }
};

/// What the cases say by themselves.
ResistanceFindings find_resistances(const CaseCollection& collection);

}  // namespace asperity
