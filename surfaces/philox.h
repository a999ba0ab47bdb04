// Counter-based random numbers: Philox4x32-10 (Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy
// as 1, 2, 3", SC11, 2011). A number depends on (key, counter) only, so it is the same whichever thread asks
// for it.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace asperity {

/// Ten Philox rounds: 128 random bits for a counter of 128 bits and a key of 64 bits.
inline std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter, std::uint64_t seed) {
  std::uint32_t key0 = static_cast<std::uint32_t>(seed), key1 = static_cast<std::uint32_t>(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t product1 = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {
        static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key0, static_cast<std::uint32_t>(product1),
        static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key1, static_cast<std::uint32_t>(product0)};
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  return counter;
}

/// Two independent numbers, uniform in (0, 1), that belong to the integer pair (i, j) under `seed`.
inline std::array<double, 2> uniform_pair(std::int32_t i, std::int32_t j, std::uint64_t seed) {
  const auto bits = philox4x32({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), 0, 0}, seed);
  const auto unit = [](std::uint32_t high, std::uint32_t low) {
    const std::uint64_t mantissa = (std::uint64_t{high} << 20) | (low >> 12);  // 52 bits
    return (static_cast<double>(mantissa) + 0.5) * 0x1p-52;
  };
  return {unit(bits[0], bits[1]), unit(bits[2], bits[3])};
}

/// Two independent standard normal numbers that belong to (i, j) under `seed` (Box and Muller 1958).
inline std::array<double, 2> normal_pair(std::int32_t i, std::int32_t j, std::uint64_t seed) {
  const auto [u, v] = uniform_pair(i, j, seed);
  const double radius = std::sqrt(-2.0 * std::log(u)), angle = 2.0 * M_PI * v;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace asperity
