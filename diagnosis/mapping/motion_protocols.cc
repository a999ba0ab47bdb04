#include "diagnosis/mapping/motion_protocols.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/shear_moduli.h"

namespace asperity {

bool have_same_roughness(double one, double other) {
  constexpr double rounding = 1e-3;
  return std::abs(one - other) <= rounding * std::abs(one);
}

double lateral_stiffness(const Experiment& e, double normal_force) {
  return 8 * reduced_shear_modulus(e.particle, e.substrate) * e.hertz().contact_radius(normal_force);
}

namespace {

/// Loads that are solved at most, and the part by which loads that count as one differ.
constexpr std::size_t most_loads = 3;
constexpr double same_load = 0.05;

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

/// The contact that was pressed has been left after a diameter; two of steady path follow, as in the default
/// of a case.
double rolling_path(const Experiment& e, const RecordedLoad& load) {
  constexpr double of_radius = 6;
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

}  // namespace asperity
