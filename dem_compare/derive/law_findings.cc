#include "dem_compare/derive/law_findings.h"

#include <cmath>

namespace asperity {

using About = OpenQuestion::About;

void find_scatter_and_mesh(const std::vector<CaseNumber>& all, Derived what, LawFindings& findings) {
  if (const auto scatter = realisation_scatter(all)) {
    findings.found.push_back(ScatterFact{what, *scatter});
    findings.details["realisation_scatter"] = scatter->relative;
  } else if (all.front().realisation != "smoothonsmooth") {
    findings.open.push_back({About::scatter, what});
  }
  if (const auto error = discretisation_error(all)) {
    findings.found.push_back(MeshFact{what, *error});
    findings.details["mesh_error"] = error->relative_error;
  } else {
    findings.open.push_back({About::mesh_error, what});
  }
}

void find_growth(const PowerLaw& law, double taken, Derived what, LawFindings& findings) {
  if (std::isnan(law.exponent))
    findings.open.push_back({About::growth, what});
  else
    findings.found.push_back(GrowthFact{what, law, taken});
}

void find_length(const LengthChoice& choice, LawFindings& findings) {
  findings.found.push_back(LengthFact{choice});
  if (!choice.is_told()) findings.open.push_back({About::length});
}

}  // namespace asperity
