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
  double limit_offset(const Sample& sample) const override { return exact_->limit_offset(sample); }
  std::shared_ptr<const NormalContact> contact_for(const NormalContact& reduced) const override {
    return exact_->contact_for(reduced);
  }
  double error() const override { return exact_->error(); }
  double limit_error(const Sample& sample) const override { return exact_->limit_error(sample); }
  double stiffness_error() const override { return exact_->stiffness_error(); }
  double attraction_error() const override { return exact_->attraction_error(); }
  const std::vector<std::function<double(double)>>& surface_errors() const override {
    return exact_->surface_errors();
  }
  std::function<double(double)> on_surface(const std::vector<double>& factors) const override {
    return exact_->on_surface(factors);
  }

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
  double limit_offset(const Sample& sample) const override {
    return exact().limit_offset(sample) + limit_error(sample);
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
class OnSurface : public Around {
 public:
  OnSurface(std::shared_ptr<const BranchCorrection> exact, const std::vector<double>& factors)
      : Around(std::move(exact)), change_(this->exact().on_surface(factors)) {}
  double displacement(const Sample& sample, double force) const override {
    return exact().displacement(sample, force) + change_(force);
  }

 private:
  std::function<double(double)> change_;
};

}  // namespace

std::shared_ptr<const Explanation> on_surface(const Explanation& explanation,
                                              const std::vector<double>& factors) {
  return explanation.with(std::make_shared<OnSurface>(explanation.correction(), factors));
}

std::vector<std::shared_ptr<const Explanation>> off_by_mesh_errors(const ModelFit& fit) {
  const auto& exact = fit.explanation->correction();
  std::vector<std::shared_ptr<const Explanation>> off{
      fit.explanation->with(std::make_shared<OffByError>(exact))};
  if (exact->stiffness_error() > 0)
    off.push_back(fit.explanation->with(std::make_shared<OffByStiffnessError>(exact)));
  for (auto& attraction : exact->with_attraction_off())
    off.push_back(fit.explanation->with(std::move(attraction)));
  return off;
}

}  // namespace asperity
