// Reference solutions and measurements that lie beside the repository and are not part of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace asperity::test {

/// Path of a file below the folder of references (environment variable ASPERITY_SHARED, else ../shared beside the
/// repository); empty where it is missing.
std::optional<std::filesystem::path> shared_file(const std::string& relative_path);

}  // namespace asperity::test

/// Defines `variable` as the file's path, or skips the test with one line where the file is missing.
#define ASPERITY_SHARED_FILE_OR_SKIP(variable, relative)                          \
  const auto variable##_found = asperity::test::shared_file(relative);            \
  if (!variable##_found) GTEST_SKIP() << "no " << (relative) << " on this machine"; \
  const std::filesystem::path variable = *variable##_found
