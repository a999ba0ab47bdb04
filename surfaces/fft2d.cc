#include "surfaces/fft2d.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "core/error.h"

namespace asperity {
namespace {

constexpr std::size_t worth_sharing = 1u << 18;  // points; below, starting threads costs more than it saves

std::mutex& planner_mutex() {  // FFTW may be executed, but not planned, by several threads at once
  static std::mutex mutex;
  return mutex;
}

struct FreeBuffer {
  void operator()(void* buffer) const { fftw_free(buffer); }
};
template <typename T>
using Buffer = std::unique_ptr<T[], FreeBuffer>;

Buffer<fftw_complex> complex_buffer(int n) { return Buffer<fftw_complex>(fftw_alloc_complex(n)); }
Buffer<double> real_buffer(int n) { return Buffer<double>(fftw_alloc_real(n)); }

class Plan {
 public:
  explicit Plan(fftw_plan plan) : plan_(plan) {
    if (!plan_)
      throw WorkError("FFTW could not plan a transform; try a number of pixels with small prime factors");
  }
  Plan(const Plan&) = delete;
  ~Plan() {
    const std::lock_guard<std::mutex> lock(planner_mutex());
    fftw_destroy_plan(plan_);
  }
  fftw_plan get() const { return plan_; }

 private:
  fftw_plan plan_;
};

// FFTW_ESTIMATE: the choice of algorithm, and with it the rounding, does not depend on timing.
fftw_plan plan_columns(int n, int sign) {
  const std::lock_guard<std::mutex> lock(planner_mutex());
  const auto buffer = complex_buffer(n);
  return fftw_plan_dft_1d(n, buffer.get(), buffer.get(), sign, FFTW_ESTIMATE);
}

/// In-place complex transform along y of each column of the half spectrum.
void transform_columns(HalfSpectrum& spectrum, int columns, int ny, int sign) {
  const Plan plan(plan_columns(ny, sign));
  constexpr int block = 8;  // columns gathered together: one cache line of each row is used whole
#pragma omp parallel if (spectrum.size() > worth_sharing)
  {
    std::vector<Buffer<fftw_complex>> lines;
    for (int b = 0; b < block; ++b) lines.push_back(complex_buffer(ny));
#pragma omp for schedule(static)
    for (int first = 0; first < columns; first += block) {
      const int width = std::min(block, columns - first);
      for (int iy = 0; iy < ny; ++iy)
        for (int b = 0; b < width; ++b) {
          const auto& value = spectrum[static_cast<std::size_t>(iy) * columns + first + b];
          lines[b][iy][0] = value.real();
          lines[b][iy][1] = value.imag();
        }
      for (int b = 0; b < width; ++b) fftw_execute_dft(plan.get(), lines[b].get(), lines[b].get());
      for (int iy = 0; iy < ny; ++iy)
        for (int b = 0; b < width; ++b)
          spectrum[static_cast<std::size_t>(iy) * columns + first + b] = {lines[b][iy][0], lines[b][iy][1]};
    }
  }
}

}  // namespace

HalfSpectrum forward_fft(const std::vector<double>& map, int nx, int ny) {
  const int columns = nx / 2 + 1;
  HalfSpectrum spectrum(static_cast<std::size_t>(columns) * ny);
  {
    const Plan plan([&] {
      const std::lock_guard<std::mutex> lock(planner_mutex());
      const auto in = real_buffer(nx);
      const auto out = complex_buffer(columns);
      return fftw_plan_dft_r2c_1d(nx, in.get(), out.get(), FFTW_ESTIMATE);
    }());
#pragma omp parallel if (map.size() > worth_sharing)
    {
      const auto in = real_buffer(nx);
      const auto out = complex_buffer(columns);
#pragma omp for schedule(static)
      for (int iy = 0; iy < ny; ++iy) {
        std::copy_n(&map[static_cast<std::size_t>(iy) * nx], nx, in.get());
        fftw_execute_dft_r2c(plan.get(), in.get(), out.get());
        for (int ix = 0; ix < columns; ++ix)
          spectrum[static_cast<std::size_t>(iy) * columns + ix] = {out[ix][0], out[ix][1]};
      }
    }
  }
  transform_columns(spectrum, columns, ny, FFTW_FORWARD);
  return spectrum;
}

std::vector<double> inverse_fft(HalfSpectrum&& spectrum, int nx, int ny) {
  const int columns = nx / 2 + 1;
  transform_columns(spectrum, columns, ny, FFTW_BACKWARD);
  std::vector<double> map(static_cast<std::size_t>(nx) * ny);
  const Plan plan([&] {
    const std::lock_guard<std::mutex> lock(planner_mutex());
    const auto in = complex_buffer(columns);
    const auto out = real_buffer(nx);
    return fftw_plan_dft_c2r_1d(nx, in.get(), out.get(), FFTW_ESTIMATE);
  }());
#pragma omp parallel if (map.size() > worth_sharing)
  {
    const auto in = complex_buffer(columns);
    const auto out = real_buffer(nx);
#pragma omp for schedule(static)
    for (int iy = 0; iy < ny; ++iy) {
      for (int ix = 0; ix < columns; ++ix) {
        const auto& value = spectrum[static_cast<std::size_t>(iy) * columns + ix];
        in[ix][0] = value.real();
        in[ix][1] = value.imag();
      }
      fftw_execute_dft_c2r(plan.get(), in.get(), out.get());
      std::copy_n(out.get(), nx, &map[static_cast<std::size_t>(iy) * nx]);
    }
  }
  return map;
}

int fast_fft_length(double n) {
  for (int length = std::max(2, 2 * static_cast<int>(std::ceil(n / 2)));; length += 2) {
    int rest = length;
    for (const int prime : {2, 3, 5})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return length;
  }
}

}  // namespace asperity
