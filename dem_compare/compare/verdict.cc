#include "dem_compare/compare/verdict.h"

#include <algorithm>

namespace asperity {
namespace {

/// What is judged, and by what.
struct Judgement {
  const char *judged, *reference;  ///< columns; a law goes by its own name
  const ComparedValue& (*value)(const ComparisonRow&);
  const ComparedValue& (*by)(const ComparisonRow&);

  bool involves_finite_elements() const;
  /// Not a number where one of both is not known.
  Departure departure(const ComparisonRow& row) const;
};
const ComparedValue& finite_elements_of(const ComparisonRow& row) { return row.finite_elements; }
const ComparedValue& reduced_law_of(const ComparisonRow& row) { return row.reduced_law; }
const ComparedValue& published_of(const ComparisonRow& row) { return row.published; }
constexpr Judgement judgements[] = {
    {"", "finite elements", reduced_law_of, finite_elements_of},
    {"", "measurement", reduced_law_of, published_of},
    {"The finite-element model", "measurement", finite_elements_of, published_of}};

bool Judgement::involves_finite_elements() const {
  return value == finite_elements_of || by == finite_elements_of;
}

/// The mesh's error goes with the finite elements, whichever side they are on.
Departure Judgement::departure(const ComparisonRow& row) const {
  const Uncertain over = ratio(value(row), by(row));
  const double error = row.finite_elements.mesh_error;
  return {row.load, over.value - 1, over.sd,
          involves_finite_elements() && std::isfinite(error) ? error * over.value : 0};
}

using Rows = std::vector<const ComparisonRow*>;

std::vector<Departure> departures_of(const Rows& rows, const Judgement& judgement) {
  std::vector<Departure> departures;
  for (const ComparisonRow* row : rows)
    if (const Departure departure = judgement.departure(*row); std::isfinite(departure.value))
      departures.push_back(departure);
  std::sort(departures.begin(), departures.end(),
            [](const auto& a, const auto& b) { return a.load < b.load; });
  return departures;
}

std::optional<std::pair<double, double>> discretisation_error(const Rows& rows, double tolerance) {
  std::optional<std::pair<double, double>> worst;
  for (const ComparisonRow* row : rows) {
    const double error = row->finite_elements.mesh_error;
    if (std::abs(error) > (worst ? std::abs(worst->second) : tolerance)) worst.emplace(row->load, error);
  }
  return worst;
}

bool is_its_own_fit(const std::vector<Departure>& departures) {
  return std::all_of(departures.begin(), departures.end(), [](const Departure& departure) {
    constexpr double rounding_of_records = 1e-4;
    return std::abs(departure.value) < rounding_of_records;
  });
}

/// A rail's angle tells verdicts apart; other quantities have none.
bool is_same_rail(double angle, double other) { return std::isnan(angle) || angle == other; }

LawVerdict verdict_of(const Rows& rows, const Judgement& judgement, double tolerance) {
  const ComparisonRow& first = *rows.front();
  LawVerdict verdict{first.contact,       *judgement.judged ? judgement.judged : first.reduced_law.source,
                     judgement.reference, first.quantity,
                     first.rail_angle,    {}};
  verdict.departures = departures_of(rows, judgement);
  if (verdict.departures.empty()) return verdict;
  verdict.compared = {verdict.departures.front().load, verdict.departures.back().load};
  verdict.good = good_ranges(verdict.departures, tolerance);
  for (const auto& range : judged_ranges(verdict.departures, tolerance)) {
    const int loads = static_cast<int>(range.last - range.first + 1);
    if (range.judged == Judged::outside) verdict.outside += loads;
    if (range.judged == Judged::not_known) verdict.not_known += loads;
  }
  verdict.is_own_fit = judgement.by == published_of && is_its_own_fit(verdict.departures);
  if (judgement.involves_finite_elements())
    verdict.discretisation_error = discretisation_error(rows, tolerance);
  return verdict;
}

}  // namespace

double Departure::half_width() const {
  return std::isfinite(sd) ? 2 * sd + std::abs(mesh_error) : mesh_error != 0 ? std::abs(mesh_error) : NAN;
}

std::vector<JudgedRange> judged_ranges(const std::vector<Departure>& departures, double tolerance) {
  std::vector<JudgedRange> ranges;
  for (std::size_t i = 0; i < departures.size(); ++i) {
    const Departure& departure = departures[i];
    const Judged own = judged(departure.value, departure.half_width(), tolerance);
    const bool is_above = own == Judged::outside && departure.value > 0;
    if (ranges.empty() || ranges.back().judged != own || ranges.back().is_above != is_above)
      ranges.push_back({own, is_above, i, i});
    ranges.back().last = i;
  }
  return ranges;
}

std::vector<GoodRange> good_ranges(const std::vector<Departure>& departures, double tolerance) {
  std::vector<GoodRange> good;
  for (const JudgedRange& range : judged_ranges(departures, tolerance))
    if (range.judged == Judged::within)
      good.push_back({{departures[range.first].load, departures[range.last].load},
                      range.first == 0,
                      range.last + 1 == departures.size()});
  return good;
}

std::vector<LawVerdict> verdicts(const std::vector<ComparisonRow>& rows, double tolerance) {
  std::vector<LawVerdict> found;
  Rows left;
  for (const auto& row : rows)
    if (row.reduced_law.known()) left.push_back(&row);
  while (!left.empty()) {
    const ComparisonRow& first = *left.front();
    Rows same, others;
    for (const ComparisonRow* row : left)
      (row->contact == first.contact && row->quantity == first.quantity &&
               row->reduced_law.source == first.reduced_law.source &&
               is_same_rail(first.rail_angle, row->rail_angle)
           ? same
           : others)
          .push_back(row);
    left = others;
    for (const Judgement& judgement : judgements) {
      LawVerdict verdict = verdict_of(same, judgement, tolerance);
      // Finite elements beside the measurement do not depend on the law.
      const bool is_said = std::any_of(found.begin(), found.end(), [&](const LawVerdict& other) {
        return other.contact == verdict.contact && other.quantity == verdict.quantity &&
               other.law == verdict.law && other.reference == verdict.reference &&
               is_same_rail(verdict.rail_angle, other.rail_angle);
      });
      if (!verdict.departures.empty() && !is_said) found.push_back(std::move(verdict));
    }
  }
  return found;
}

std::optional<RowVerdict> row_verdict(const ComparisonRow& row) {
  for (const Judgement* judgement : {&judgements[0], &judgements[1]})
    if (const Departure departure = judgement->departure(row); std::isfinite(departure.value))
      return RowVerdict{departure, judgement->reference};
  return std::nullopt;
}

}  // namespace asperity
