#include "core/machine_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace asperity {
namespace {

TEST(MachineMemory_behaviour, is_what_the_system_calls_available) {
  std::istringstream meminfo(
      "MemTotal:       24604944 kB\nMemFree:          512000 kB\nMemAvailable:   20480000 kB\n");
  EXPECT_EQ(memory_of_meminfo(meminfo), 20480000.0 * 1024);
  std::istringstream without("MemTotal:       24604944 kB\n"), cut("MemAvailable:");
  EXPECT_TRUE(std::isinf(memory_of_meminfo(without)));
  EXPECT_TRUE(std::isinf(memory_of_meminfo(cut)));
}

TEST(MachineMemory_behaviour, is_no_more_than_a_control_group_allows) {
  const auto left = [](const char* largest, const char* statistics) {
    std::istringstream most(largest), taken(statistics);
    return memory_of_group(most, taken);
  };
  EXPECT_EQ(left("1073741824\n", "anon 268435456\nfile 805306368\n"), 805306368);  // files give way
  EXPECT_EQ(left("1000\n", "anon 2000\n"), 0);
  EXPECT_EQ(left("1000\n", ""), 1000);
  EXPECT_TRUE(std::isinf(left("max\n", "anon 268435456\n")));
  EXPECT_TRUE(std::isinf(left("", "")));
  EXPECT_GT(available_memory(), 0);
}

}  // namespace
}  // namespace asperity
