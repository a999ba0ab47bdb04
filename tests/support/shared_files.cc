#include "tests/support/shared_files.h"

#include <cstdlib>
#include <stdexcept>

namespace asperity::test {
namespace {

const std::filesystem::path source_folder = ASPERITY_SOURCE_DIR;

}  // namespace

std::filesystem::path reference_folder() { return source_folder / "tests" / "data" / "references"; }

std::filesystem::path reference_table(const std::string& name) {
  std::filesystem::path path = reference_folder() / name;
  if (!std::filesystem::exists(path))
    throw std::runtime_error("the reference table " + path.string() + " is missing");
  return path;
}

std::optional<std::filesystem::path> shared_file(const std::string& relative_path) {
  const char* folder = std::getenv("ASPERITY_SHARED");
  const std::filesystem::path root = folder ? std::filesystem::path(folder) : source_folder / ".." / "shared";
  std::filesystem::path path = root / relative_path;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

}  // namespace asperity::test
