// The fit with its finite elements off by their own error.
#include "diagnosis/fit/model_fit.h"

namespace asperity {

std::shared_ptr<const Explanation> off_by_mesh_error(const ModelFit& fit) {
  class OffByError : public BranchCorrection {
   public:
    explicit OffByError(std::shared_ptr<const BranchCorrection> exact) : exact_(std::move(exact)) {}
    double displacement(const Sample& sample, double force) const override {
      return exact_->displacement(sample, force) + exact_->error();
    }
    double limit_factor(double force) const override {
      return exact_->limit_factor(force) * (1 + exact_->error());
    }
    double stiffness_factor(double force) const override { return exact_->stiffness_factor(force); }
    std::shared_ptr<const NormalContact> contact_for(const NormalContact& reduced) const override {
      return exact_->contact_for(reduced);
    }
    double error() const override { return exact_->error(); }

   private:
    std::shared_ptr<const BranchCorrection> exact_;
  };
  return fit.explanation->with(std::make_shared<OffByError>(fit.explanation->correction()));
}

}  // namespace asperity
