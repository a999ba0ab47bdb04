#include "fem/output/steady_motion.h"

#include <algorithm>
#include <cmath>

#include "core/steady_motion.h"

namespace asperity::fem {
namespace {

using Column = double HistoryRow::*;

std::vector<double> values_of(const std::vector<HistoryRow>& records, Column column) {
  std::vector<double> values;
  for (const auto& record : records) values.push_back(record.*column);
  return values;
}

/// Steady part of the first leg.
struct Steady {
  MotionRows rows;
  SteadyRows where;
  double path_length() const { return std::abs(rows.position[where.last] - rows.position[where.first]); }
  double mean_force() const {
    return per_path_length(rows.position, work_against_motion(rows.position, rows.resistance), where.first,
                           where.last);
  }
};

Steady steady_part(const std::vector<HistoryRow>& records, Column position, Column resistance,
                   double rolling_radius) {
  Steady steady{
      {values_of(records, position), values_of(records, resistance),
       values_of(records, &HistoryRow::pressure_radius), values_of(records, &HistoryRow::sticking_share),
       rolling_radius, position == &HistoryRow::torsion_angle},
      {}};
  steady.where = steady_rows_of_first_leg(steady.rows);
  return steady;
}

double dissipated_per_path_length(const std::vector<HistoryRow>& records, const Steady& steady) {
  return per_path_length(steady.rows.position, values_of(records, &HistoryRow::dissipated_energy),
                         steady.where.first, steady.where.last);
}

double fluctuation(const Steady& steady) {
  double squares = 0;
  const auto& y = steady.rows.resistance;
  const double direction =
      steady.rows.position[steady.where.last] > steady.rows.position[steady.where.first] ? 1 : -1;
  const double mean = steady.mean_force();
  for (std::size_t i = steady.where.first; i <= steady.where.last; ++i)
    squares += std::pow(direction * y[i] - mean, 2);
  return std::sqrt(squares / static_cast<double>(steady.where.last - steady.where.first));
}

/// Slope of the work that the energy balance leaves open over the angle, by least squares, and its standard
/// error, in squares: what comes and goes along the path is no dissipation.
double unbalanced_per_angle(const std::vector<HistoryRow>& records, const Steady& steady) {
  double largest_work = 0;  // energy_error is over it
  for (const auto& r : records) largest_work = std::max(largest_work, std::abs(r.work));
  const auto [first, last] = steady.where;
  const auto count = static_cast<double>(last - first + 1);
  const auto left_open = [&](std::size_t i) { return records[i].energy_error * largest_work; };
  double mean_angle = 0, mean = 0;
  for (std::size_t i = first; i <= last; ++i)
    mean_angle += records[i].rolling_angle / count, mean += left_open(i) / count;
  double angles = 0, products = 0, squares = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const double angle = records[i].rolling_angle - mean_angle;
    angles += angle * angle;
    products += angle * (left_open(i) - mean);
  }
  const double slope = products / angles;
  for (std::size_t i = first; i <= last; ++i)
    squares += std::pow(left_open(i) - mean - slope * (records[i].rolling_angle - mean_angle), 2);
  return std::hypot(slope, std::sqrt(squares / (count - 2) / angles));
}

}  // namespace

std::optional<SteadyResistance> steady_sliding(const std::vector<HistoryRow>& records) {
  const Steady steady = steady_part(records, &HistoryRow::shift, &HistoryRow::lateral_force, 0);
  if (!steady.where.reached()) return std::nullopt;
  double load = 0;
  for (std::size_t i = steady.where.first; i <= steady.where.last; ++i)
    load += records[i].normal_force / static_cast<double>(steady.where.last - steady.where.first + 1);
  return SteadyResistance{dissipated_per_path_length(records, steady) / load, fluctuation(steady) / load,
                          steady.path_length()};
}

std::optional<SteadyResistance> steady_torsion(const std::vector<HistoryRow>& records) {
  const Steady steady = steady_part(records, &HistoryRow::torsion_angle, &HistoryRow::torsion_moment, 0);
  if (!steady.where.reached()) return std::nullopt;
  return SteadyResistance{dissipated_per_path_length(records, steady), fluctuation(steady),
                          steady.path_length()};
}

std::optional<SteadyResistance> steady_rolling(const std::vector<HistoryRow>& records, double radius) {
  const Steady steady = steady_part(records, &HistoryRow::rolling_angle, &HistoryRow::rolling_moment, radius);
  if (!steady.where.reached()) return std::nullopt;
  return SteadyResistance{steady.mean_force(), fluctuation(steady), steady.path_length()};
}

std::optional<RollingDissipation> rolling_dissipation(const std::vector<HistoryRow>& records, double radius) {
  const Steady steady = steady_part(records, &HistoryRow::rolling_angle, &HistoryRow::rolling_moment, radius);
  if (!steady.where.reached()) return std::nullopt;
  double step = 0;
  const auto& angle = steady.rows.position;
  for (std::size_t i = steady.where.first; i < steady.where.last; ++i)
    step = std::max(step, std::abs(angle[i + 1] - angle[i]) * radius);
  return RollingDissipation{dissipated_per_path_length(records, steady),
                            unbalanced_per_angle(records, steady), step};
}

}  // namespace asperity::fem
