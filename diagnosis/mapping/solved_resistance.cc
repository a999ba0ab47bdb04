#include "diagnosis/mapping/solved_resistance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/shear_moduli.h"

namespace asperity {
namespace {

/// Loads that are solved at most, and the part by which loads that count as one differ.
constexpr std::size_t most_loads = 3;
constexpr double same_load = 0.05;

/// Factors on a law, or errors, at some forces, straight in the logarithm of the force, as at the last one
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

bool have_same_roughness(double one, double other) {
  constexpr double rounding = 1e-3;
  return std::abs(one - other) <= rounding * std::abs(one);
}

/// The factors of one surface.
struct SurfaceFactors {
  std::optional<double> rms;  ///< none: the only one
  Factors limit, stiffness;
  Factors error;  ///< of what was solved [N]
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

/// Samples of one load.
struct RecordedLoad {
  double normal_force = 0;  ///< mean [N]
  double resistance = 0;    ///< largest lateral force, of either direction [N]
};

/// Roughness of each surface that was moved over, the smoothest first; of a single one, none.
std::vector<std::optional<double>> recorded_surfaces(const Samples& samples) {
  std::vector<double> all;
  for (const Sample& s : samples.list) all.push_back(s.rms_roughness);
  std::sort(all.begin(), all.end());
  std::vector<std::optional<double>> different;
  for (const double rms : all)
    if (different.empty() || !have_same_roughness(*different.back(), rms)) different.push_back(rms);
  if (different.size() == 1) different.front().reset();
  return different;
}

/// Groups of recorded loads within 5 %, the largest first.
std::vector<RecordedLoad> recorded_loads(const Samples& samples, double largest,
                                         const std::optional<double>& rms) {
  constexpr double pressed = 0.02;  // of the largest force
  std::vector<std::pair<double, double>> forces;
  for (const Sample& s : samples.list)
    if (s.counts && s.normal_force > pressed * largest &&
        (!rms || have_same_roughness(*rms, s.rms_roughness)))
      forces.push_back({s.normal_force, std::abs(s.response)});
  std::sort(forces.rbegin(), forces.rend());
  std::vector<RecordedLoad> loads;
  for (std::size_t from = 0, to = 0; from < forces.size(); from = to) {
    RecordedLoad load;
    for (; to < forces.size() && forces[to].first > (1 - same_load) * forces[from].first; ++to) {
      load.normal_force += forces[to].first;
      load.resistance = std::max(load.resistance, forces[to].second);
    }
    load.normal_force /= static_cast<double>(to - from);
    loads.push_back(load);
  }
  return loads;
}

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

/// What the law's resistance is to be multiplied by on one surface.
Factors limit_factors(const std::vector<SolvedMotion>& motions, const Mechanics& reduced) {
  InterpolatedDifference difference(reduced.experiment.mode);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const SolvedMotion& motion : motions) {
    difference.add(motion.normal_force,
                   motion.resistance - steady_resistance(reduced, motion, motion.normal_force));
    least = std::min(least, motion.normal_force), most = std::max(most, motion.normal_force);
  }
  Factors factors;
  if (motions.empty()) return factors;
  difference.solve();
  constexpr int parts = 32;
  const int count = most > least ? parts : 0;
  for (int i = 0; i <= count; ++i) {
    const double force = count == 0 ? most : least * std::pow(most / least, static_cast<double>(i) / parts),
                 by_law = steady_resistance(reduced, motions.front(), force);
    if (by_law > 0) factors.add(force, 1 + difference.at(force) / by_law);
  }
  return factors;
}

double lateral_stiffness(const Experiment& e, double normal_force) {
  return 8 * reduced_shear_modulus(e.particle, e.substrate) * e.hertz().contact_radius(normal_force);
}

/// Those that are solved, of one surface.
std::vector<RecordedLoad> chosen_loads(std::vector<RecordedLoad> loads) {
  if (loads.size() > most_loads) {
    const double middle = std::sqrt(loads.front().normal_force * loads.back().normal_force);
    const auto distance = [&](const RecordedLoad& load) {
      return std::abs(std::log(load.normal_force / middle));
    };
    const auto nearest = std::min_element(
        loads.begin(), loads.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    loads = {loads.front(), *nearest, loads.back()};
  }
  return loads;
}

/// On which all of a contact slips. Mindlin (1949): gross slip begins at 3 mu f/(16 G* a) = 1.5 mu f/k_l.
double sliding_path(const Experiment& e, const RecordedLoad& load, bool is_smooth) {
  constexpr double of_onset = 4, of_radius = 1;
  const double force = load.normal_force, friction = std::max(e.case_friction * force, load.resistance),
               path = of_onset * 1.5 * friction / lateral_stiffness(e, force);
  // Asperities that climb and fall average out over a path that renews them.
  return is_smooth ? path : std::max(path, of_radius * e.hertz().contact_radius(force));
}

/// The edge that opens has been in contact after one radius; two diameters of steady path follow, as in the
/// default of a case.
double rolling_path(const Experiment& e, const RecordedLoad& load) {
  constexpr double of_radius = 5;
  return of_radius * e.hertz().contact_radius(load.normal_force);
}

}  // namespace

std::vector<MotionProtocol> motion_protocols_of(const FitProblem& problem, bool is_smooth) {
  const Experiment& e = problem.experiment;
  for (const Sample& sample : problem.samples.list)
    if (sample.rail_angle != 0)
      throw InputError(
          "the recording rolls in a groove, and a case has one contact on a plane; leave out --case");
  std::vector<MotionProtocol> protocols;
  for (const auto& rms : recorded_surfaces(problem.samples))
    for (const RecordedLoad& load : chosen_loads(recorded_loads(problem.samples, e.largest_force, rms))) {
      double path = 0;
      if (e.mode == Motion::sliding) path = sliding_path(e, load, is_smooth);
      if (e.mode == Motion::rolling) path = rolling_path(e, load);
      protocols.push_back({e.mode, load.normal_force, path, rms});
    }
  if (protocols.empty())
    throw InputError("no sample of the recording motions under a load, so that no case can be solved for it");
  return protocols;
}

std::vector<MotionProtocol> at_solved_loads(std::vector<MotionProtocol> asked,
                                            const std::vector<MotionProtocol>& solved) {
  constexpr double near = 1.5;  // factor of the load
  std::vector<MotionProtocol> taken;
  for (MotionProtocol& one : asked) {
    const auto distance = [&](const MotionProtocol& other) {
      return std::abs(std::log(other.normal_force / one.normal_force));
    };
    const auto nearest = std::min_element(solved.begin(), solved.end(), [&](const auto& a, const auto& b) {
      return distance(a) < distance(b);
    });
    if (!one.substrate_rms && nearest != solved.end() && distance(*nearest) < std::log(near)) {
      one.normal_force = nearest->normal_force;
      one.solved_in = nearest->solved_in;
    }
    if (taken.empty() || taken.back().substrate_rms != one.substrate_rms ||
        taken.back().normal_force != one.normal_force)
      taken.push_back(one);
  }
  return taken;
}

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
    SurfaceFactors factors{motions[from].substrate_rms, limit_factors(of_surface, reduced), {}, {}};
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
