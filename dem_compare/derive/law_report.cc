#include "dem_compare/derive/law_report.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/joined.h"
#include "core/printed.h"

namespace asperity {
namespace {

constexpr int value_digits = 4, error_digits = 2;

/// 460, not 4.6e+02.
std::string digits_of(double value, int digits) {
  constexpr double large = 1e5;
  const bool is_whole = std::abs(value) >= std::pow(10.0, digits - 1) && std::abs(value) < large;
  return is_whole ? printed("%.0f", value) : printed("%.*g", digits, value);
}

}  // namespace

std::string to_text(const ResistanceLaw& law) {
  return "mu = " + with_error(law.coefficient, law.coefficient_sd(), "") +
         (law.has_offset ? ", h = " + with_error(law.offset, law.offset_sd(), Dimension::force)
                         : ", h = 0 (not identifiable)");
}

nlohmann::ordered_json to_json(const ResistanceLaw& law) {
  return {{"coefficient", law.coefficient},
          {"offset", law.offset},
          {"covariance",
           {{law.covariance(0, 0), law.covariance(0, 1)}, {law.covariance(1, 0), law.covariance(1, 1)}}},
          {"offset_is_told", law.has_offset},
          {"case_scatter", law.case_scatter},
          {"realisation_scatter", law.realisation_scatter},
          {"relative_misfit", law.misfit},
          {"degrees_of_freedom", law.degrees_of_freedom}};
}

std::string with_error(double value, double sd, Dimension dimension) {
  const std::string text = format_quantity(value, dimension, value_digits);
  const auto blank = text.find(' ');
  if (!std::isfinite(sd) || blank == std::string::npos) return text;
  const std::string unit = text.substr(blank + 1);
  return text.substr(0, blank) + " +- " + digits_of(sd / unit_factor(unit, dimension), error_digits) + " " +
         unit;
}

std::string with_error(double value, double sd, const std::string& unit) {
  if (!unit.empty() && unit.front() == 'N') return with_error(value, sd, Dimension::force) + unit.substr(1);
  std::string text = digits_of(value, value_digits);
  if (std::isfinite(sd)) text += " +- " + digits_of(sd, error_digits);
  return unit.empty() ? text : text + " " + unit;
}

std::string percent(double share) { return digits_of(100 * share, error_digits) + " %"; }

std::string extent_of(const std::vector<CaseNumber>& numbers) {
  std::set<std::string> realisations, spacings;
  double low = numbers.front().load, high = low;
  for (const auto& number : numbers) {
    realisations.insert(number.realisation);
    if (std::isfinite(number.spacing)) spacings.insert(format_quantity(number.spacing, Dimension::length));
    low = std::min(low, number.load), high = std::max(high, number.load);
  }
  std::string text = numbers.size() == 1 ? "1 case" : std::to_string(numbers.size()) + " cases";
  text += ", load " + format_quantity(low, Dimension::force);
  if (!same_load(low, high)) text += " to " + format_quantity(high, Dimension::force);
  text += realisations.size() == 1 ? ", 1 realisation"
                                   : ", " + std::to_string(realisations.size()) + " realisations";
  return spacings.empty() ? text : text + ", spacing " + joined({spacings.begin(), spacings.end()}, " and ");
}

std::vector<CaseNumber> counted_of(const std::vector<CaseNumber>& all) {
  std::vector<CaseNumber> counted;
  for (const auto i : on_one_mesh(all)) counted.push_back(all[i]);
  return counted;
}

std::string source_of(const std::vector<CaseNumber>& all) {
  const auto error = discretisation_error(all);
  return extent_of(counted_of(all)) +
         (error ? "; error of the mesh " + percent(error->relative_error) + ", not in the sd"
                : "; error of the mesh not known");
}

void tell_scatter_and_mesh(const std::vector<CaseNumber>& all, const std::string& what, LawReport& report) {
  const bool smooth = all.front().realisation == "smoothonsmooth";
  if (const auto scatter = realisation_scatter(all)) {
    report.findings.push_back("scatter between realisations (" + what + "): " + percent(scatter->relative) +
                              " of one, from up to " + std::to_string(scatter->realisations) + " at a load");
    report.details["realisation_scatter"] = scatter->relative;
  } else if (!smooth) {
    report.not_identifiable.push_back(
        "scatter of " + what +
        " between realisations: solve the same case with two or more seeds of its roughness");
  }
  if (const auto error = discretisation_error(all)) {
    report.findings.push_back(
        "error of the mesh (" + what + "): " + percent(error->relative_error) +
        (error->families > 1 ? ", mean of " + std::to_string(error->families) + " contacts" : "") +
        "; not part of the uncertainty above");
    report.details["mesh_error"] = error->relative_error;
  } else {
    report.not_identifiable.push_back("error of the mesh in " + what +
                                      ": solve one case again with twice the Mesh/Interface spacing");
  }
}

}  // namespace asperity
