#include "report/study/study_verdict.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "report/page/axis.h"
#include "report/page/page.h"
#include "report/page/words.h"
#include "report/result/result_tables.h"
#include "report/sentences/hertz_words.h"
#include "results/energy_balance.h"

namespace asperity::report {
namespace {

/// "2 of 5 contacts are as stiff as Hertz within 5 % at every load, 2 are not, of 1 it is not known".
std::string counts_in_words(const std::map<Judged, std::size_t>& counts, std::size_t contacts) {
  const auto count = [&](Judged judged) { return counts.count(judged) ? counts.at(judged) : 0; };
  const std::string within = " as stiff as Hertz within " + percent_text(tolerance) + " at every load";
  const auto numbered = [](std::size_t n, const char* one, const char* several) {
    return std::to_string(n) + (n == 1 ? one : several);
  };
  if (count(Judged::within) == contacts)
    return contacts == 1 ? "The contact is" + within
                         : "All " + std::to_string(contacts) + " contacts are" + within;
  std::string text = contacts == 1 ? "The contact "
                                   : numbered(count(Judged::within), " of ", " of ") +
                                         std::to_string(contacts) + " contacts ";
  if (contacts == 1)
    return text + (count(Judged::outside) ? "is not" + within
                                          : "is not known to be" + within + ", as far as its errors tell");
  text += (count(Judged::within) == 1 ? "is" : "are") + within;
  if (count(Judged::outside)) text += ", " + numbered(count(Judged::outside), " is not", " are not");
  if (count(Judged::not_known))
    text +=
        ", of " + std::to_string(count(Judged::not_known)) + " it is not known, as far as their errors tell";
  return text;
}

/// The smooth control, which must follow Hertz, is not counted: it judges the computation.
std::string study_headline(const std::vector<StudyCurve>& curves) {
  std::map<Judged, std::size_t> counts;
  std::size_t contacts = 0, single = 0;
  const StudyCurve* worst = nullptr;
  const LoadComparison* worst_load = nullptr;
  double departure = -1;
  for (const auto& curve : curves) {
    const GroupComparison& group = curve.last();
    if (group.is_control || group.loads.empty()) continue;
    ++contacts, ++counts[group.judged_at_all_loads];
    single += group.realisations == 1 && curve.largest->first().is_rough();
    for (const auto& load : group.loads)
      if (std::abs(load.stiffness_ratio.mean - 1) > departure) {
        departure = std::abs(load.stiffness_ratio.mean - 1);
        worst = &curve;
        worst_load = &load;
      }
  }
  if (!worst)
    return contacts == 0 && !curves.empty()
               ? "Only smooth elastic bodies were solved: they judge the computation, not Hertz"
               : "There is nothing to judge yet.";
  return counts_in_words(counts, contacts) + "; the largest departure is " +
         departure_text(worst_load->stiffness_ratio.mean) +
         interval_words(worst_load->stiffness_ratio.mean - 1, worst_load->stiffness_half_width) + " (" +
         readable(worst->label) + ", at " + in_units(worst_load->force, Dimension::force) + ")." +
         (single > 0 ? " Of " + std::to_string(single) +
                           " a single realisation was solved: that surface is judged, others may differ."
                     : "");
}

std::string numerical_error_sentence(const std::vector<StudyCurve>& curves) {
  for (const auto& curve : curves) {
    const GroupComparison& group = curve.last();
    if (!group.is_control || group.loads.empty()) continue;
    const auto& top = group.loads.back();
    return "Error of the computation, where the truth is known: the smooth contact (" +
           readable(curve.label) + ") must follow Hertz and departs by " +
           departure_text(top.stiffness_ratio.mean) + " in stiffness, " +
           departure_text(top.force_ratio.mean) + " in force and " + departure_text(top.area_ratio.mean) +
           " in contact area at " + in_units(top.force, Dimension::force) + ".";
  }
  return "";
}

std::string mesh_sentence(const std::vector<StudyCurve>& curves) {
  double stiffness = 0, area = 0;
  bool known = false;
  for (const auto& curve : curves)
    for (const auto& load : curve.last().loads) {
      if (!load.stiffness.mesh) continue;
      known = true;
      stiffness = std::max(stiffness, std::abs(load.stiffness.mesh->relative_error));
      if (load.area_ratio.mesh) area = std::max(area, std::abs(load.area_ratio.mesh->relative_error));
    }
  return known ? "Error of the mesh, from several spacings, over all contacts and loads: up to " +
                     percent_text(stiffness) + " of the stiffness, up to " + percent_text(area) +
                     " of the real contact area (columns of their own below)."
               : "Mesh error: each contact was solved on one spacing only, so it is not known from this "
                 "study itself; vary Mesh/Interface spacing to have it.";
}

}  // namespace

std::string worst_balance_sentence(const CaseCollection& collection) {
  std::map<std::string, double> worst;
  for (const auto& group : collection.groups)
    for (const auto& solved : group.cases)
      if (solved.finished())
        for (const auto& [name, error] : solved.result->balance)
          if (std::isfinite(error)) worst[name] = std::max(worst[name], std::abs(error));
  std::string text;
  for (const auto& [name, error] : worst)
    text += (text.empty() ? "" : ", ") + escaped(name) + " " + percent_bound(error);
  return text.empty() ? "" : "Largest relative errors of the balances over all cases: " + text + ".";
}

std::string study_verdict(const CaseCollection& collection, const std::vector<StudyCurve>& curves) {
  std::vector<std::string> sentences;
  for (const auto& curve : curves)
    sentences.push_back("<b>" + readable(curve.label) +
                        "</b>: " + readable(verdict_against_hertz(curve.last(), tolerance)));
  for (const auto& sentence :
       {numerical_error_sentence(curves), mesh_sentence(curves), worst_balance_sentence(collection)})
    if (!sentence.empty()) sentences.push_back(sentence);
  return verdict_html(study_headline(curves), sentences);
}

}  // namespace asperity::report
