#include "report/curves/study_curves.h"

#include <algorithm>

namespace asperity::report {
namespace {

/// Index of the axis that varies this entry; -1 if none does.
int axis_of(const std::vector<CollectionAxis>& axes, const std::string& name) {
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].name.size() >= name.size() &&
        axes[i].name.compare(axes[i].name.size() - name.size(), name.size(), name) == 0)
      return static_cast<int>(i);
  return -1;
}

}  // namespace

std::vector<StudyCurve> curves_of(const CaseCollection& collection, const Comparison& comparison) {
  const int load = axis_of(collection.axes, "Normal load"),
            spacing = axis_of(collection.axes, "Interface spacing");
  std::vector<StudyCurve> curves;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const GroupComparison& group = comparison.groups[g];
    if (!group.is_finest) continue;
    std::string label;
    for (std::size_t i = 0; i < group.values.size(); ++i)
      if (static_cast<int>(i) != load && static_cast<int>(i) != spacing)
        label += (label.empty() ? "" : ", ") + group.values[i];
    if (label.empty()) label = load >= 0 || spacing >= 0 ? "computed" : group.label;
    auto at = std::find_if(curves.begin(), curves.end(),
                           [&](const StudyCurve& curve) { return curve.label == label; });
    if (at == curves.end()) at = curves.insert(at, {label, {}, nullptr});
    at->groups.push_back(&group);
  }
  for (auto& curve : curves) {
    std::sort(curve.groups.begin(), curve.groups.end(),
              [](const auto* a, const auto* b) { return a->numbers.force < b->numbers.force; });
    curve.largest =
        &collection.groups[static_cast<std::size_t>(curve.groups.back() - comparison.groups.data())];
  }
  return curves;
}

}  // namespace asperity::report
