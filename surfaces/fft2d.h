// Two-dimensional Fourier transform of real maps whose result does not depend on the number of threads: one
// serial FFTW plan per direction, rows and columns shared out among OpenMP threads.
#pragma once

#include <complex>
#include <vector>

namespace asperity {

/// Half spectrum of a real map: entry [iy * (nx/2 + 1) + ix] belongs to wave numbers (ix, iy or iy - ny).
using HalfSpectrum = std::vector<std::complex<double>>;

/// F(kx, ky) = sum over pixels of f exp(-2 pi i (kx ix/nx + ky iy/ny)), not normalised.
HalfSpectrum forward_fft(const std::vector<double>& map, int nx, int ny);

/// f = sum over all wave numbers of F exp(+2 pi i ...), not normalised; the spectrum is overwritten.
std::vector<double> inverse_fft(HalfSpectrum&& spectrum, int nx, int ny);

/// Signed wave number of index `i` among `n`: i, or i - n in the upper half.
inline int signed_wave_number(int i, int n) { return i <= n / 2 ? i : i - n; }

/// Smallest even number >= n whose prime factors are 2, 3 and 5 (fast transform lengths).
/// n counts points [-].
int fast_fft_length(double n);

}  // namespace asperity
