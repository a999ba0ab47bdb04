#include "surfaces/fftw_parts.h"

#include "core/error.h"

namespace asperity {

std::mutex& fftw_planner() {
  static std::mutex mutex;
  return mutex;
}

FftwPlan::FftwPlan(fftw_plan plan) : plan_(plan) {
  if (!plan_)
    throw WorkError("FFTW could not plan a transform; try a number of pixels with small prime factors");
}

FftwPlan::~FftwPlan() {
  if (!plan_) return;
  const std::lock_guard<std::mutex> lock(fftw_planner());
  fftw_destroy_plan(plan_);
}

FftwPlan plan_to_complex(int n) {
  const std::lock_guard<std::mutex> lock(fftw_planner());
  const auto in = fftw_reals(n);
  const auto out = fftw_complexes(n / 2 + 1);
  return FftwPlan(fftw_plan_dft_r2c_1d(n, in.get(), out.get(), FFTW_ESTIMATE));
}

FftwPlan plan_to_real(int n) {
  const std::lock_guard<std::mutex> lock(fftw_planner());
  const auto in = fftw_complexes(n / 2 + 1);
  const auto out = fftw_reals(n);
  return FftwPlan(fftw_plan_dft_c2r_1d(n, in.get(), out.get(), FFTW_ESTIMATE));
}

FftwPlan plan_complex(int n, int sign) {
  const std::lock_guard<std::mutex> lock(fftw_planner());
  const auto buffer = fftw_complexes(n);
  return FftwPlan(fftw_plan_dft_1d(n, buffer.get(), buffer.get(), sign, FFTW_ESTIMATE));
}

}  // namespace asperity
