// libFuzzer's entry: the reader named by the environment variable ASPERITY_FUZZ_TARGET (tests/fuzz/run sets
// it).
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets.h"

namespace {

const asperity::fuzz::Target& chosen_target() {
  static const std::vector<asperity::fuzz::Target> all = asperity::fuzz::targets();
  const char* name = std::getenv("ASPERITY_FUZZ_TARGET");
  for (const auto& target : all)
    if (name && target.name == name) return target;
  std::fprintf(stderr, "set ASPERITY_FUZZ_TARGET to one of:");
  for (const auto& target : all) std::fprintf(stderr, " %s", target.name.c_str());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const asperity::fuzz::Target& target = chosen_target();
  target.run(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
