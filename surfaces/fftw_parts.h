// Buffers and plans of FFTW that free themselves. Plans are serial and may be executed by several threads at
// once on buffers of their own; FFTW_ESTIMATE: the choice of algorithm, and with it the rounding, does not
// depend on timing.
#pragma once

#include <fftw3.h>

#include <memory>
#include <mutex>

namespace asperity {

/// Deleter for FFTW's buffers.
struct FreeFftw {
  void operator()(void* buffer) const { fftw_free(buffer); }
};
using FftwComplexes = std::unique_ptr<fftw_complex[], FreeFftw>;
using FftwReals = std::unique_ptr<double[], FreeFftw>;

/// Buffers of n numbers, aligned as FFTW likes them, not set to zero.
inline FftwComplexes fftw_complexes(int n) { return FftwComplexes(fftw_alloc_complex(n)); }
inline FftwReals fftw_reals(int n) { return FftwReals(fftw_alloc_real(n)); }

/// FFTW may be executed, but not planned, by several threads at once.
std::mutex& fftw_planner();

/// One plan, destroyed under the planner's lock.
class FftwPlan {
 public:
  /// Takes over a plan, made while fftw_planner() was held. Throws WorkError where there is none.
  explicit FftwPlan(fftw_plan plan);
  FftwPlan(FftwPlan&& other) noexcept : plan_(other.plan_) { other.plan_ = nullptr; }
  FftwPlan(const FftwPlan&) = delete;
  FftwPlan& operator=(const FftwPlan&) = delete;
  ~FftwPlan();
  fftw_plan get() const { return plan_; }

 private:
  fftw_plan plan_;
};

/// n real numbers to n/2 + 1 complex ones, and back.
FftwPlan plan_to_complex(int n);
FftwPlan plan_to_real(int n);
/// n complex numbers in place; sign: FFTW_FORWARD or FFTW_BACKWARD.
FftwPlan plan_complex(int n, int sign);

}  // namespace asperity
