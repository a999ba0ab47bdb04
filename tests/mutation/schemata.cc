#include "tests/mutation/schemata.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <mutex>
#include <set>
#include <string>

int asperity_active_mutant = -1;

namespace {

void note(const char* file, int number) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  static const testing::TestInfo* last = nullptr;
  static std::set<int> reached;
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  if (test != last) reached.clear(), last = test;
  if (!reached.insert(number).second) return;
  static std::ofstream out(file, std::ios::app);
  out << number << "\t" << (test ? std::string(test->test_suite_name()) + "." + test->name() : "*")
      << std::endl;
}

}  // namespace

bool asperity_mutant_slowly(int number) {
  if (const char* file = std::getenv("ASPERITY_MUTANT_TRACE")) {
    note(file, number);
    return false;
  }
  const char* chosen = std::getenv("ASPERITY_MUTANT");
  asperity_active_mutant = chosen ? std::atoi(chosen) : 0;
  return number == asperity_active_mutant;
}
