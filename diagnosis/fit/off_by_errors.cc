// The fit with its finite elements off by what they state of their own error, or on another surface.
#include "diagnosis/fit/model_fit.h"

namespace asperity {
namespace {

/// A correction as it is, for those that change a part of it.
class Around : public BranchCorrection {
 public:
  explicit Around(std::shared_ptr<const BranchCorrection> exact) : exact_(std::move(exact)) {}
  double displacement(const Sample& sample, double force) const override {
    return exact_->displacement(sample, force);
  }
  double limit_factor(const Sample& sample) const override { return exact_->limit_factor(sample); }
  double stiffness_factor(const Sample& sample) const override { return exact_->stiffness_factor(sample); }
  std::shared_ptr<const NormalContact> contact_for(const NormalContact& reduced) const override {
    return exact_->contact_for(reduced);
  }
  double error() const override { return exact_->error(); }
  double stiffness_error() const override { return exact_->stiffness_error(); }

 protected:
  const BranchCorrection& exact() const { return *exact_; }

 private:
  std::shared_ptr<const BranchCorrection> exact_;
};

class OffByError : public Around {
 public:
  using Around::Around;
  double displacement(const Sample& sample, double force) const override {
    return exact().displacement(sample, force) + error();
  }
  double limit_factor(const Sample& sample) const override {
    return exact().limit_factor(sample) * (1 + error());
  }
};

class OffByStiffnessError : public Around {
 public:
  using Around::Around;
  double stiffness_factor(const Sample& sample) const override {
    return exact().stiffness_factor(sample) * (1 + stiffness_error());
  }
};

/// With the displacement of another surface.
class OnOtherSurface : public Around {
 public:
  OnOtherSurface(std::shared_ptr<const BranchCorrection> exact, std::size_t surface)
      : Around(std::move(exact)), surface_(surface) {}
  double displacement(const Sample& sample, double force) const override {
    return exact().displacement(sample, force) + exact().surface_errors()[surface_](force);
  }

 private:
  std::size_t surface_;
};

}  // namespace

std::vector<std::shared_ptr<const Explanation>> off_by_surfaces(const ModelFit& fit) {
  const auto& exact = fit.explanation->correction();
  std::vector<std::shared_ptr<const Explanation>> off;
  for (std::size_t k = 0; k < exact->surface_errors().size(); ++k)
    off.push_back(fit.explanation->with(std::make_shared<OnOtherSurface>(exact, k)));
  return off;
}

std::vector<std::shared_ptr<const Explanation>> off_by_mesh_errors(const ModelFit& fit) {
  const auto& exact = fit.explanation->correction();
  std::vector<std::shared_ptr<const Explanation>> off{
      fit.explanation->with(std::make_shared<OffByError>(exact))};
  if (exact->stiffness_error() > 0)
    off.push_back(fit.explanation->with(std::make_shared<OffByStiffnessError>(exact)));
  return off;
}

}  // namespace asperity
