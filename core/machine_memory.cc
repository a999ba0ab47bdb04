#include "core/machine_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace asperity {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

}  // namespace

double available_memory() {
  std::ifstream meminfo("/proc/meminfo"), largest("/sys/fs/cgroup/memory.max"),
      current("/sys/fs/cgroup/memory.current");
  return std::min(memory_of_meminfo(meminfo), memory_of_group(largest, current));
}

double memory_of_meminfo(std::istream& meminfo) {
  constexpr double kibibyte = 1024;
  for (std::string entry; meminfo >> entry;) {
    double amount = 0;
    if (entry == "MemAvailable:" && meminfo >> amount) return kibibyte * amount;
  }
  return unknown;
}

double memory_of_group(std::istream& largest, std::istream& current) {
  double most = 0, taken = 0;  // without a limit memory.max says "max"
  return largest >> most && current >> taken ? std::max(0.0, most - taken) : unknown;
}

}  // namespace asperity
