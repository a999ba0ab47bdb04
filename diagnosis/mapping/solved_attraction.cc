#include "diagnosis/mapping/solved_attraction.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace asperity {
namespace {

/// Force [N] by which a solution differs from a reduced law, over the displacement [m].
class ForceOverApproach {
 public:
  void add(double displacement, double force) { points_.emplace_back(displacement, force); }
  void finish() {
    std::stable_sort(points_.begin(), points_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  double at(double displacement) const {
    if (points_.empty()) return 0;
    if (displacement <= points_.front().first) return points_.front().second;
    if (displacement >= points_.back().first) return points_.back().second;
    const auto after = std::upper_bound(points_.begin(), points_.end(), displacement,
                                        [](double value, const auto& point) { return value < point.first; });
    const auto before = after - 1;
    const double width = after->first - before->first;
    return before->second +
           (width > 0 ? (displacement - before->first) / width * (after->second - before->second) : 0.0);
  }

 private:
  std::vector<std::pair<double, double>> points_;
};

/// What a solution says beyond a reduced law: forces at displacements, and where it opens.
struct ForceDifference {
  ForceOverApproach loading, unloading;
  double opens_later = 0;  ///< displacement at which it parts, minus that of the reduced law [m]
  double loading_off = 0, unloading_off = 0;  ///< of with_attraction_off(): by how much each is off [N]
};

/// By how much the force is off, on loading and on unloading [N].
struct ForceOff {
  double loading = 0, unloading = 0;
};

class SolvedAttraction : public NormalContact {
 public:
  SolvedAttraction(const NormalContact& reduced, std::shared_ptr<const ForceDifference> difference)
      : reduced_(reduced.clone()), difference_(std::move(difference)) {}
  SolvedAttraction(const SolvedAttraction& other)
      : reduced_(other.reduced_->clone()),
        difference_(other.difference_),
        deepest_(other.deepest_),
        touches_(other.touches_) {}
  SolvedAttraction& operator=(const SolvedAttraction&) = delete;
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<SolvedAttraction>(*this); }
  double release() const override { return std::min(0.0, reduced_->parting() + difference_->opens_later); }
  double force(double d) const override {
    if (d < (touches_ ? release() : 0.0)) return 0;
    const double beyond = d >= deepest_ ? difference_->loading.at(d) + difference_->loading_off
                                        : difference_->unloading.at(d) + difference_->unloading_off;
    return reduced_->held_force(d) + beyond;
  }
  void begin_step(double time_step) override { reduced_->begin_step(time_step); }
  void accept(double d) override {
    touches_ = d >= (touches_ ? release() : 0.0);
    deepest_ = touches_ ? std::max(deepest_, d) : 0.0;
    if (touches_) reduced_->accept(std::max(d, reduced_->release()));
  }

 private:
  std::unique_ptr<NormalContact> reduced_;
  std::shared_ptr<const ForceDifference> difference_;
  double deepest_ = 0;  ///< largest displacement since they touched [m]
  bool touches_ = false;
};

class AttractionCorrection : public BranchCorrection {
 public:
  AttractionCorrection(std::shared_ptr<const ForceDifference> difference, double error,
                       std::vector<ForceOff> off, double attraction_error)
      : difference_(std::move(difference)),
        error_(error),
        off_(std::move(off)),
        attraction_error_(attraction_error) {}
  double displacement(const Sample&, double) const override { return 0; }
  std::shared_ptr<const NormalContact> contact_for(const NormalContact& reduced) const override {
    return std::make_shared<SolvedAttraction>(reduced, difference_);
  }
  double error() const override { return error_; }
  std::vector<std::shared_ptr<const BranchCorrection>> with_attraction_off() const override {
    std::vector<std::shared_ptr<const BranchCorrection>> all;
    for (const ForceOff& off : off_) {
      auto difference = std::make_shared<ForceDifference>(*difference_);
      difference->loading_off = off.loading;
      difference->unloading_off = off.unloading;
      all.push_back(std::make_shared<AttractionCorrection>(difference, error_, std::vector<ForceOff>{},
                                                           attraction_error_));
    }
    return all;
  }
  double attraction_error() const override { return attraction_error_; }

 private:
  std::shared_ptr<const ForceDifference> difference_;
  double error_;
  std::vector<ForceOff> off_;
  double attraction_error_;
};

/// The discretisation error of the attraction, one standard deviation: that of the pull-off force, and the
/// same part of the strongest pull as it closes. Far beyond first touch the attraction is a constant force,
/// 2/3 (JKR) to 1 (DMT) of the pull-off force: the same error is taken everywhere.
std::vector<ForceOff> attraction_off(const SolvedResponse& solved, bool returns_on_another_curve) {
  if (!(solved.pull_off_error > 0)) return {};
  if (!returns_on_another_curve) return {{solved.pull_off_error, solved.pull_off_error}};
  const auto begin = solved.force.begin(), peak = begin + static_cast<std::ptrdiff_t>(solved.peak) + 1;
  const double closing = std::max(0.0, -*std::min_element(begin, peak)),
               opening = -*std::min_element(begin, solved.force.end());
  std::vector<ForceOff> off{{0, solved.pull_off_error}};
  if (closing > 0) off.push_back({solved.pull_off_error * closing / opening, 0});
  return off;
}

}  // namespace

std::shared_ptr<const BranchCorrection> attraction_of(const SolvedResponse& solved, const Mechanics& reduced,
                                                      double displacement_error,
                                                      bool returns_on_another_curve) {
  const std::unique_ptr<NormalContact> law = reduced.normal.contact->clone();
  if (!(solved.force[solved.peak] > 0))
    throw WorkError("'" + solved.source + "' attracts and never presses; record under larger loads");
  auto difference = std::make_shared<ForceDifference>();
  constexpr double open = 1e-6;  // of the largest force: the solver's tolerance
  const double nothing = open * solved.force[solved.peak];
  double last = solved.displacement[solved.peak];
  for (std::size_t i = 0; i < solved.force.size(); ++i) {
    const double d = solved.displacement[i];
    if (i > solved.peak && std::abs(solved.force[i]) < nothing) {
      difference->opens_later = 0.5 * (last + d) - law->parting();
      break;
    }
    last = d;
    law->accept(std::max(d, law->release()));
    const double beyond = solved.force[i] - law->held_force(d);
    if (i <= solved.peak || !returns_on_another_curve) difference->loading.add(d, beyond);
    if (i >= solved.peak || !returns_on_another_curve) difference->unloading.add(d, beyond);
  }
  difference->loading.finish();
  difference->unloading.finish();
  if (std::isfinite(solved.displacement_error)) displacement_error = solved.displacement_error;
  const double strongest = -*std::min_element(solved.force.begin(), solved.force.end());
  return std::make_shared<AttractionCorrection>(difference, displacement_error,
                                                attraction_off(solved, returns_on_another_curve),
                                                strongest > 0 ? solved.pull_off_error / strongest : 0.0);
}

}  // namespace asperity
