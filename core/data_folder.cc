#include "core/data_folder.h"

namespace asperity {

namespace fs = std::filesystem;

fs::path data_folder(const fs::path& name, const fs::path& in_source) {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (failed) return in_source;
  const fs::path installed = program.parent_path().parent_path() / "share" / "asperity" / name;
  return fs::exists(installed, failed) ? installed : in_source;
}

}  // namespace asperity
