#include "diagnosis/mapping/solved_sliding.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem_compare/laws/shear_moduli.h"

namespace asperity {
namespace {

/// Loads that are solved at most, and the part by which loads that count as one differ.
constexpr std::size_t most_loads = 3;
constexpr double same_load = 0.05;

/// Factors on a law at some forces, straight in the logarithm of the force, as at the last one beyond them.
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

class FrictionDifference : public BranchCorrection {
 public:
  Factors limit, stiffness;
  double relative_error = 0;

  double limit_factor(double force) const override { return limit.at(force); }
  double stiffness_factor(double force) const override { return stiffness.at(force); }
  double error() const override { return relative_error; }
};

/// Samples of one load.
struct RecordedLoad {
  double normal_force = 0;  ///< mean [N]
  double friction = 0;      ///< largest lateral force, of either direction [N]
};

/// Groups of recorded loads within 5 %, the largest first.
std::vector<RecordedLoad> recorded_loads(const Samples& samples, double largest) {
  constexpr double pressed = 0.02;  // of the largest force
  std::vector<std::pair<double, double>> forces;
  for (const Sample& s : samples.list)
    if (s.counts && s.normal_force > pressed * largest)
      forces.push_back({s.normal_force, std::abs(s.response)});
  std::sort(forces.rbegin(), forces.rend());
  std::vector<RecordedLoad> loads;
  for (std::size_t from = 0, to = 0; from < forces.size(); from = to) {
    RecordedLoad load;
    for (; to < forces.size() && forces[to].first > (1 - same_load) * forces[from].first; ++to) {
      load.normal_force += forces[to].first;
      load.friction = std::max(load.friction, forces[to].second);
    }
    load.normal_force /= static_cast<double>(to - from);
    loads.push_back(load);
  }
  return loads;
}

/// The fully developed friction of a law [N].
double steady_friction(const Mechanics& law, double normal_force) {
  Samples samples;
  samples.list.resize(1);
  samples.list.front().normal_force = normal_force;
  samples.list.front().radius = law.experiment.radius;
  SampleRun run;
  run.end = 1;
  run.independent_rows = true;
  samples.runs.push_back(run);
  return simulate(law, samples).front();
}

double lateral_stiffness(const Experiment& e, double normal_force) {
  return 8 * sliding_modulus(e.particle, e.substrate) * e.hertz().contact_radius(normal_force);
}

}  // namespace

std::vector<SlidingProtocol> sliding_protocols_of(const FitProblem& problem, bool is_smooth) {
  const Experiment& e = problem.experiment;
  std::vector<RecordedLoad> loads = recorded_loads(problem.samples, e.largest_force);
  if (loads.empty())
    throw InputError("no sample of the recording slides under a load, so that no case can be solved for it");
  if (loads.size() > most_loads) {
    const double middle = std::sqrt(loads.front().normal_force * loads.back().normal_force);
    const auto distance = [&](const RecordedLoad& load) {
      return std::abs(std::log(load.normal_force / middle));
    };
    const auto nearest = std::min_element(
        loads.begin(), loads.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    loads = {loads.front(), *nearest, loads.back()};
  }
  // Mindlin (1949): gross slip begins at a path of 3 mu f/(16 G* a) = 1.5 mu f/k_l.
  constexpr double of_onset = 4, of_radius = 1;
  std::vector<SlidingProtocol> protocols;
  for (const RecordedLoad& load : loads) {
    const double force = load.normal_force, friction = std::max(e.case_friction * force, load.friction);
    double path = of_onset * 1.5 * friction / lateral_stiffness(e, force);
    // Asperities that climb and fall average out over a path that renews them.
    if (!is_smooth) path = std::max(path, of_radius * e.hertz().contact_radius(force));
    protocols.push_back({force, path});
  }
  return protocols;
}

double friction_error(const std::vector<SolvedSlide>& slides) {
  double largest = 0;
  for (const SolvedSlide& slide : slides)
    if (slide.friction > 0) largest = std::max(largest, slide.friction_error / slide.friction);
  return largest;
}

std::shared_ptr<const BranchCorrection> friction_difference_to(const std::vector<SolvedSlide>& slides,
                                                               const Mechanics& reduced) {
  auto difference = std::make_shared<FrictionDifference>();
  for (const SolvedSlide& slide : slides) {
    const double by_law = steady_friction(reduced, slide.normal_force);
    if (by_law > 0) difference->limit.add(slide.normal_force, slide.friction / by_law);
    if (slide.lateral_stiffness > 0)
      difference->stiffness.add(
          slide.normal_force,
          slide.lateral_stiffness / lateral_stiffness(reduced.experiment, slide.normal_force));
  }
  difference->relative_error = friction_error(slides);
  return difference;
}

}  // namespace asperity
