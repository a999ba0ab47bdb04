// The studies of a plan: what is solved, and what half-spaces add.
#include <string>
#include <utility>
#include <vector>

#include "app/characterise_plan.h"
#include "core/quantity.h"

namespace asperity {
namespace {

std::string variant_line(const PlannedMotion& motion) {
  std::string line = "    set " + motion.label + " = ";
  for (std::size_t i = 0; i < motion.settings.size(); ++i)
    line += (i == 0 ? "" : "; ") + motion.settings[i].path() + " = " + motion.settings[i].value;
  return line + "\n";
}

/// realisations: of the motions that have a number of their own.
std::string text_of_study(const CharacterisePlan& plan, const std::vector<PlannedMotion>& motions,
                          const std::vector<std::pair<std::string, int>>& realisations) {
  std::string loads;
  for (const double load : plan.loads)
    loads += (loads.empty() ? "" : ", ") + format_quantity(load, Dimension::force, 4);
  std::string text =
      "# Written by asperity characterise; asperity study solves it.\nset Title = Characterisation\n"
      "subsection Study\n  set Realisations = " +
      std::to_string(plan.rung.realisations) +
      "\n  subsection Vary\n    set Experiment/Normal load = " + loads +
      "\n  end\n  set Name of variants = Motion\n  subsection Variants\n";
  for (const auto& motion : motions) text += variant_line(motion);
  text += "  end\n";
  if (!realisations.empty()) text += "  subsection Realisations of variants\n";
  for (const auto& [label, count] : realisations)
    text += "    set " + label + " = " + std::to_string(count) + "\n";
  if (!realisations.empty()) text += "  end\n";
  return text + "end\n" + format_settings(plan.base);
}

}  // namespace

std::string study_text(const CharacterisePlan& plan) {
  std::vector<std::pair<std::string, int>> own;
  for (const PlannedMotion& motion : plan.motions)
    if (motion.realisations > plan.rung.realisations) own.emplace_back(motion.label, motion.realisations);
  return text_of_study(plan, plan.motions, own);
}

std::string preview_text(const CharacterisePlan& plan) {
  std::vector<PlannedMotion> motions;
  std::vector<std::pair<std::string, int>> surfaces;
  for (const auto& motion : plan.motions) {
    if (motion.half_space_surfaces == 0) continue;
    motions.push_back(motion);
    surfaces.emplace_back(motion.label, motion.half_space_surfaces);
  }
  return motions.empty() ? "" : text_of_study(plan, motions, surfaces);
}

}  // namespace asperity
