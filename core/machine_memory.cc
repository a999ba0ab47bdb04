#include "core/machine_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace asperity {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The number behind a name.
std::optional<double> amount_of(const std::string& name, std::istream& table) {
  double amount = 0;
  for (std::string entry; table >> entry;)
    if (entry == name && table >> amount) return amount;
  return std::nullopt;
}

}  // namespace

double available_memory() {
  std::ifstream meminfo("/proc/meminfo"), largest("/sys/fs/cgroup/memory.max"),
      statistics("/sys/fs/cgroup/memory.stat");
  return std::min(memory_of_meminfo(meminfo), memory_of_group(largest, statistics));
}

double memory_of_meminfo(std::istream& meminfo) {
  constexpr double kibibyte = 1024;
  return kibibyte * amount_of("MemAvailable:", meminfo).value_or(unknown);
}

double memory_of_group(std::istream& largest, std::istream& statistics) {
  double most = 0;  // without a limit memory.max says "max"
  return largest >> most ? std::max(0.0, most - amount_of("anon", statistics).value_or(0)) : unknown;
}

}  // namespace asperity
