#include "report/fields/case_fields.h"

#include <algorithm>
#include <cmath>

#include "report/page/axis.h"
#include "report/page/page.h"

namespace asperity::report {

double largest_force(const SolvedCase& solved) {
  const auto& force = solved.history.normal_force;
  return force.empty() ? 0 : *std::max_element(force.begin(), force.end());
}

double hertz_radius(const SolvedCase& solved) { return solved.hertz().contact_radius(largest_force(solved)); }

StepFiles files_at_largest_load(const SolvedCase& solved, const std::string& pvd) {
  const auto steps = field_files(solved.folder / pvd);
  if (steps.empty()) return {};
  const StepFiles* best = &steps.rbegin()->second;
  double best_force = -1;
  constexpr double same_load = 1 + 1e-6;  // of a hold or a second cycle: the first is shown
  const auto& history = solved.history;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto found = steps.find(static_cast<int>(std::lround(history.step[i])));
    if (found == steps.end() || history.normal_force[i] <= best_force * same_load) continue;
    best_force = history.normal_force[i];
    best = &found->second;
  }
  return *best;
}

std::vector<Addition> added_scalars(const SolvedCase& solved, const std::string& place) {
  std::vector<Addition> scalars;
  if (!solved.finished()) return scalars;
  for (const auto& field : solved.result->added_fields)
    if (field.place == place && field.components == 1) scalars.push_back(field);
  return scalars;
}

std::string no_fields(const SolvedCase& solved) {
  return note("There are no fields of " + escaped(solved.title()) +
              " to draw (Output/Fields is off, or the case has not come to its largest load yet).");
}

MapFigure figure_in_nm(double x_low, double x_high, double y_low, double y_high,
                       const std::string& upright_name) {
  constexpr double nm = 1e-9;
  MapFigure figure;
  figure.x_label = "x [nm]";
  figure.y_label = upright_name + " [nm]";
  figure.x_low = x_low / nm;
  figure.x_high = x_high / nm;
  figure.y_low = y_low / nm;
  figure.y_high = y_high / nm;
  return figure;
}

}  // namespace asperity::report
