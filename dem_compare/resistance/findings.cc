#include "dem_compare/resistance/findings.h"

namespace asperity {

ResistanceFindings find_resistances(const CaseCollection& collection) {
  ResistanceFindings findings;
  findings.study = collect_moving(collection);
  if (findings.empty()) return findings;
  findings.trends = roughness_trends(findings.study);
  findings.lengths = length_answers(findings.study);
  findings.contributions = contributions(findings.study);
  findings.contribution_trends = contribution_trends(findings.contributions);
  findings.inputs = input_exponents(findings.study);
  findings.meshes = mesh_effects(findings.study);
  return findings;
}

}  // namespace asperity
