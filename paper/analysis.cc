#include "paper/analysis.h"

#include <cmath>

#include "core/error.h"

namespace asperity {

const PaperNumber& PaperAnalysis::number(const std::string& section, const std::string& what) const {
  for (const auto& candidate : sections) {
    if (candidate.title.find(section) == std::string::npos) continue;
    for (const auto& number : candidate.numbers)
      if (number.what == what) return number;
  }
  throw InputError("the paper's analysis has no '" + what + "' under '" + section + "'");
}

PaperAnalysis analyse_paper(const Published& published) {
  return {{table_1(published), table_2(published), elasticity_section(published), sliding_section(published),
           rolling_section(published), rail_section(published), torsion_section(published),
           magnitudes_section(published), equations_section()},
          paper_curves(published)};
}

RoughnessLaws roughness_laws(const Published& p) {
  std::vector<Uncertain> rms, rolling, offset;
  for (const auto& surface : p.surfaces) {
    rms.push_back(surface.rms);
    rolling.push_back(surface.rolling_r);
    offset.push_back(surface.rolling_r_offset);
  }
  const auto value = [&](const char* name, Dimension dimension) { return p.quoted(name, dimension).value; };
  return {{value("murofit_b", Dimension::none), value("murofit_c", Dimension::none),
           value("murofit_d", Dimension::length)},
          {value("frofit_b", Dimension::force), -value("frofit_c", Dimension::force),
           value("frofit_d", Dimension::length)},
          fit_exponential(rms, rolling),
          fit_exponential(rms, offset)};
}

std::string whole_degrees(double angle) {
  return std::to_string(std::lround(angle / display::degree.factor)) + " deg";
}

}  // namespace asperity
