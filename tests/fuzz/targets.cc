#include "tests/fuzz/targets.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/utf8.h"

namespace asperity::fuzz {
namespace {

namespace fs = std::filesystem;

/// Removed at the end of the process.
struct ScratchFolder {
  fs::path path = (fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) /
                  ("asperity_fuzz_" + std::to_string(::getpid()));
  ScratchFolder() { fs::create_directory(path); }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

}  // namespace

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const auto& some : {topography_targets(), recording_targets(), parameter_targets()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

void expect_utf8(const std::string& text) { expect(is_utf8(text), "text read is UTF-8"); }

FileInMemory::FileInMemory(const std::string& name, const std::string& bytes) {
  static const ScratchFolder scratch;
  folder = scratch.path.string();
  path = folder + "/" + name;
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace asperity::fuzz
