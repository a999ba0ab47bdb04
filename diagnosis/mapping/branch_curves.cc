#include "diagnosis/mapping/branch_curves.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "diagnosis/mapping/force_curve.h"

namespace asperity {
namespace {

struct Branches {
  ForceCurve loading, unloading;
};

class SolvedDifference : public BranchCorrection {
 public:
  std::vector<Branches> of_protocol;
  std::vector<BranchPlace> place;  ///< by Sample::index
  double displacement_error = 0;
  SurfaceErrors of_surfaces;

  double displacement(const Sample& sample, double force) const override {
    const BranchPlace at = sample.index < place.size() ? place[sample.index] : BranchPlace{};
    const Branches& b = of_protocol[at.protocol];
    return (at.unloading ? b.unloading : b.loading).at(force);
  }
  double error() const override { return displacement_error; }
  const std::vector<std::function<double(double)>>& surface_errors() const override {
    return of_surfaces.each;
  }
  std::function<double(double)> on_surface(const std::vector<double>& factors) const override {
    return of_surfaces.together ? of_surfaces.together(factors) : BranchCorrection::on_surface(factors);
  }
};

/// The reduced law under the forces of a solution.
std::vector<double> reduced_displacements(const Mechanics& reduced, const SolvedResponse& solved) {
  Samples samples;
  for (std::size_t i = 0; i < solved.force.size(); ++i) {
    Sample s;
    s.index = i;
    s.normal_force = solved.force[i];
    samples.list.push_back(s);
  }
  SampleRun run;
  run.end = samples.list.size();
  run.response_is_displacement = true;
  samples.runs.push_back(run);
  return simulate(reduced, samples);
}

Branches branches_of(const SolvedResponse& solved, const Mechanics& reduced) {
  const std::vector<double> by_law = reduced_displacements(reduced, solved);
  Branches b;
  b.loading.add(0, 0);
  for (std::size_t i = 0; i < solved.force.size(); ++i) {
    // Without load the reduced law's displacement is not determined, nor is it asked for.
    if (!(solved.force[i] > 0)) continue;
    const double difference = solved.displacement[i] - by_law[i];
    if (i <= solved.peak) b.loading.add(solved.force[i], difference);
    if (i >= solved.peak) b.unloading.add(solved.force[i], difference);
  }
  b.loading.finish();
  b.unloading.finish();
  if (solved.peak + 1 >= solved.force.size()) b.unloading = b.loading;  // nothing yields: it comes back on it
  return b;
}

double load_of(const SampleRun& run, const Sample& s) {
  return run.response_is_displacement ? s.normal_force : s.normal_displacement;
}

/// A stretch of a run up to a load above all former ones and back from it.
struct Excursion {
  std::size_t begin = 0, peak = 0, end = 0;
  bool returns = false;
};

std::vector<Excursion> excursions_of(const SampleRun& run, const Samples& samples) {
  constexpr double noise = 0.02;  // of the run's range: less is no return
  double least = load_of(run, samples.list[run.begin]), most = least;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    least = std::min(least, load_of(run, samples.list[i]));
    most = std::max(most, load_of(run, samples.list[i]));
  }
  std::vector<Excursion> found{{run.begin, run.begin, run.end, false}};
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const double load = load_of(run, samples.list[i]);
    Excursion& now = found.back();
    const double top = load_of(run, samples.list[now.peak]);
    if (load > top) {
      if (now.returns) {
        now.end = i;
        found.push_back({i, i, run.end, false});
      } else {
        now.peak = i;
      }
    } else if (load < top - noise * (most - least)) {
      now.returns = true;
    }
  }
  return found;
}

/// Force at a turning point: single samples are noisy, the middle of those around it is less so.
double force_around(const SampleRun& run, const Samples& samples, std::size_t peak) {
  constexpr std::size_t around = 2;
  std::vector<double> near;
  for (std::size_t i = std::max(run.begin + around, peak) - around; i < std::min(run.end, peak + around + 1);
       ++i) {
    const Sample& s = samples.list[i];
    if (run.response_is_displacement || s.counts)
      near.push_back(run.response_is_displacement ? s.normal_force : s.response);
  }
  std::sort(near.begin(), near.end());
  return near.empty() ? 0 : near[near.size() / 2];
}

}  // namespace

RecordedProtocols protocols_of(const Samples& samples) {
  constexpr double same = 0.05;
  RecordedProtocols found;
  std::vector<Excursion> excursions;
  std::vector<double> forces;
  for (const auto& run : samples.runs) {
    if (run.independent_rows)
      throw InputError(
          "a case is solved for traces only: this recording holds a series of single loads; record approach "
          "and force along loading, or leave out --case");
    double of_run = 0;
    for (const Excursion& excursion : excursions_of(run, samples)) {
      excursions.push_back(excursion);
      forces.push_back(force_around(run, samples, excursion.peak));
      of_run = std::max(of_run, forces.back());
    }
    if (!(of_run > 0))
      throw InputError(
          "a run of the recording is not pressed at all, so that no case can be solved for it; leave it out");
  }
  std::vector<std::size_t> order(forces.size());
  for (std::size_t e = 0; e < order.size(); ++e) order[e] = e;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return forces[a] > forces[b]; });
  found.of_sample.resize(samples.list.size());
  for (const std::size_t e : order) {
    // Out of contact a swing is none of the contact's.
    const bool presses = forces[e] > same * (found.list.empty() ? 0 : found.list.front().largest_force);
    if (presses && (found.list.empty() || forces[e] < (1 - same) * found.list.back().largest_force))
      found.list.push_back({forces[e], false});
    const std::size_t protocol = found.list.size() - 1;
    if (presses && excursions[e].returns) found.list.back().unloads = true;
    for (std::size_t i = excursions[e].begin; i < excursions[e].end; ++i)
      found.of_sample[i] = {protocol, presses && excursions[e].returns && i > excursions[e].peak};
  }
  return found;
}

SolvedReach reach_of(const SolvedResponse& solved) {
  if (solved.ended_early.empty()) return {std::numeric_limits<double>::infinity(), true};
  double largest = 0;
  for (const double force : solved.force) largest = std::max(largest, force);
  return {largest, false};
}

Samples solved_part(const Samples& samples, const RecordedProtocols& protocols,
                    const std::vector<SolvedResponse>& solved) {
  Samples part = samples;
  for (const auto& run : samples.runs)
    for (std::size_t i = run.begin; i < run.end; ++i) {
      Sample& s = part.list[i];
      const BranchPlace at = protocols.of_sample[s.index];
      const SolvedReach reach = reach_of(solved[at.protocol]);
      const double force = run.response_is_displacement ? s.normal_force : s.response;
      if (force > reach.force || (at.unloading && !reach.unloaded)) s.counts = false;
    }
  return part;
}

SurfaceErrors surface_errors_of(const OtherSurfaces& surfaces) {
  SurfaceErrors errors;
  if (surfaces.changes.empty()) return errors;
  const std::vector<double>& force = surfaces.changes.front().force;
  const auto forces = static_cast<Eigen::Index>(force.size()),
             changes = static_cast<Eigen::Index>(surfaces.changes.size());
  Eigen::MatrixXd all(forces, changes);
  for (Eigen::Index k = 0; k < changes; ++k)
    all.col(k) = Eigen::Map<const Eigen::VectorXd>(
        surfaces.changes[static_cast<std::size_t>(k)].displacement.data(), forces);
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(all / std::sqrt(static_cast<double>(changes)),
                                                Eigen::ComputeThinU);
  constexpr double nothing = 1e-3;  // of the largest
  const Eigen::VectorXd& sizes = parts.singularValues();
  std::vector<ForceCurve> curves;
  for (Eigen::Index k = 0; k < sizes.size() && sizes[k] > nothing * sizes[0]; ++k) {
    ForceCurve curve;
    curve.add(0, 0);
    for (Eigen::Index i = 0; i < forces; ++i)
      curve.add(force[static_cast<std::size_t>(i)], sizes[k] * parts.matrixU()(i, k));
    curve.finish();
    errors.each.push_back([curve](double f) { return f > 0 ? curve.at(f) : 0.0; });
    curves.push_back(std::move(curve));
  }
  const double unseen = surfaces.unseen;
  errors.each.push_back([unseen](double) { return unseen; });
  errors.together = [curves = std::move(curves), unseen](const std::vector<double>& factors) {
    return [all = ForceCurve::sum(curves, factors), zero = factors[curves.size()] * unseen](double f) {
      return zero + (f > 0 ? all.at(f) : 0.0);
    };
  };
  return errors;
}

std::shared_ptr<const BranchCorrection> difference_to(const std::vector<SolvedResponse>& solved,
                                                      const RecordedProtocols& protocols,
                                                      const Mechanics& reduced, double displacement_error,
                                                      SurfaceErrors surface_errors) {
  auto difference = std::make_shared<SolvedDifference>();
  difference->displacement_error = displacement_error;
  for (const SolvedResponse& response : solved) {
    difference->of_protocol.push_back(branches_of(response, reduced));
    if (std::isfinite(response.displacement_error))
      difference->displacement_error = std::max(difference->displacement_error, response.displacement_error);
  }
  difference->place = protocols.of_sample;
  difference->of_surfaces = std::move(surface_errors);
  return difference;
}

}  // namespace asperity
