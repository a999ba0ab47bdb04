#include "dem_compare/compare/verdict.h"

#include <algorithm>
#include <cstdio>

#include "core/quantity.h"

namespace asperity {
namespace {

std::string force(double load) { return format_quantity(load, Dimension::force, 3); }

std::string within_text(double tolerance) {
  char text[32];
  std::snprintf(text, sizeof text, "within %.3g %%", 100 * tolerance);
  return text;
}

/// Two digits of the smaller of number and sd, at most one decimal.
std::string percent_with_sd(double value, double sd) {
  const double number = 100 * std::abs(value), doubt = 100 * sd;
  char text[64];
  constexpr double whole_percents_from = 9.95;
  const int decimals = number < whole_percents_from && !(doubt >= whole_percents_from) ? 1 : 0;
  if (std::isfinite(sd))
    std::snprintf(text, sizeof text, "%.*f ± %.*f %%", decimals, number, decimals, doubt);
  else
    std::snprintf(text, sizeof text, "%.*f %%", decimals, number);
  return text;
}

/// "12 ± 3 %"; beyond a factor of two "a factor of 9.8".
std::string amount(const Departure& departure) {
  const double over = 1 + departure.value;
  if (over > 2 || (over > 0 && over < 0.5)) {
    const double factor = over > 1 ? over : 1 / over, sd = departure.sd * (over > 1 ? 1 : factor * factor);
    char text[64];
    if (std::isfinite(sd))
      std::snprintf(text, sizeof text, sd < 9.5 ? "a factor of %.3g ± %.1g" : "a factor of %.0f ± %.0f", factor, sd);
    else
      std::snprintf(text, sizeof text, "a factor of %.3g", factor);
    return text;
  }
  return percent_with_sd(departure.value, departure.sd);
}

/// Neighbouring loads with the same judgement.
struct Stretch {
  int sign = 0;  ///< 0: within the tolerance
  std::size_t first = 0, last = 0;
};

int judgement(const Departure& departure, double tolerance) {
  return std::abs(departure.value) <= tolerance ? 0 : departure.value > 0 ? 1 : -1;
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

/// Load between two neighbours, one within the tolerance, where it is crossed.
double crossing(const Departure& low, const Departure& high, double tolerance) {
  const double level = (judgement(low, tolerance) + judgement(high, tolerance)) * tolerance;
  const double share = (level - low.value) / (high.value - low.value);
  return low.load * std::pow(high.load / low.load, std::clamp(share, 0.0, 1.0));
}

double mean(const std::vector<Departure>& departures, const Stretch& stretch, double Departure::*member) {
  double sum = 0;
  for (std::size_t i = stretch.first; i <= stretch.last; ++i) sum += departures[i].*member;
  return sum / static_cast<double>(stretch.last - stretch.first + 1);
}

/// Mean over the stretch, or both ends where it changes by more than its uncertainty and a quarter of itself; and where.
std::string amount_and_place(const std::vector<Departure>& departures, const Stretch& stretch, const std::string& place) {
  const auto [low, high] = std::minmax_element(departures.begin() + static_cast<std::ptrdiff_t>(stretch.first),
                                               departures.begin() + static_cast<std::ptrdiff_t>(stretch.last) + 1,
                                               [](const auto& a, const auto& b) { return a.value < b.value; });
  const Departure average{0, mean(departures, stretch, &Departure::value), mean(departures, stretch, &Departure::sd)};
  const double spread = high->value - low->value, doubt = std::isfinite(average.sd) ? 2 * average.sd : 0;
  constexpr double even = 0.25;
  if (spread <= std::max(doubt, even * std::abs(average.value))) return "by " + amount(average) + " " + place;
  const Departure &first = departures[stretch.first], &last = departures[stretch.last];
  const bool is_everywhere = stretch.first == 0 && stretch.last + 1 == departures.size();
  return (is_everywhere ? "" : place + ", ") + "by " + amount(first) + " at " + force(first.load) + " and " + amount(last) +
         " at " + force(last.load);
}

/// Where a stretch lies among all loads.
std::string place(const std::vector<Departure>& departures, const std::vector<Stretch>& all, std::size_t s, double tolerance) {
  const Stretch& stretch = all[s];
  const auto border = [&](std::size_t last) { return force(crossing(departures[last], departures[last + 1], tolerance)); };
  if (all.size() == 1) {
    if (stretch.first == stretch.last) return "at " + force(departures[stretch.first].load);
    return "from " + force(departures[stretch.first].load) + " to " + force(departures[stretch.last].load);
  }
  if (s == 0) return "below " + border(stretch.last);
  if (s + 1 == all.size()) return "above " + border(stretch.first - 1);
  return "from " + border(stretch.first - 1) + " to " + border(stretch.last);
}

/// Between a law that overstates and one that understates lies a load where it is right: a departure of zero is put there.
std::vector<Departure> with_zeros(const std::vector<Departure>& departures, double tolerance) {
  std::vector<Departure> all;
  for (const auto& next : departures) {
    if (!all.empty() && judgement(all.back(), tolerance) * judgement(next, tolerance) < 0) {
      const Departure& last = all.back();
      const double share = last.value / (last.value - next.value);
      all.push_back({last.load * std::pow(next.load / last.load, share), 0, (last.sd + next.sd) / 2});
    }
    all.push_back(next);
  }
  return all;
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
constexpr Judgement judgements[] = {{"", "finite elements", reduced_law_of, finite_elements_of},
                                    {"", "measurement", reduced_law_of, published_of},
                                    {"The finite-element model", "measurement", finite_elements_of, published_of}};

std::vector<Departure> departures_of(const std::vector<const ComparisonRow*>& rows, const Judgement& judgement) {
  std::vector<Departure> departures;
  for (const ComparisonRow* row : rows) {
    const Uncertain over = ratio(judgement.value(*row), judgement.by(*row));
    if (std::isfinite(over.value)) departures.push_back({row->load, over.value - 1, over.sd});
  }
  std::sort(departures.begin(), departures.end(), [](const auto& a, const auto& b) { return a.load < b.load; });
  return departures;
}

constexpr double rounding_of_records = 1e-4;

/// A sentence where the mesh alone is worth more than the tolerance.
std::string mesh_sentence(const std::vector<const ComparisonRow*>& rows, double tolerance) {
  const ComparisonRow* worst = nullptr;
  for (const ComparisonRow* row : rows)
    if (std::abs(row->finite_elements.mesh_error) > (worst ? std::abs(worst->finite_elements.mesh_error) : tolerance))
      worst = row;
  if (!worst) return "";
  return " The mesh alone leaves " + percent_with_sd(worst->finite_elements.mesh_error, NAN) + " in doubt at " +
         force(worst->load) +
         ".";
}

bool is_its_own_fit(const std::vector<Departure>& departures) {
  return std::all_of(departures.begin(), departures.end(),
                     [](const auto& departure) { return std::abs(departure.value) < rounding_of_records; });
}

}  // namespace

std::string rail_words(double angle) {
  if (std::isnan(angle)) return "";
  return " at " + std::to_string(std::lround(angle / unit_factor("deg", Dimension::angle))) + " deg";
}

std::string departure_words(const std::vector<Departure>& compared, const std::string& quantity, double tolerance) {
  const std::vector<Departure> departures = with_zeros(compared, tolerance);
  const std::vector<Stretch> all = stretches(departures, tolerance);
  std::string text;
  std::string verb;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const Stretch& stretch = all[s];
    if (s) text += "; ";
    const std::string where = place(departures, all, s, tolerance);
    if (stretch.sign == 0) {
      text += (s ? "" : "gives the " + quantity + " ") + within_text(tolerance) + " " + where;
    } else {
      text += std::string(stretch.sign > 0 ? "overstates" : "understates") +
              (s && !verb.empty() ? " it " : " the " + quantity + " ") + amount_and_place(departures, stretch, where);
      if (std::abs(mean(departures, stretch, &Departure::value)) < 2 * mean(departures, stretch, &Departure::sd))
        text += " (less than two standard deviations)";
    }
    verb = "said";
  }
  return text;
}

std::vector<GoodRange> good_ranges(const std::vector<Departure>& compared, double tolerance) {
  const std::vector<Departure> departures = with_zeros(compared, tolerance);
  std::vector<GoodRange> good;
  for (const Stretch& stretch : stretches(departures, tolerance)) {
    if (stretch.sign) continue;
    GoodRange range;
    range.reaches_lowest = stretch.first == 0;
    range.reaches_highest = stretch.last + 1 == departures.size();
    range.low = range.reaches_lowest ? departures.front().load
                                     : crossing(departures[stretch.first - 1], departures[stretch.first], tolerance);
    range.high = range.reaches_highest ? departures.back().load
                                       : crossing(departures[stretch.last], departures[stretch.last + 1], tolerance);
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
               other.reference == reference && (std::isnan(first.rail_angle) || other.rail_angle == first.rail_angle);
      });
      if (departures.empty() || said) continue;
      const bool involves_finite_elements = *judgement.judged || reference == "finite elements";
      const bool own_fit = reference == "measurement" && is_its_own_fit(departures);
      const std::string quantity = display_of(first.quantity).words + rail_words(first.rail_angle) + " of the " + reference;
      found.push_back({first.contact,
                       judged,
                       reference,
                       first.quantity,
                       first.rail_angle,
                       {departures.front().load, departures.back().load},
                       good_ranges(departures, tolerance),
                       own_fit,
                       judged + " " +
                           (own_fit ? "repeats the " + quantity + ": its numbers were fitted to it."
                                    : departure_words(departures, quantity, tolerance) + ".") +
                           (involves_finite_elements ? mesh_sentence(same, tolerance) : "")});
    }
  }
  return found;
}

std::string good_words(const LawVerdict& verdict) {
  const LoadRange& all = verdict.compared;
  if (verdict.is_own_fit) return "its numbers were fitted to it";
  if (all.low == all.high) return (verdict.good.empty() ? "not at " : "at ") + force(all.low) + ", the only load compared";
  const std::string compared = force(all.low) + " to " + force(all.high);
  if (verdict.good.empty()) return "at no load compared (" + compared + ")";
  std::string words;
  for (const auto& range : verdict.good) {
    if (range.reaches_lowest && range.reaches_highest) return "at all loads compared (" + compared + ")";
    words += words.empty() ? "" : ", and ";
    if (range.reaches_lowest)
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
    const Departure departure{row.load, over.value - 1, over.sd};
    const std::string of = reference == &row.published ? " against the measurement" : " against finite elements";
    if (judgement(departure, tolerance) == 0) return "good " + within_text(tolerance) + of;
    return (departure.value > 0 ? "overstates by " : "understates by ") + amount(departure) + of;
  }
  return "";
}

}  // namespace asperity
