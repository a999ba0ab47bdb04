// How large a text file of measurements may be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

#include "core/error.h"

namespace asperity {

/// Throws InputError for a file of more than 256 MB; `remedy` is what to do about it.
inline void check_file_size(const std::filesystem::path& file, const std::string& remedy) {
  constexpr std::uintmax_t largest = 256u << 20;
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (!error && size > largest)
    throw InputError(file.string() + ": holds " + std::to_string(size >> 20) + " MB, more than the " +
                     std::to_string(largest >> 20) + " MB that are read; " + remedy);
}

}  // namespace asperity
