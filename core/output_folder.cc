#include "core/output_folder.h"

#include "core/error.h"

namespace asperity {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  if (fs::exists(fs::symlink_status(folder, error)))
    throw InputError("'" + folder.string() +
                     "' is there already and is no folder; choose another one for the results");
  if (fs::create_directories(folder, error); error)
    throw WorkError("cannot make the folder '" + folder.string() + "': " + error.message() +
                    "; check what is above it and permissions");
}

}  // namespace asperity
