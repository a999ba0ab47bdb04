#include "diagnosis/mapping/solved_attraction.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace asperity {
namespace {

/// What a solution says beyond a reduced law: a force at a displacement, and where it opens.
struct ForceDifference {
  std::vector<std::pair<double, double>> points;  ///< displacement [m], force [N]
  double opens_later = 0;  ///< displacement at which it parts, minus that of the reduced law [m]

  double at(double displacement) const {
    if (displacement <= points.front().first) return points.front().second;
    if (displacement >= points.back().first) return points.back().second;
    const auto after = std::upper_bound(points.begin(), points.end(), displacement,
                                        [](double value, const auto& point) { return value < point.first; });
    const auto before = after - 1;
    const double width = after->first - before->first;
    return before->second +
           (width > 0 ? (displacement - before->first) / width * (after->second - before->second) : 0.0);
  }
};

class SolvedAttraction : public NormalContact {
 public:
  SolvedAttraction(const NormalContact& reduced, std::shared_ptr<const ForceDifference> difference)
      : reduced_(reduced.clone()), difference_(std::move(difference)) {}
  SolvedAttraction(const SolvedAttraction& other)
      : reduced_(other.reduced_->clone()), difference_(other.difference_), touches_(other.touches_) {}
  SolvedAttraction& operator=(const SolvedAttraction&) = delete;
  std::unique_ptr<NormalContact> clone() const override { return std::make_unique<SolvedAttraction>(*this); }
  double release() const override { return std::min(0.0, reduced_->parting() + difference_->opens_later); }
  double force(double d) const override {
    return d < (touches_ ? release() : 0.0) ? 0.0 : reduced_->held_force(d) + difference_->at(d);
  }
  void accept(double d) override {
    touches_ = d >= (touches_ ? release() : 0.0);
    if (touches_) reduced_->accept(std::max(d, reduced_->release()));
  }

 private:
  std::unique_ptr<NormalContact> reduced_;
  std::shared_ptr<const ForceDifference> difference_;
  bool touches_ = false;
};

class AttractionCorrection : public BranchCorrection {
 public:
  AttractionCorrection(std::shared_ptr<const ForceDifference> difference, double error)
      : difference_(std::move(difference)), error_(error) {}
  double displacement(const Sample&, double) const override { return 0; }
  std::shared_ptr<const NormalContact> contact_for(const NormalContact& reduced) const override {
    return std::make_shared<SolvedAttraction>(reduced, difference_);
  }
  double error() const override { return error_; }

 private:
  std::shared_ptr<const ForceDifference> difference_;
  double error_;
};

}  // namespace

std::shared_ptr<const BranchCorrection> attraction_of(const SolvedResponse& solved, const Mechanics& reduced,
                                                      double displacement_error) {
  const std::unique_ptr<NormalContact> law = reduced.normal.contact->clone();
  if (!(solved.force[solved.peak] > 0))
    throw WorkError("'" + solved.source + "' attracts and never presses; record under larger loads");
  law->accept(solved.displacement[solved.peak]);
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
    difference->points.emplace_back(d, solved.force[i] - law->held_force(d));
  }
  std::stable_sort(difference->points.begin(), difference->points.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (std::isfinite(solved.displacement_error)) displacement_error = solved.displacement_error;
  return std::make_shared<AttractionCorrection>(difference, displacement_error);
}

}  // namespace asperity
