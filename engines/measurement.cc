#include "engines/measurement.h"

#include <cmath>

#include "core/error.h"

namespace asperity {
namespace {

/// Rows of one leg.
struct Rows {
  std::size_t first = 0, last = 0;  ///< inclusive
};

std::vector<Rows> rows_of_legs(const MotionPlan& plan, const EngineTrace& trace) {
  std::vector<Rows> legs;
  std::size_t row = 0;
  for (std::size_t leg = 0; leg < plan.legs.size(); ++leg) {
    const std::size_t first = row;
    while (row < trace.size() && trace.leg[row] == static_cast<double>(leg)) ++row;
    if (row < first + 2)
      throw WorkError("its trace.csv has " + std::to_string(row - first) + " rows of leg " +
                      std::to_string(leg + 1) + " of " + std::to_string(plan.legs.size()));
    legs.push_back({first, row - 1});
  }
  return legs;
}

/// Least-squares slope of y over x between two rows.
double least_squares_slope(const std::vector<double>& x, const std::vector<double>& y, Rows rows) {
  const double n = static_cast<double>(rows.last - rows.first + 1);
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (std::size_t i = rows.first; i <= rows.last; ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  for (std::size_t i = rows.first; i <= rows.last; ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return xy / xx;
}

/// Mean over the last half of a leg.
double late_mean(const std::vector<double>& values, Rows rows) {
  double sum = 0;
  const std::size_t first = rows.first + (rows.last - rows.first) / 2;
  for (std::size_t i = first; i <= rows.last; ++i) sum += values[i];
  return sum / static_cast<double>(rows.last - first + 1);
}

/// The first part of a leg, as far as the drive moves by `distance`.
Rows beginning(const EngineTrace& trace, Rows rows, double distance) {
  Rows part = rows;
  while (part.last > part.first + 2 && std::abs(trace.drive[part.last] - trace.drive[rows.first]) > distance)
    --part.last;
  return part;
}

/// Angle of rolling [rad] from its rate, by the trapezoidal rule.
std::vector<double> rotation(const EngineTrace& trace) {
  std::vector<double> angle(trace.size(), 0.0);
  for (std::size_t i = 1; i < trace.size(); ++i)
    angle[i] = angle[i - 1] + (trace.time[i] - trace.time[i - 1]) *
                                  (trace.rotation_rate[i] + trace.rotation_rate[i - 1]) / 2;
  return angle;
}

/// Mean over legs.
class LegMean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  int count() const { return count_; }
  double sum() const { return sum_; }
  double mean() const { return sum_ / count_; }

 private:
  double sum_ = 0;
  int count_ = 0;
};

/// Where stiffness is read: before the first limit, with a margin for what inertia leaves.
constexpr double share_of_yield = 0.8;

/// Units of drive and response, and what kind of drive it is.
struct Measured {
  bool is_torque, is_free;
  explicit Measured(Motion type)
      : is_torque(type == Motion::torsion), is_free(type == Motion::rolling || type == Motion::rail) {}
  const char* stiffness_unit() const { return is_torque ? "N m/rad" : "N/m"; }
  const char* response_unit() const { return is_torque ? "N m" : "N"; }
  const char* drive_unit() const { return is_torque ? "rad" : "m"; }
};

/// What the legs show in the mean.
struct LegMeans {
  LegMean plateau, normal_force, approach;  ///< of steady legs
  LegMean reversal;                         ///< slope after it
  LegMean travel_ratio, angle_ratio;        ///< of a free sphere, over the way of the plate
};

LegMeans means_of_legs(const std::vector<Rows>& legs, const MotionPlan& plan, const EngineTrace& trace,
                       const std::vector<double>& angle, const Measured& measured, double first_yield) {
  LegMeans means;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = plan.legs[i];
    const Rows rows = legs[i];
    if (leg.purpose == Leg::Purpose::reversal)
      means.reversal.add(least_squares_slope(trace.drive, trace.response,
                                             beginning(trace, rows, 2 * share_of_yield * first_yield)));
    if (leg.purpose == Leg::Purpose::before_reversal || (measured.is_torque && i > 0)) {
      means.plateau.add(std::abs(late_mean(trace.response, rows)));
      means.normal_force.add(late_mean(trace.normal_force, rows));
      means.approach.add(late_mean(trace.approach, rows));
    }
    if (leg.purpose == Leg::Purpose::travel && measured.is_free) {
      means.travel_ratio.add(least_squares_slope(trace.drive, trace.particle, rows));
      means.angle_ratio.add(least_squares_slope(trace.drive, angle, rows));
    }
  }
  return means;
}

}  // namespace

std::vector<EngineMeasurement> measure(const EngineExperiment& experiment, const MotionPlan& plan,
                                       const EngineTrace& trace) {
  const std::vector<Rows> legs = rows_of_legs(plan, trace);
  const ClosedForm law = closed_form(experiment);
  const Measured measured(experiment.type);
  const std::vector<double> angle = rotation(trace);
  std::vector<EngineMeasurement> found;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (plan.legs[i].purpose != Leg::Purpose::start) continue;
    const Rows part = beginning(trace, legs[i], share_of_yield * law.first_yield);
    found.push_back({"slope at the start", measured.stiffness_unit(),
                     least_squares_slope(trace.drive, trace.response, part), law.slope});
    if (!measured.is_free) continue;
    // Torque balance of the free sphere: R (1 + cos theta) f = K phi.
    const double lever = experiment.substrate.particle.radius * (1 + experiment.rail_cosine());
    found.push_back({"stiffness against rotation", "N m/rad",
                     lever * least_squares_slope(angle, trace.response, part), law.rolling_stiffness});
  }
  const LegMeans means = means_of_legs(legs, plan, trace, angle, measured, law.first_yield);
  if (means.reversal.count() > 0) {
    const double reversal = means.reversal.mean(), plateau = means.plateau.mean();
    found.push_back({"slope after reversal", measured.stiffness_unit(), reversal, law.slope});
    if (!measured.is_free)
      found.push_back(
          {"travel of reversal", measured.drive_unit(), 2 * plateau / reversal, 2 * law.plateau / law.slope});
  }
  if (means.plateau.count() > 0) {
    found.push_back({"plateau", measured.response_unit(), means.plateau.mean(), law.plateau});
    found.push_back({"normal force", "N", means.normal_force.mean(), experiment.load});
    found.push_back({"approach", "m", means.approach.mean(), law.approach});
  }
  if (experiment.type == Motion::rail)  // eq:murail: lateral over normal force, both at one slope
    found.push_back({"rail coefficient", "", means.plateau.sum() / 2 / means.normal_force.sum(),
                     law.plateau / 2 / experiment.load});
  if (means.travel_ratio.count() > 0) {
    const double c = experiment.rail_cosine();
    found.push_back({"way of the sphere over that of the plate", "", means.travel_ratio.mean(), c / (1 + c)});
    found.push_back({"rotation over the way of the plate", "rad/m", means.angle_ratio.mean(), law.rotation});
  }
  return found;
}

const EngineMeasurement& named(const std::vector<EngineMeasurement>& measurements, const std::string& name) {
  for (const auto& measurement : measurements)
    if (measurement.name == name) return measurement;
  throw WorkError("the engine's run has no measurement '" + name + "'");
}

}  // namespace asperity
