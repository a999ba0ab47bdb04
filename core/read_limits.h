// Limits on memory and time that reading a file may take. docs/surfaces.md says what follows from these
// limits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace asperity::read_limits {

/// Bytes of any file that is read: four times the largest map (16384 x 16384 pixels) in 32 bits.
constexpr std::uint64_t largest_file = std::uint64_t{4} << 30;

/// Bytes of a parameter file (.prm, or JSON of the same); those that ship hold 1 to 6 kB.
constexpr std::uint64_t largest_parameter_file = 1u << 20;

/// Levels of objects and lists in JSON, of subsections in a parameter file; asperity's own files have up to
/// ten.
constexpr std::size_t deepest_nesting = 64;

/// Characters of one line of a table or parameter file: each cell costs more memory than its text.
constexpr std::size_t longest_line = 1u << 18;

/// Bytes that a compressed file may unpack to (its parts together, and its heights at 8 bytes each). Measured
/// maps are packed two to ten times smaller; a flat map of up to 2800 x 2800 points is below the floor,
/// however small its file.
constexpr std::uint64_t most_unpacked(std::uint64_t file_bytes) {
  constexpr std::uint64_t floor = 64u << 20, largest_ratio = 200;
  return std::max(floor, largest_ratio * file_bytes);
}

}  // namespace asperity::read_limits
