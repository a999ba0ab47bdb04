#include "diagnosis/mapping/solved_resistance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "diagnosis/mapping/motion_protocols.h"

namespace asperity {
namespace {

/// Factors on a law, or forces, at some forces, straight in the logarithm of the force, as at the last one
/// beyond them.
class Factors {
 public:
  void add(double force, double factor) {
    points_.push_back({std::log(force), factor});
    std::sort(points_.begin(), points_.end());
  }
  double at(double force) const {
    if (points_.empty()) return 1;
    if (!(force > 0)) return points_.front().second;
    const double x = std::log(force);
    if (x <= points_.front().first) return points_.front().second;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const auto& [from, low] = points_[i - 1];
      const auto& [to, high] = points_[i];
      if (x < to) return low + (x - from) / (to - from) * (high - low);
    }
    return points_.back().second;
  }

 private:
  std::vector<std::pair<double, double>> points_;
};

/// The factors of one surface.
struct SurfaceFactors {
  std::optional<double> rms;  ///< none: the only one
  Factors limit, stiffness;
  Factors offset, error;  ///< of what was solved [N]
};

class ResistanceDifference : public BranchCorrection {
 public:
  std::vector<SurfaceFactors> surfaces;
  double relative_error = 0, relative_stiffness_error = 0;

  double limit_factor(const Sample& sample) const override { return at(sample, &SurfaceFactors::limit); }
  double stiffness_factor(const Sample& sample) const override {
    return at(sample, &SurfaceFactors::stiffness);
  }
  double error() const override { return relative_error; }
  double limit_offset(const Sample& sample) const override { return at(sample, &SurfaceFactors::offset, 0); }
  double limit_error(const Sample& sample) const override { return at(sample, &SurfaceFactors::error, 0); }
  double stiffness_error() const override { return relative_stiffness_error; }

 private:
  double at(const Sample& sample, Factors SurfaceFactors::*of, double without = 1) const {
    const auto own = std::find_if(surfaces.begin(), surfaces.end(), [&](const SurfaceFactors& surface) {
      return !surface.rms || have_same_roughness(*surface.rms, sample.rms_roughness);
    });
    return own == surfaces.end() ? without : ((*own).*of).at(sample.normal_force);
  }
};

Sample sample_of(const Mechanics& law, const SolvedMotion& motion, double normal_force) {
  Sample sample;
  sample.normal_force = normal_force;
  sample.radius = law.experiment.radius;
  sample.rms_roughness = motion.substrate_rms.value_or(0);
  return sample;
}

/// The fully developed resistance of a law [N].
double steady_resistance(const Mechanics& law, const SolvedMotion& motion, double normal_force) {
  Samples samples;
  samples.list = {sample_of(law, motion, normal_force)};
  SampleRun run;
  run.end = 1;
  run.independent_rows = true;
  samples.runs.push_back(run);
  return simulate(law, samples).front();
}

/// Through the differences D(f) between solution and law at up to three loads: a share of the load, of the
/// contact's area, or of rolling of its radius, and a force; of torsion of load times radius, of the load,
/// and a moment. Of two loads without the last, of one the first alone. Exact where local friction, a shear
/// strength, attraction or its hysteresis differ.
class InterpolatedDifference {
 public:
  explicit InterpolatedDifference(Motion motion) {
    constexpr double load = 1, radius = 1.0 / 3;  // exponents of the load
    if (motion == Motion::rolling)
      exponents_ = {load, radius, 0};
    else if (motion == Motion::torsion)
      exponents_ = {load + radius, load, 0};
    else
      exponents_ = {load, 2 * radius, 0};
  }
  void add(double force, double difference) {
    forces_.push_back(force);
    differences_.push_back(difference);
  }
  void solve() {
    const auto n = static_cast<Eigen::Index>(forces_.size());
    Eigen::MatrixXd terms(n, n);
    Eigen::VectorXd values(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto row = terms_at(forces_[static_cast<std::size_t>(i)]);
      for (Eigen::Index k = 0; k < n; ++k) terms(i, k) = row[static_cast<std::size_t>(k)];
      values(i) = differences_[static_cast<std::size_t>(i)];
    }
    shares_ = terms.colPivHouseholderQr().solve(values);
  }
  double at(double force) const {
    const auto terms = terms_at(force);
    double sum = 0;
    for (Eigen::Index k = 0; k < shares_.size(); ++k) sum += shares_(k) * terms[static_cast<std::size_t>(k)];
    return sum;
  }

 private:
  std::array<double, 3> terms_at(double force) const {
    const double relative = force / forces_.front();
    return {std::pow(relative, exponents_[0]), std::pow(relative, exponents_[1]),
            std::pow(relative, exponents_[2])};
  }
  std::array<double, 3> exponents_{};  ///< of the load
  std::vector<double> forces_, differences_;
  Eigen::VectorXd shares_;
};

/// What was solved may all be the mesh's: it says nothing of what a law of the contact is off by.
bool is_noise(const std::vector<SolvedMotion>& motions) {
  return std::any_of(motions.begin(), motions.end(),
                     [](const SolvedMotion& motion) { return motion.resistance_error >= motion.resistance; });
}

/// What the law's resistance on one surface is to be multiplied by or, where the solution is noise, what is
/// to be added to it: a factor would weigh what other effects add.
void set_limit(const std::vector<SolvedMotion>& motions, const Mechanics& reduced, SurfaceFactors& factors) {
  InterpolatedDifference difference(reduced.experiment.mode);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const SolvedMotion& motion : motions) {
    difference.add(motion.normal_force,
                   motion.resistance - steady_resistance(reduced, motion, motion.normal_force));
    least = std::min(least, motion.normal_force), most = std::max(most, motion.normal_force);
  }
  difference.solve();
  const bool is_added = is_noise(motions);
  if (!is_added) factors.offset.add(most, 0);
  constexpr int parts = 32;
  const int count = most > least ? parts : 0;
  for (int i = 0; i <= count; ++i) {
    const double force = count == 0 ? most : least * std::pow(most / least, static_cast<double>(i) / parts),
                 by_law = steady_resistance(reduced, motions.front(), force);
    if (is_added)
      factors.offset.add(force, difference.at(force));
    else if (by_law > 0)
      factors.limit.add(force, 1 + difference.at(force) / by_law);
  }
}

}  // namespace

double resistance_error(const std::vector<SolvedMotion>& motions) {
  double largest = 0;
  for (const SolvedMotion& motion : motions)
    if (motion.resistance > 0) largest = std::max(largest, motion.resistance_error / motion.resistance);
  return largest;
}

double rolling_coefficient(const std::vector<SolvedMotion>& motions, const Mechanics& attraction) {
  constexpr double least_part = 1e-3;  // of the resistance: a law of a share of the load needs one
  const SolvedMotion& largest = motions.front();
  const double by_attraction = steady_resistance(attraction, largest, largest.normal_force) -
                               attraction.lateral.coefficient * largest.normal_force;
  return std::max(largest.resistance - by_attraction, least_part * largest.resistance) / largest.normal_force;
}

std::shared_ptr<const BranchCorrection> resistance_difference_to(const std::vector<SolvedMotion>& motions,
                                                                 const Mechanics& reduced) {
  auto difference = std::make_shared<ResistanceDifference>();
  for (std::size_t from = 0, to = 0; from < motions.size(); from = to) {
    while (to < motions.size() && motions[to].substrate_rms == motions[from].substrate_rms) ++to;
    const std::vector<SolvedMotion> of_surface(motions.begin() + static_cast<std::ptrdiff_t>(from),
                                               motions.begin() + static_cast<std::ptrdiff_t>(to));
    SurfaceFactors factors;
    factors.rms = motions[from].substrate_rms;
    set_limit(of_surface, reduced, factors);
    for (const SolvedMotion& motion : of_surface) {
      factors.error.add(motion.normal_force, motion.resistance_error);
      if (!(motion.lateral_stiffness > 0)) continue;
      difference->relative_stiffness_error = std::max(
          difference->relative_stiffness_error, motion.lateral_stiffness_error / motion.lateral_stiffness);
      const double pressed =
          motion.normal_force + offset_at(reduced.lateral, sample_of(reduced, motion, motion.normal_force));
      factors.stiffness.add(motion.normal_force,
                            motion.lateral_stiffness / lateral_stiffness(reduced.experiment, pressed));
    }
    difference->surfaces.push_back(std::move(factors));
  }
  difference->relative_error = resistance_error(motions);
  return difference;
}

}  // namespace asperity
