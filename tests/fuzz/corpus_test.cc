// The corpus of each fuzz target, and each input that a fuzzer found to be a fault, goes through its reader.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/targets.h"

namespace asperity::fuzz {
namespace {

class FuzzCorpus_regression : public testing::TestWithParam<std::string> {};

TEST_P(FuzzCorpus_regression, is_read_or_refused) {
  const std::vector<Target> all = targets();
  const auto target =
      std::find_if(all.begin(), all.end(), [](const Target& one) { return one.name == GetParam(); });
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(ASPERITY_FUZZ_CORPUS) / GetParam())) {
    std::ifstream stream(entry.path(), std::ios::binary);
    SCOPED_TRACE(entry.path().string());
    EXPECT_NO_THROW(target->run({std::istreambuf_iterator<char>(stream), {}}));
    ++files;
  }
  EXPECT_GE(files, 1) << "no seeds in tests/fuzz/corpus/" << GetParam();
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const auto& target : targets()) names.push_back(target.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Of, FuzzCorpus_regression, testing::ValuesIn(names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace asperity::fuzz
