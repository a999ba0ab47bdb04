// Numbers that tests compare with: tables of the project's own, in the repository, and files of other people,
// beside it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace asperity::test {

/// Folder of the tables below; its README.md says where each comes from.
std::filesystem::path reference_folder();

/// Path of a table of the repository, tests/data/references/NAME. Throws, which fails the test, where it is
/// missing.
std::filesystem::path reference_table(const std::string& name);

/// Path of a file that other people made (scans, recordings, results of other codes) and that the repository
/// does not copy, below the folder named by the environment variable ASPERITY_SHARED, else ../shared beside
/// the repository; empty where it is missing.
std::optional<std::filesystem::path> shared_file(const std::string& relative_path);

}  // namespace asperity::test

/// Defines `variable` as the file's path, or skips the test with one line where the file is missing.
#define ASPERITY_SHARED_FILE_OR_SKIP(variable, relative)                            \
  const auto variable##_found = asperity::test::shared_file(relative);              \
  if (!variable##_found) GTEST_SKIP() << "no " << (relative) << " on this machine"; \
  const std::filesystem::path variable = *variable##_found
