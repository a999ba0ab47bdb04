// The fit with its finite elements off by what they state of their own error, or on another surface.
#include "diagnosis/fit/model_fit.h"

namespace asperity {
namespace {

class OffByError : public BranchCorrection {
 public:
  enum class Of { response, stiffness };
  OffByError(std::shared_ptr<const BranchCorrection> exact, Of of)
      : exact_(std::move(exact)),
        error_(of == Of::response ? exact_->error() : 0.0),
        stiffness_error_(of == Of::stiffness ? exact_->stiffness_error() : 0.0) {}
  double displacement(const Sample& sample, double force) const override {
    return exact_->displacement(sample, force) + error_;
  }
  double limit_factor(const Sample& sample) const override {
    return exact_->limit_factor(sample) * (1 + error_);
  }
  double stiffness_factor(const Sample& sample) const override {
    return exact_->stiffness_factor(sample) * (1 + stiffness_error_);
  }
  std::shared_ptr<const NormalContact> contact_for(const NormalContact& reduced) const override {
    return exact_->contact_for(reduced);
  }
  double error() const override { return exact_->error(); }
  double stiffness_error() const override { return exact_->stiffness_error(); }

 private:
  std::shared_ptr<const BranchCorrection> exact_;
  double error_, stiffness_error_;
};

/// The exact one with the displacement of another surface.
class OnOtherSurface : public BranchCorrection {
 public:
  OnOtherSurface(std::shared_ptr<const BranchCorrection> exact, std::size_t surface)
      : exact_(std::move(exact)), surface_(surface) {}
  double displacement(const Sample& sample, double force) const override {
    return exact_->displacement(sample, force) + exact_->surface_errors()[surface_](force);
  }
  double error() const override { return exact_->error(); }

 private:
  std::shared_ptr<const BranchCorrection> exact_;
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
      fit.explanation->with(std::make_shared<OffByError>(exact, OffByError::Of::response))};
  if (exact->stiffness_error() > 0)
    off.push_back(fit.explanation->with(std::make_shared<OffByError>(exact, OffByError::Of::stiffness)));
  return off;
}

}  // namespace asperity
