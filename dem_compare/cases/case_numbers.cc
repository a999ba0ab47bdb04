#include "dem_compare/cases/case_numbers.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using Indices = std::vector<std::size_t>;

/// Indices of numbers that `same` says belong together.
template <class Same>
std::vector<Indices> families(const std::vector<CaseNumber>& numbers, const Same& same) {
  std::vector<Indices> all;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Indices& family) {
      return same(numbers[family.front()], numbers[i]);
    });
    if (found == all.end())
      all.push_back({i});
    else
      found->push_back(i);
  }
  return all;
}

bool same_contact(const CaseNumber& a, const CaseNumber& b) {
  return same_load(a.load, b.load) && a.realisation == b.realisation;
}

}  // namespace

bool same_load(double one, double other) {
  constexpr double same = 1e-3;
  return std::abs(one - other) <= same * std::max(one, other);
}

bool same_spacing(double a, double b) {
  constexpr double same = 1e-3;
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= same * std::max(a, b);
}

std::optional<RealisationScatter> realisation_scatter(const std::vector<CaseNumber>& numbers) {
  double squares = 0;
  int freedom = 0;
  RealisationScatter scatter;
  for (const auto& family : families(numbers, [](const CaseNumber&a, const CaseNumber&b) {
         return same_load(a.load, b.load) && same_spacing(a.spacing, b.spacing);
       })) {
    std::vector<double> values;
    for (const auto i : family) values.push_back(numbers[i].value);
    const Scatter here = scatter_of(values);
    scatter.realisations = std::max(scatter.realisations, here.count);
    if (here.count < 2) continue;
    squares += (here.count - 1) * std::pow(here.sd / here.mean, 2);
    freedom += here.count - 1;
  }
  if (freedom == 0) return std::nullopt;
  scatter.relative = std::sqrt(squares / freedom);
  return scatter;
}

std::vector<std::size_t> on_one_mesh(const std::vector<CaseNumber>& numbers) {
  const auto contacts = families(numbers, same_contact);
  const auto on_spacing = [&](const Indices& contact, double spacing) {
    return std::find_if(contact.begin(), contact.end(),
                        [&](std::size_t i) { return same_spacing(numbers[i].spacing, spacing); });
  };
  // Meshes that are not known (NaN) count as the coarsest.
  const auto finer = [&](std::size_t a, std::size_t b) {
    const double one = numbers[a].spacing, other = numbers[b].spacing;
    return std::isnan(other) ? !std::isnan(one) : one < other;
  };
  std::optional<std::size_t> common;
  if (!contacts.empty())
    for (const auto i : contacts.front()) {
      const bool everywhere = std::all_of(contacts.begin(), contacts.end(), [&](const Indices& contact) {
        return on_spacing(contact, numbers[i].spacing) != contact.end();
      });
      if (everywhere && (!common || finer(i, *common))) common = i;
    }
  Indices chosen;
  for (const auto& contact : contacts)
    chosen.push_back(common ? *on_spacing(contact, numbers[*common].spacing)
                            : *std::min_element(contact.begin(), contact.end(), finer));
  return chosen;
}

std::vector<CaseNumber> counted_of(const std::vector<CaseNumber>& numbers) {
  std::vector<CaseNumber> counted;
  for (const auto i : on_one_mesh(numbers)) counted.push_back(numbers[i]);
  return counted;
}

std::optional<DiscretisationError> discretisation_error(const std::vector<CaseNumber>& numbers) {
  DiscretisationError error;
  for (const auto i : on_one_mesh(numbers)) {
    std::vector<double> spacings, values;
    for (const auto& other : numbers) {
      const bool known = std::any_of(spacings.begin(), spacings.end(),
                                     [&](double h) { return same_spacing(h, other.spacing); });
      if (!same_contact(numbers[i], other) || std::isnan(other.spacing) || known) continue;
      spacings.push_back(other.spacing);
      values.push_back(other.value);
    }
    if (spacings.size() < 2) continue;
    const double counted = numbers[i].value;
    error.relative_error += (counted - mesh_error(spacings, values).extrapolated) / std::abs(counted);
    ++error.families;
  }
  if (error.families == 0) return std::nullopt;
  error.relative_error /= error.families;
  return error;
}

}  // namespace asperity
