#include "dem_compare/compare/verdict.h"

#include <algorithm>
#include <cstdio>

#include "core/quantity.h"
#include "dem_compare/numbers/judged.h"

namespace asperity {
namespace {

std::string force(double load) { return format_quantity(load, Dimension::force, 3); }

std::string within_text(double tolerance) {
  char text[32];
  std::snprintf(text, sizeof text, "within %.3g %%", 100 * tolerance);
  return text;
}

/// At most one decimal, but as many as tell the number from the tolerance that it is judged by.
std::string percent_with_sd(double value, double sd, double tolerance) {
  const double number = 100 * std::abs(value), doubt = 100 * sd;
  char text[64];
  constexpr double whole_percents_from = 9.95;
  constexpr int most_decimals = 6;
  int decimals = number < whole_percents_from && !(doubt >= whole_percents_from) ? 1 : 0;
  const auto rounded = [&](double percent) { return std::round(percent * std::pow(10, decimals)); };
  while (decimals < most_decimals && number != 100 * tolerance && rounded(number) == rounded(100 * tolerance))
    ++decimals;
  if (std::isfinite(sd))
    std::snprintf(text, sizeof text, "%.*f ± %.*f %%", decimals, number, decimals, doubt);
  else
    std::snprintf(text, sizeof text, "%.*f %%", decimals, number);
  return text;
}

/// "12 ± 3 %"; beyond a factor of two "a factor of 9.8".
std::string amount(const Departure& departure, double tolerance) {
  const double over = 1 + departure.value;
  if (over > 2 || (over > 0 && over < 0.5)) {
    const double factor = over > 1 ? over : 1 / over, sd = departure.sd * (over > 1 ? 1 : factor * factor);
    char text[64];
    if (std::isfinite(sd))
      std::snprintf(text, sizeof text, sd < 9.5 ? "a factor of %.3g ± %.1g" : "a factor of %.0f ± %.0f",
                    factor, sd);
    else
      std::snprintf(text, sizeof text, "a factor of %.3g", factor);
    return text;
  }
  return percent_with_sd(departure.value, departure.sd, tolerance);
}

/// 0: within the tolerance; 1, -1: too much, too little; not_told: its errors reach across the tolerance.
constexpr int not_told = 2;

/// Neighbouring loads with the same judgement.
struct Stretch {
  int sign = 0;
  std::size_t first = 0, last = 0;
};

int judgement(const Departure& departure, double tolerance) {
  switch (judged(departure.value, departure.half_width(), tolerance)) {
    case Judged::within:
      return 0;
    case Judged::outside:
      return departure.value > 0 ? 1 : -1;
    default:
      return not_told;
  }
}

std::vector<Stretch> stretches(const std::vector<Departure>& departures, double tolerance) {
  std::vector<Stretch> found;
  for (std::size_t i = 0; i < departures.size(); ++i) {
    const int sign = judgement(departures[i], tolerance);
    if (found.empty() || found.back().sign != sign)
      found.push_back({sign, i, i});
    else
      found.back().last = i;
  }
  return found;
}

double mean(const std::vector<Departure>& departures, const Stretch& stretch, double Departure::*member) {
  double sum = 0;
  for (std::size_t i = stretch.first; i <= stretch.last; ++i) sum += departures[i].*member;
  return sum / static_cast<double>(stretch.last - stretch.first + 1);
}

/// Mean over the stretch, or both ends where it changes by more than its uncertainty and a quarter of itself;
/// and where.
std::string amount_and_place(const std::vector<Departure>& departures, const Stretch& stretch,
                             const std::string& place, double tolerance) {
  const auto [low, high] =
      std::minmax_element(departures.begin() + static_cast<std::ptrdiff_t>(stretch.first),
                          departures.begin() + static_cast<std::ptrdiff_t>(stretch.last) + 1,
                          [](const auto& a, const auto& b) { return a.value < b.value; });
  const Departure average{0, mean(departures, stretch, &Departure::value),
                          mean(departures, stretch, &Departure::sd)};
  const double spread = high->value - low->value, doubt = std::isfinite(average.sd) ? 2 * average.sd : 0;
  constexpr double even = 0.25;
  if (spread <= std::max(doubt, even * std::abs(average.value)))
    return "by " + amount(average, tolerance) + " " + place;
  const Departure &first = departures[stretch.first], &last = departures[stretch.last];
  const bool is_everywhere = stretch.first == 0 && stretch.last + 1 == departures.size();
  return (is_everywhere ? "" : place + ", ") + "by " + amount(first, tolerance) + " at " + force(first.load) +
         " and " + amount(last, tolerance) + " at " + force(last.load);
}

/// "too much by 2.0 ± 6.0 %", at both ends of a stretch of several loads.
std::string signed_amounts(const std::vector<Departure>& departures, const Stretch& stretch,
                           double tolerance) {
  std::string text;
  for (const std::size_t i : {stretch.first, stretch.last}) {
    if (i == stretch.last && stretch.last == stretch.first && !text.empty()) break;
    const Departure& departure = departures[i];
    text += (text.empty() ? "" : ", ") +
            std::string(departure.value < 0 ? "too little by " : "too much by ") +
            amount(departure, tolerance);
    if (departure.mesh_error != 0)
      text += ", and " + percent_with_sd(departure.mesh_error, NAN, tolerance) + " from the mesh";
  }
  return text;
}

/// The loads of a stretch.
std::string place(const std::vector<Departure>& departures, const Stretch& stretch) {
  const std::string first = force(departures[stretch.first].load),
                    last = force(departures[stretch.last].load);
  return stretch.first == stretch.last ? "at " + first : "from " + first + " to " + last;
}

/// What is judged, and by what.
struct Judgement {
  const char *judged, *reference;  ///< columns; a law goes by its own name
  const ComparedValue& (*value)(const ComparisonRow&);
  const ComparedValue& (*by)(const ComparisonRow&);
};
const ComparedValue& finite_elements_of(const ComparisonRow& row) { return row.finite_elements; }
const ComparedValue& reduced_law_of(const ComparisonRow& row) { return row.reduced_law; }
const ComparedValue& published_of(const ComparisonRow& row) { return row.published; }
constexpr Judgement judgements[] = {
    {"", "finite elements", reduced_law_of, finite_elements_of},
    {"", "measurement", reduced_law_of, published_of},
    {"The finite-element model", "measurement", finite_elements_of, published_of}};

/// The mesh's error goes with the finite elements, whichever side they are on.
template <class Value, class By>
Departure departure_of(const ComparisonRow& row, const Uncertain& over, const Value& value, const By& by) {
  const bool involves_mesh = &value(row) == &row.finite_elements || &by(row) == &row.finite_elements;
  const double error =
      involves_mesh && std::isfinite(row.finite_elements.mesh_error) ? row.finite_elements.mesh_error : 0;
  return {row.load, over.value - 1, over.sd, error * over.value};
}

std::vector<Departure> departures_of(const std::vector<const ComparisonRow*>& rows,
                                     const Judgement& judgement) {
  std::vector<Departure> departures;
  for (const ComparisonRow* row : rows) {
    const Uncertain over = ratio(judgement.value(*row), judgement.by(*row));
    if (std::isfinite(over.value))
      departures.push_back(departure_of(*row, over, judgement.value, judgement.by));
  }
  std::sort(departures.begin(), departures.end(),
            [](const auto& a, const auto& b) { return a.load < b.load; });
  return departures;
}

constexpr double rounding_of_records = 1e-4;

/// A sentence where the mesh alone is worth more than the tolerance.
std::string mesh_sentence(const std::vector<const ComparisonRow*>& rows, double tolerance) {
  const ComparisonRow* worst = nullptr;
  for (const ComparisonRow* row : rows)
    if (std::abs(row->finite_elements.mesh_error) >
        (worst ? std::abs(worst->finite_elements.mesh_error) : tolerance))
      worst = row;
  if (!worst) return "";
  return " The mesh alone leaves " + percent_with_sd(worst->finite_elements.mesh_error, NAN, tolerance) +
         " in doubt at " + force(worst->load) + ".";
}

bool is_its_own_fit(const std::vector<Departure>& departures) {
  return std::all_of(departures.begin(), departures.end(),
                     [](const auto& departure) { return std::abs(departure.value) < rounding_of_records; });
}

}  // namespace

double Departure::half_width() const {
  return std::isfinite(sd) ? 2 * sd + std::abs(mesh_error) : mesh_error != 0 ? std::abs(mesh_error) : NAN;
}

std::string rail_words(double angle) {
  if (std::isnan(angle)) return "";
  return " at " + std::to_string(std::lround(angle / unit_factor("deg", Dimension::angle))) + " deg";
}

std::string departure_words(const std::vector<Departure>& departures, const std::string& quantity,
                            double tolerance) {
  std::string text;
  bool is_named = false;
  for (const Stretch& stretch : stretches(departures, tolerance)) {
    if (!text.empty()) text += "; ";
    const std::string where = place(departures, stretch), it = is_named ? " it " : " the " + quantity + " ";
    if (stretch.sign == 0) {
      text += (is_named ? "" : "gives the " + quantity + " ") + within_text(tolerance) + " " + where;
    } else if (stretch.sign == not_told) {
      text += is_named ? "whether " + within_text(tolerance) + " is not known " + where
                       : "may or may not give the " + quantity + " " + within_text(tolerance) + " " + where;
      text += " (" + signed_amounts(departures, stretch, tolerance) + ")";
    } else {
      text += (stretch.sign > 0 ? "overstates" : "understates") + it +
              amount_and_place(departures, stretch, where, tolerance);
    }
    is_named = true;
  }
  return text;
}

std::vector<GoodRange> good_ranges(const std::vector<Departure>& departures, double tolerance) {
  std::vector<GoodRange> good;
  for (const Stretch& stretch : stretches(departures, tolerance)) {
    if (stretch.sign != 0) continue;
    GoodRange range;
    range.low = departures[stretch.first].load, range.high = departures[stretch.last].load;
    range.reaches_lowest = stretch.first == 0;
    range.reaches_highest = stretch.last + 1 == departures.size();
    good.push_back(range);
  }
  return good;
}

std::vector<LawVerdict> verdicts(const std::vector<ComparisonRow>& rows, double tolerance) {
  std::vector<LawVerdict> found;
  std::vector<const ComparisonRow*> left;
  for (const auto& row : rows)
    if (row.reduced_law.known()) left.push_back(&row);
  while (!left.empty()) {
    const ComparisonRow& first = *left.front();
    std::vector<const ComparisonRow*> same, others;
    for (const ComparisonRow* row : left) {
      const bool same_rail = std::isnan(first.rail_angle) || row->rail_angle == first.rail_angle;
      (row->contact == first.contact && row->quantity == first.quantity &&
               row->reduced_law.source == first.reduced_law.source && same_rail
           ? same
           : others)
          .push_back(row);
    }
    left = others;
    for (const Judgement& judgement : judgements) {
      const std::vector<Departure> departures = departures_of(same, judgement);
      const std::string judged = *judgement.judged ? judgement.judged : first.reduced_law.source,
                        reference = judgement.reference;
      const bool said = std::any_of(found.begin(), found.end(), [&](const LawVerdict& other) {
        return other.contact == first.contact && other.quantity == first.quantity && other.law == judged &&
               other.reference == reference &&
               (std::isnan(first.rail_angle) || other.rail_angle == first.rail_angle);
      });
      if (departures.empty() || said) continue;
      int outside = 0, not_known = 0;
      for (const auto& departure : departures) {
        const int sign = asperity::judgement(departure, tolerance);
        sign == not_told ? ++not_known : outside += sign != 0;
      }
      const bool has_error = std::any_of(departures.begin(), departures.end(),
                                         [](const auto& d) { return std::isfinite(d.half_width()); });
      const bool involves_finite_elements = *judgement.judged || reference == "finite elements";
      const bool own_fit = reference == "measurement" && is_its_own_fit(departures);
      const std::string quantity =
          display_of(first.quantity).words + rail_words(first.rail_angle) + " of the " + reference;
      found.push_back({first.contact,
                       judged,
                       reference,
                       first.quantity,
                       first.rail_angle,
                       {departures.front().load, departures.back().load},
                       good_ranges(departures, tolerance),
                       outside,
                       not_known,
                       own_fit,
                       judged + " " +
                           (own_fit ? "repeats the " + quantity + ": its numbers were fitted to it."
                                    : departure_words(departures, quantity, tolerance) + "." +
                                          (has_error ? "" : " How far it is uncertain is not known.")) +
                           (involves_finite_elements ? mesh_sentence(same, tolerance) : "")});
    }
  }
  return found;
}

std::string good_words(const LawVerdict& verdict) {
  const LoadRange& all = verdict.compared;
  if (verdict.is_own_fit) return "its numbers were fitted to it";
  const bool is_open = verdict.good.empty() && verdict.not_known > 0;
  if (all.low == all.high)
    return (is_open                ? "not known at "
            : verdict.good.empty() ? "not at "
                                   : "at ") +
           force(all.low) + ", the only load compared";
  const std::string compared = force(all.low) + " to " + force(all.high);
  if (is_open)
    return (verdict.outside > 0 ? "at no load for which it is known (" : "not known at any load compared (") +
           compared + ")";
  if (verdict.good.empty()) return "at no load compared (" + compared + ")";
  std::string words;
  for (const auto& range : verdict.good) {
    if (range.reaches_lowest && range.reaches_highest) return "at all loads compared (" + compared + ")";
    words += words.empty() ? "" : ", and ";
    if (range.low == range.high)
      words += "at " + force(range.low);
    else if (range.reaches_lowest)
      words += "up to " + force(range.high);
    else if (range.reaches_highest)
      words += "from " + force(range.low) + " on";
    else
      words += force(range.low) + " to " + force(range.high);
  }
  return words + " (compared: " + compared + ")";
}

std::string row_verdict(const ComparisonRow& row, double tolerance) {
  for (const auto* reference : {static_cast<const ComparedValue*>(&row.finite_elements), &row.published}) {
    const Uncertain over = ratio(row.reduced_law, *reference);
    if (!std::isfinite(over.value)) continue;
    const bool by_measurement = reference == &row.published;
    const Departure departure =
        departure_of(row, over, reduced_law_of, by_measurement ? published_of : finite_elements_of);
    const std::string of =
        reference == &row.published ? " against the measurement" : " against finite elements";
    const int sign = judgement(departure, tolerance);
    if (sign == 0) return "good " + within_text(tolerance) + of;
    return std::string(sign == not_told ? "not known " + within_text(tolerance) + ": " : "") +
           (departure.value > 0 ? "overstates by " : "understates by ") + amount(departure, tolerance) + of;
  }
  return "";
}

}  // namespace asperity
