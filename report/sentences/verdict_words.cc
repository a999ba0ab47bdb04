#include "report/sentences/verdict_words.h"

#include <algorithm>
#include <cmath>

#include "core/printed.h"
#include "core/quantity.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

/// At most one decimal, but as many as tell the number from the tolerance that it is judged by.
std::string percent_with_sd(double value, double sd, double tolerance) {
  const double number = per_cent * std::abs(value), doubt = per_cent * sd, limit = per_cent * tolerance;
  constexpr double whole_percents_from = 9.95;
  constexpr int most_decimals = 6;
  int decimals = number < whole_percents_from && !(doubt >= whole_percents_from) ? 1 : 0;
  const auto rounded = [&](double percent) { return std::round(percent * std::pow(10, decimals)); };
  while (decimals < most_decimals && number != limit && rounded(number) == rounded(limit)) ++decimals;
  return std::isfinite(sd) ? printed("%.*f ± %.*f %%", decimals, number, decimals, doubt)
                           : printed("%.*f %%", decimals, number);
}

/// "12 ± 3 %"; beyond a factor of two "a factor of 9.8".
std::string amount(double value, double sd, double tolerance) {
  const double over = 1 + value;
  if (over <= 0 || (over >= 0.5 && over <= 2)) return percent_with_sd(value, sd, tolerance);
  const double factor = over > 1 ? over : 1 / over, factor_sd = sd * (over > 1 ? 1 : factor * factor);
  if (!std::isfinite(sd)) return printed("a factor of %.3g", factor);
  return printed(factor_sd < 9.5 ? "a factor of %.3g ± %.1g" : "a factor of %.0f ± %.0f", factor, factor_sd);
}

/// A range of judged departures, with what is said of it.
struct Block {
  const std::vector<Departure>& all;
  JudgedRange range;
  double tolerance;

  const Departure& first() const { return all[range.first]; }
  const Departure& last() const { return all[range.last]; }
  std::string amount_of(const Departure& departure) const {
    return amount(departure.value, departure.sd, tolerance);
  }
  std::string place() const;
  std::string signed_amounts() const;
  std::string amount_and_place() const;
};

/// Its loads.
std::string Block::place() const {
  return range.first == range.last
             ? "at " + force_text(first().load)
             : say("from {} to {}", {force_text(first().load), force_text(last().load)});
}

/// "too much by 2.0 ± 6.0 %", at both ends of several loads.
std::string Block::signed_amounts() const {
  const auto said = [&](const Departure& departure) {
    return (departure.value < 0 ? "too little by " : "too much by ") + amount_of(departure) +
           (departure.mesh_error != 0
                ? say(", and {} from the mesh", {percent_with_sd(departure.mesh_error, NAN, tolerance)})
                : "");
  };
  return said(first()) + (range.first == range.last ? "" : ", " + said(last()));
}

/// Mean over the loads, or both ends where it changes by more than its uncertainty and a quarter of itself;
/// and where.
std::string Block::amount_and_place() const {
  double low = INFINITY, high = -INFINITY, value = 0, sd = 0;
  const auto count = static_cast<double>(range.last - range.first + 1);
  for (std::size_t i = range.first; i <= range.last; ++i) {
    low = std::min(low, all[i].value), high = std::max(high, all[i].value);
    value += all[i].value / count, sd += all[i].sd / count;
  }
  constexpr double even = 0.25;
  if (high - low <= std::max(std::isfinite(sd) ? 2 * sd : 0, even * std::abs(value)))
    return say("by {} {}", {amount(value, sd, tolerance), place()});
  const bool is_everywhere = range.first == 0 && range.last + 1 == all.size();
  return say("{}by {} at {} and {} at {}",
             {is_everywhere ? "" : place() + ", ", amount_of(first()), force_text(first().load),
              amount_of(last()), force_text(last().load)});
}

}  // namespace

std::string within_text(double tolerance) { return printed("within %.3g %%", per_cent * tolerance); }

std::string rail_words(double angle) {
  return std::isnan(angle) ? "" : printed(" at %.0f deg", angle / unit_factor("deg", Dimension::angle));
}

std::string departure_words(const std::vector<Departure>& departures, const std::string& quantity,
                            double tolerance) {
  const std::string within = within_text(tolerance);
  std::string text;
  for (const JudgedRange& range : judged_ranges(departures, tolerance)) {
    const Block block{departures, range, tolerance};
    const bool is_first = text.empty();
    text += is_first ? "" : "; ";
    if (range.judged == Judged::within)
      text += say("{}{} {}", {is_first ? "gives the " + quantity + " " : "", within, block.place()});
    else if (range.judged == Judged::not_known)
      text += say(is_first ? "may or may not give the " + quantity + " {} {} ({})"
                           : "whether {} is not known {} ({})",
                  {within, block.place(), block.signed_amounts()});
    else
      text += say("{} {} {}", {range.is_above ? "overstates" : "understates",
                               is_first ? "the " + quantity : "it", block.amount_and_place()});
  }
  return text;
}

std::string verdict_text(const LawVerdict& verdict, double tolerance) {
  const std::string quantity = say("{}{} of the {}", {display_of(verdict.quantity).words,
                                                      rail_words(verdict.rail_angle), verdict.reference});
  const bool has_error =
      std::any_of(verdict.departures.begin(), verdict.departures.end(),
                  [](const Departure& departure) { return std::isfinite(departure.half_width()); });
  std::string text =
      verdict.law + (verdict.is_own_fit
                         ? say(" repeats the {}: its numbers were fitted to it.", {quantity})
                         : " " + departure_words(verdict.departures, quantity, tolerance) + "." +
                               (has_error ? "" : " How far it is uncertain is not known."));
  if (verdict.discretisation_error)
    text += say(" The mesh alone leaves {} in doubt at {}.",
                {percent_with_sd(verdict.discretisation_error->second, NAN, tolerance),
                 force_text(verdict.discretisation_error->first)});
  return text;
}

std::string good_words(const LawVerdict& verdict) {
  const LoadRange& all = verdict.compared;
  if (verdict.is_own_fit) return "its numbers were fitted to it";
  const bool is_open = verdict.good.empty() && verdict.not_known > 0;
  if (all.low == all.high)
    return say("{}at {}, the only load compared", {is_open                ? "not known "
                                                   : verdict.good.empty() ? "not "
                                                                          : "",
                                                   force_text(all.low)});
  const std::string compared = say("{} to {}", {force_text(all.low), force_text(all.high)});
  if (verdict.good.empty())
    return say("{} ({})", {!is_open              ? "at no load compared"
                           : verdict.outside > 0 ? "at no load for which it is known"
                                                 : "not known at any load compared",
                           compared});
  std::string text;
  for (const auto& range : verdict.good) {
    if (range.reaches_lowest && range.reaches_highest) return say("at all loads compared ({})", {compared});
    const std::string low = force_text(range.low), high = force_text(range.high);
    text += (text.empty() ? "" : ", and ") + (range.low == range.high ? "at " + low
                                              : range.reaches_lowest  ? "up to " + high
                                              : range.reaches_highest ? "from " + low + " on"
                                                                      : low + " to " + high);
  }
  return say("{} (compared: {})", {text, compared});
}

std::string row_verdict_text(const ComparisonRow& row, double tolerance) {
  const auto verdict = row_verdict(row);
  if (!verdict) return "";
  const Departure& departure = verdict->departure;
  const std::string reference =
      std::string(" against ") + (*verdict->reference == 'm' ? "the " : "") + verdict->reference;
  const Judged own = judged(departure.value, departure.half_width(), tolerance);
  if (own == Judged::within) return "good " + within_text(tolerance) + reference;
  return say("{}{} by {}{}", {own == Judged::not_known ? "not known " + within_text(tolerance) + ": " : "",
                              departure.value > 0 ? "overstates" : "understates",
                              amount(departure.value, departure.sd, tolerance), reference});
}

std::string engine_sentence(const SideBySide& comparison) {
  if (comparison.engine.empty() || !comparison.engine_failure.empty()) return "";
  double worst = 0;
  int count = 0;
  const ComparisonRow* where = nullptr;
  for (const auto& row : comparison.rows) {
    const double departure = std::abs(engine_over_law(row) - 1);
    if (!std::isfinite(departure)) continue;
    ++count;
    if (departure >= worst) worst = departure, where = &row;
  }
  if (!where) return comparison.engine + " was asked for nothing that it could be compared in.\n";
  constexpr double asked = 0.01;  // of an engine against its own law
  return say(
      "{}{} gives what it was told within {} % in {} lines (farthest: {} at {}){}.\n",
      {comparison.engine, comparison.engine_version.empty() ? "" : " (" + comparison.engine_version + ")",
       printed("%.2g", per_cent * worst), std::to_string(count), display_of(where->quantity).words,
       force_text(where->load),
       worst > asked ? ": more than the 1 % asked of an engine; look at its input in the folder engine"
                     : ""});
}

}  // namespace asperity::report
