#include "tests/support/shared_files.h"

#include <cstdlib>

namespace asperity::test {

std::optional<std::filesystem::path> shared_file(const std::string& relative_path) {
  const char* folder = std::getenv("ASPERITY_SHARED");
  const std::filesystem::path root = folder ? std::filesystem::path(folder) : std::filesystem::path(ASPERITY_SOURCE_DIR) / ".." / "shared";
  std::filesystem::path path = root / relative_path;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

}  // namespace asperity::test
