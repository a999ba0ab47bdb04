#include "surfaces/fft2d.h"

#include <algorithm>
#include <cmath>

#include "surfaces/fftw_parts.h"

namespace asperity {
namespace {

constexpr std::size_t worth_sharing = 1u << 18;  // points; below, starting threads costs more than it saves

/// In-place complex transform along y of each column of the half spectrum.
void transform_columns(HalfSpectrum& spectrum, int columns, int ny, int sign) {
  const FftwPlan plan = plan_complex(ny, sign);
  constexpr int block = 8;  // columns gathered together: one cache line of each row is used whole
#pragma omp parallel if (spectrum.size() > worth_sharing)
  {
    std::vector<FftwComplexes> lines;
    for (int b = 0; b < block; ++b) lines.push_back(fftw_complexes(ny));
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
    const FftwPlan plan = plan_to_complex(nx);
#pragma omp parallel if (map.size() > worth_sharing)
    {
      const auto in = fftw_reals(nx);
      const auto out = fftw_complexes(columns);
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
  const FftwPlan plan = plan_to_real(nx);
#pragma omp parallel if (map.size() > worth_sharing)
  {
    const auto in = fftw_complexes(columns);
    const auto out = fftw_reals(nx);
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
